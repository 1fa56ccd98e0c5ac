/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts as an MJCF.
 */

#include "scene_rows.h"
#include "scene_text.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/scene_export.h>

#include <ostream>

namespace pcl_cid {

void
writeMJCF(std::ostream& stream,
          const std::vector<ConvexPart>& parts,
          const SceneDescription& scene)
{
  requireName("the model's name", scene.name);
  stream << xml_declaration << "<mujoco model=\"" << escaped(scene.name)
         << "\">\n  <asset>\n";
  for (std::size_t i = 0; i < parts.size(); ++i)
    stream << "    <mesh name=\"" << partName(i) << "\" file=\""
           << meshReference(i, scene) << "\"/>\n";
  stream << "  </asset>\n  <worldbody>\n";
  const std::string pose = numbers(scene.origin);
  for (std::size_t i = 0; i < parts.size(); ++i)
    stream << "    <geom name=\"" << partName(i) << "\" type=\"mesh\" mesh=\""
           << partName(i) << "\" pos=\"" << pose << "\" rgba=\"" << rgba(i) << "\"/>\n";
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
  format.write = writeMJCF;
  return format;
}

} // namespace pcl_cid
