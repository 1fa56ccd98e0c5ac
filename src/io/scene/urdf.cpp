/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts as a URDF.
 */

#include "primitive_readers.h"
#include "scene_rows.h"
#include "scene_text.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_export.h>

#include <ostream>

namespace pcl_cid {
namespace {

std::string
urdfShape(const HullPrimitive& primitive)
{
  const std::string radius = " radius=\"" + numbers({primitive.radius()}) + "\"";
  switch (primitive.kind) {
  case HullPrimitive::Kind::box:
    return "<box size=\"" + numbers(primitive.extents) + "\"/>";
  case HullPrimitive::Kind::sphere:
    return "<sphere" + radius + "/>";
  default:
    return "<cylinder" + radius + " length=\"" + numbers({primitive.extents.z()}) +
           "\"/>";
  }
}

/** Where a part is, and its shape. */
std::string
urdfGeometry(std::size_t part, const SceneDescription& scene)
{
  const HullPrimitive* primitive = primitiveOf(part, scene, kindsWithoutCapsule());
  const std::string shape =
      primitive ? urdfShape(*primitive)
                : "<mesh filename=\"" + meshReference(part, scene) + "\"/>";
  return "      <origin xyz=\"" +
         numbers(primitive ? primitive->center : scene.origin) + "\" rpy=\"" +
         (primitive ? rollPitchYaw(primitive->axes) : "0 0 0") +
         "\"/>\n      <geometry>" + shape + "</geometry>\n";
}

} // namespace

void
writeURDF(std::ostream& stream,
          const std::vector<ConvexPart>& parts,
          const SceneDescription& scene)
{
  requirePartsName(scene.name);
  requireName("the frame", linkName(scene));
  requireMeshFolder(scene.mesh_folder);
  stream << xml_declaration << "<robot name=\"" << scene.name << "\">\n  <link name=\""
         << escaped(linkName(scene)) << "\">\n";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string name = partName(i, scene.name);
    const std::string geometry = urdfGeometry(i, scene);
    stream << "    <visual name=\"" << name << "\">\n"
           << geometry << "      <material name=\"" << name << "\"><color rgba=\""
           << rgba(i) << "\"/></material>\n    </visual>\n    <collision name=\""
           << name << "\">\n"
           << geometry << "    </collision>\n";
  }
  stream << "  </link>\n</robot>\n";
}

SceneFormat
urdfFormat()
{
  SceneFormat format;
  format.name = "URDF";
  format.option = "urdf";
  format.extensions = {".urdf"};
  format.help = "write a URDF: one link";
  format.refers_to_meshes = true;
  format.names_frame = true;
  format.check = [](const SceneDescription& scene) {
    requireMeshFolder(scene.mesh_folder);
  };
  format.write = writeURDF;
  format.primitives = kindsWithoutCapsule();
  format.read_primitives = readPrimitivesOfURDF;
  return format;
}

} // namespace pcl_cid
