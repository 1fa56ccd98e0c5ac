/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts as a scene of MoveIt.
 */

#include "mesh_readers.h"
#include "primitive_readers.h"
#include "scene_rows.h"
#include "scene_text.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_export.h>

#include <ostream>
#include <string>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

constexpr const char* no_turn = "0 0 0 1\n"; // a quaternion, x y z w

std::string
meshAsText(const TriangleMesh& mesh)
{
  std::string text = "mesh\n" + std::to_string(mesh.vertices.size()) + ' ' +
                     std::to_string(mesh.triangles.size()) + '\n';
  for (const Eigen::Vector3d& vertex : mesh.vertices)
    text += numbers(vertex) + '\n';
  for (const auto& [a, b, c] : mesh.triangles)
    text +=
        std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
  return text;
}

std::string
shapeAsText(const HullPrimitive& primitive)
{
  const std::string name = std::string(nameOf(primitive.kind)) + '\n';
  switch (primitive.kind) {
  case HullPrimitive::Kind::box:
    return name + numbers(primitive.extents) + '\n';
  case HullPrimitive::Kind::sphere:
    return name + numbers({primitive.radius()}) + '\n';
  default:
    return name + numbers({primitive.radius(), primitive.extents.z()}) + '\n';
  }
}

/** Where a part is, and its one shape. */
std::string
moveItGeometry(std::size_t part,
               const std::vector<ConvexPart>& parts,
               const SceneDescription& scene)
{
  const HullPrimitive* primitive = primitiveOf(part, scene, kindsWithoutCapsule());
  if (!primitive)
    return numbers(scene.origin) + '\n' + no_turn + "1\n" +
           meshAsText(meshInScene(parts[part], scene));
  const Eigen::Quaterniond turn(primitive->axes);
  return numbers(primitive->center) + '\n' +
         numbers({turn.x(), turn.y(), turn.z(), turn.w()}) + "\n1\n" +
         shapeAsText(*primitive);
}

} // namespace

void
writeMoveItScene(std::ostream& stream,
                 const std::vector<ConvexPart>& parts,
                 const SceneDescription& scene)
{
  requirePartsName(scene.name);
  stream << scene.name << '\n';
  for (std::size_t i = 0; i < parts.size(); ++i)
    stream << "* " << partName(i, scene.name) << '\n'
           << moveItGeometry(i, parts, scene) << "0 0 0\n"
           << no_turn << rgba(i) << "\n0\n";
  stream << ".\n";
}

SceneFormat
moveItFormat()
{
  SceneFormat format;
  format.name = "MoveIt";
  format.option = "moveit";
  format.extensions = {".scene"};
  format.help = "write a scene in MoveIt's text form";
  format.write = writeMoveItScene;
  format.primitives = kindsWithoutCapsule();
  format.read_primitives = readPrimitivesOfMoveIt;
  format.read_meshes = readMeshesOfMoveIt;
  return format;
}

} // namespace pcl_cid
