/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts as a URDF.
 */

#include "scene_rows.h"
#include "scene_text.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_export.h>

#include <ostream>

namespace pcl_cid {

void
writeURDF(std::ostream& stream,
          const std::vector<ConvexPart>& parts,
          const SceneDescription& scene)
{
  requireName("the robot's name", scene.name);
  requireName("the frame", scene.frame);
  const std::string origin =
      "      <origin xyz=\"" + numbers(scene.origin) + "\" rpy=\"0 0 0\"/>\n";
  stream << xml_declaration << "<robot name=\"" << escaped(scene.name)
         << "\">\n  <link name=\"" << escaped(scene.frame) << "\">\n";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string name = partName(i);
    const std::string geometry = origin + "      <geometry><mesh filename=\"" +
                                 meshReference(i, scene) + "\"/></geometry>\n";
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
  format.write = writeURDF;
  return format;
}

} // namespace pcl_cid
