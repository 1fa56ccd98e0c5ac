/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scenes of parts in every format that the library writes, for other people's parsers.
 */

#include "exported_scene.h"

#include <pcl_cid/io/mesh_export.h>

#include <filesystem>
#include <fstream>

namespace pcl_cid::test {

ExportedScene::ExportedScene(const PartScene& scene, const std::string& format)
: content_(scene)
{
  description_.name = "Room_A1";
  description_.frame = "survey";
  description_.origin = sceneOrigin(scene.parts);
  description_.mesh_folder = "Teile \xC3\xBC & mehr";
  description_.mesh_extension = format;
  std::filesystem::create_directories(inFolder(description_.mesh_folder));
  writeMeshes();
  writeScenes();
}

std::string
ExportedScene::name() const
{
  return content_.name +
         (description_.mesh_extension == ".obj" ? " as obj" : " as stl");
}

void
ExportedScene::writeMeshes() const
{
  std::ofstream obj(file("hulls.obj"));
  writeOBJ(obj, parts(), "hulls.mtl");
  std::ofstream mtl(file("hulls.mtl"));
  writeMTL(mtl, parts());
  std::ofstream ply(file("hulls.ply"), std::ios::binary);
  writePLY(ply, parts());
  std::ofstream stl(file("hulls.stl"), std::ios::binary);
  writeSTL(stl, parts());
  for (std::size_t i = 0; i < parts().size(); ++i) {
    std::ofstream stream(mesh(i), std::ios::binary);
    writePartMesh(stream, parts(), i, description_);
  }
}

void
ExportedScene::writeScenes() const
{
  std::ofstream urdf(file("scene.urdf"));
  writeURDF(urdf, parts(), description_);
  std::ofstream sdf(file("scene.sdf"));
  writeSDF(sdf, parts(), description_);
  std::ofstream mjcf(file("scene.xml"));
  writeMJCF(mjcf, parts(), description_);
  std::ofstream gltf(file("scene.glb"), std::ios::binary);
  writeGLTF(gltf, parts(), description_);
  std::ofstream usd(file("scene.usda"));
  writeUSD(usd, parts(), description_);
  std::ofstream moveit(file("scene.scene"));
  writeMoveItScene(moveit, parts(), description_);
}

const std::vector<PartScene>&
scenesToExport()
{
  static const std::vector<PartScene> scenes = partScenes();
  return scenes;
}

Eigen::AlignedBox3d
boxOf(const TriangleMesh& hull)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : hull.vertices)
    box.extend(vertex);
  return box;
}

Eigen::Vector3d
middleOf(const TriangleMesh& hull)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& vertex : hull.vertices)
    sum += vertex;
  return sum / static_cast<double>(hull.vertices.size());
}

} // namespace pcl_cid::test
