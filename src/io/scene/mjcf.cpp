/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts as an MJCF.
 */

#include "primitive_readers.h"
#include "scene_rows.h"
#include "scene_text.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_export.h>

#include <ostream>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

/** No compiler element with a `meshdir` says so: it would hold for the model that
 *  includes this one, too. */
constexpr const char* about_paths =
    "  <!-- Included in another model, meshes are found from here by MuJoCo 3.\n"
    "       MuJoCo 2 looks for them from the folder, and the meshdir, of that\n"
    "       model: for it, have this one written with a mesh prefix that is\n"
    "       absolute, or as seen from there. -->\n";

/** What MuJoCo calls sizes: halves of lengths. */
std::string
sizeOf(const HullPrimitive& primitive)
{
  switch (primitive.kind) {
  case HullPrimitive::Kind::box:
    return numbers(0.5 * primitive.extents);
  case HullPrimitive::Kind::sphere:
    return numbers({primitive.radius()});
  case HullPrimitive::Kind::cylinder:
    return numbers({primitive.radius(), 0.5 * primitive.extents.z()});
  default:
    return numbers({primitive.radius(), 0.5 * primitive.straightLength()});
  }
}

/** Where a part is, and its shape. */
std::string
mjcfGeometry(std::size_t part, const SceneDescription& scene)
{
  const HullPrimitive* primitive = primitiveOf(part, scene, allKinds());
  if (!primitive)
    return "type=\"mesh\" mesh=\"" + partName(part, scene.name) + "\" pos=\"" +
           numbers(scene.origin) + "\"";
  const Eigen::Quaterniond turn(primitive->axes);
  return std::string("type=\"") + nameOf(primitive->kind) + "\" size=\"" +
         sizeOf(*primitive) + "\" pos=\"" + numbers(primitive->center) + "\" quat=\"" +
         numbers({turn.w(), turn.x(), turn.y(), turn.z()}) + "\"";
}

} // namespace

void
writeMJCF(std::ostream& stream,
          const std::vector<ConvexPart>& parts,
          const SceneDescription& scene)
{
  requirePartsName(scene.name);
  requireMeshFolderForMJCF(scene.mesh_folder);
  stream << xml_declaration << "<mujoco model=\"" << scene.name << "\">\n"
         << about_paths << "  <asset>\n";
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!primitiveOf(i, scene, allKinds()))
      stream << "    <mesh name=\"" << partName(i, scene.name) << "\" file=\""
             << meshReference(i, scene) << "\"/>\n";
  stream << "  </asset>\n  <worldbody>\n";
  for (std::size_t i = 0; i < parts.size(); ++i)
    stream << "    <geom name=\"" << partName(i, scene.name) << "\" "
           << mjcfGeometry(i, scene) << " rgba=\"" << rgba(i) << "\"/>\n";
  stream << "  </worldbody>\n</mujoco>\n";
}

SceneFormat
mjcfFormat()
{
  SceneFormat format;
  format.name = "MJCF";
  format.option = "mjcf";
  format.extensions = {".xml", ".mjcf"};
  format.help = "write an MJCF for MuJoCo";
  format.refers_to_meshes = true;
  format.check = [](const SceneDescription& scene) {
    requireMeshFolderForMJCF(scene.mesh_folder);
  };
  format.write = writeMJCF;
  format.primitives = allKinds();
  format.read_primitives = readPrimitivesOfMJCF;
  return format;
}

} // namespace pcl_cid
