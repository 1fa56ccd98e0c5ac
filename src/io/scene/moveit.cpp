/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts as a scene of MoveIt.
 */

#include "scene_rows.h"
#include "scene_text.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_export.h>

#include <ostream>
#include <string>

namespace pcl_cid {

void
writeMoveItScene(std::ostream& stream,
                 const std::vector<ConvexPart>& parts,
                 const SceneDescription& scene)
{
  constexpr const char* identity = "0 0 0\n0 0 0 1\n"; // position, quaternion x y z w
  requireName("the scene's name", scene.name);
  stream << scene.name << '\n';
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const TriangleMesh mesh = meshInScene(parts[i], scene);
    std::string text = "* " + partName(i) + '\n' + numbers(scene.origin) +
                       "\n0 0 0 1\n1\nmesh\n" + std::to_string(mesh.vertices.size()) +
                       ' ' + std::to_string(mesh.triangles.size()) + '\n';
    for (const Eigen::Vector3d& vertex : mesh.vertices)
      text += numbers(vertex) + '\n';
    for (const auto& [a, b, c] : mesh.triangles)
      text +=
          std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
    stream << text << identity << rgba(i) << "\n0\n";
  }
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
  return format;
}

} // namespace pcl_cid
