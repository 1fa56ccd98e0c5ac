/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Two scenes that are loaded together, for other people's parsers.
 */

#include "composed_scenes.h"

#include <pcl_cid/io/mesh_export.h>

#include <filesystem>
#include <fstream>

namespace pcl_cid::test {

std::string
ComposedScenes::Member::partName(std::size_t part) const
{
  return pcl_cid::partName(part, description.name);
}

ComposedScenes::ComposedScenes(const PartScene& first,
                               const PartScene& second,
                               const std::string& mesh_folder,
                               const std::string& extension,
                               const std::array<std::string, 2>& names)
: members_{{first, {}}, {second, {}}}
{
  for (const char* const name : {"scenes", "meshes"})
    std::filesystem::create_directory(file(name));
  for (std::size_t i = 0; i < members_.size(); ++i) {
    SceneDescription& description = members_[i].description;
    description.name = names[i];
    description.origin = sceneOrigin(members_[i].parts());
    description.mesh_folder = mesh_folder.empty() ? file("meshes") : mesh_folder;
    description.mesh_extension = extension;
    write(members_[i]);
  }
}

void
ComposedScenes::write(const Member& member) const
{
  const SceneDescription& description = member.description;
  for (std::size_t i = 0; i < member.parts().size(); ++i) {
    std::ofstream mesh(file("meshes/" + partFileName(i, description)),
                       std::ios::binary);
    writePartMesh(mesh, member.parts(), i, description);
  }
  std::ofstream urdf(file("scenes/" + description.name + ".urdf"));
  writeURDF(urdf, member.parts(), description);
  std::ofstream sdf(file("scenes/" + description.name + ".sdf"));
  writeSDF(sdf, member.parts(), description);
  if (description.mesh_folder.find("://") != std::string::npos)
    return;
  std::ofstream mjcf(file("scenes/" + description.name + ".xml"));
  writeMJCF(mjcf, member.parts(), description);
}

} // namespace pcl_cid::test
