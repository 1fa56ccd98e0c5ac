/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts as an SDF.
 */

#include "base/sentence.h"
#include "scene_rows.h"
#include "scene_text.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_export.h>

#include <ostream>

namespace pcl_cid {

void
requireFrameForSDF(const std::string& frame)
{
  requireName("the frame", frame);
  const bool has_underscores = frame.size() >= 4 && frame.substr(0, 2) == "__" &&
                               frame.substr(frame.size() - 2) == "__";
  if (frame == "world" || has_underscores || frame.find("::") != std::string::npos)
    throw CIDException(
        sentence("the frame is '",
                 frame,
                 "'; SDF reserves 'world', '__NAME__' and '::', choose another name"));
}

void
writeSDF(std::ostream& stream,
         const std::vector<ConvexPart>& parts,
         const SceneDescription& scene)
{
  requireName("the model's name", scene.name);
  requireFrameForSDF(scene.frame);
  const std::string pose = "        <pose>" + numbers(scene.origin) + " 0 0 0</pose>\n";
  stream << xml_declaration << "<sdf version=\"1.9\">\n  <model name=\""
         << escaped(scene.name) << "\">\n    <static>true</static>\n    <link name=\""
         << escaped(scene.frame) << "\">\n";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string name = partName(i);
    const std::string geometry = pose + "        <geometry><mesh><uri>" +
                                 meshReference(i, scene) + "</uri></mesh></geometry>\n";
    const std::string color = rgba(i);
    stream << "      <visual name=\"" << name << "\">\n"
           << geometry << "        <material><ambient>" << color
           << "</ambient><diffuse>" << color
           << "</diffuse></material>\n      </visual>\n      <collision name=\"" << name
           << "\">\n"
           << geometry << "      </collision>\n";
  }
  stream << "    </link>\n  </model>\n</sdf>\n";
}

SceneFormat
sdfFormat()
{
  SceneFormat format;
  format.name = "SDF";
  format.option = "sdf";
  format.extensions = {".sdf"};
  format.help = "write an SDF 1.9: a static model";
  format.refers_to_meshes = true;
  format.names_frame = true;
  format.check = [](const SceneDescription& scene) { requireFrameForSDF(scene.frame); };
  format.write = writeSDF;
  return format;
}

} // namespace pcl_cid
