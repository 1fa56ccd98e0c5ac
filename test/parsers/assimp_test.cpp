/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Meshes opened by assimp, which rviz, MoveIt and many viewers read meshes with.
 */

#include "exported_scene.h"
#include "hulls.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_formats.h>

#include <fstream>
#include <map>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** Each directed edge once, and once the other way round. */
void
expectClosed(const aiMesh& mesh)
{
  std::map<std::pair<unsigned int, unsigned int>, int> edges;
  for (unsigned int i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    ASSERT_EQ(face.mNumIndices, 3u);
    for (unsigned int k = 0; k < 3; ++k)
      ++edges[{face.mIndices[k], face.mIndices[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
}

/** Volume by the divergence theorem: positive when the triangles face outward. */
double
volumeOf(const aiMesh& mesh)
{
  const auto corner = [&](const aiFace& face, unsigned int k) {
    const aiVector3D& v = mesh.mVertices[face.mIndices[k]];
    return Eigen::Vector3d(v.x, v.y, v.z);
  };
  const aiVector3D& first = mesh.mVertices[0];
  const Eigen::Vector3d reference(first.x, first.y, first.z);
  double volume = 0.0;
  for (unsigned int i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    const Eigen::Vector3d a = corner(face, 0) - reference;
    const Eigen::Vector3d b = corner(face, 1) - reference;
    const Eigen::Vector3d c = corner(face, 2) - reference;
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

class AssimpTest : public testing::Test {
protected:
  const aiScene&
  open(const std::string& path)
  {
    // Corners are joined by place alone, not by the normal of their facet (STL).
    importer_.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS);
    const aiScene* const scene = importer_.ReadFile(
        path, aiProcess_RemoveComponent | aiProcess_JoinIdenticalVertices);
    if (scene == nullptr)
      throw std::runtime_error(path + ": " + importer_.GetErrorString());
    return *scene;
  }

  ::Assimp::Importer importer_;
};

TEST_F(AssimpTest, FindsAMeshForEachPartOfAnOBJ)
{
  forEachExportedScene([&](const ExportedScene& exported) {
    const aiScene& scene = open(exported.file("hulls.obj"));
    ASSERT_EQ(scene.mNumMeshes, exported.parts().size());
    for (unsigned int i = 0; i < scene.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene.mMeshes[i];
      EXPECT_EQ(mesh.mName.C_Str(), partName(i));
      EXPECT_EQ(mesh.mNumFaces, exported.parts()[i].hull.triangles.size());
      aiColor3D color;
      ASSERT_EQ(
          scene.mMaterials[mesh.mMaterialIndex]->Get(AI_MATKEY_COLOR_DIFFUSE, color),
          aiReturn_SUCCESS);
      EXPECT_NEAR(color.r, partColor(i).red / 255.0, 1e-6);
      EXPECT_NEAR(color.g, partColor(i).green / 255.0, 1e-6);
      EXPECT_NEAR(color.b, partColor(i).blue / 255.0, 1e-6);
    }
  });
}

TEST_F(AssimpTest, FindsTheColorsOfAFileWithBlanksInItsName)
{
  const std::vector<ConvexPart>& parts = scenesToExport().front().parts;
  const TemporaryFolder folder;
  const std::string path = folder.file("my new hulls.obj");
  std::ofstream mesh(path);
  writeMesh(mesh, parts, path);
  mesh.close();
  std::ofstream materials(materialsBeside(path));
  writeMaterials(materials, parts, path);
  materials.close();
  const aiScene& scene = open(path);
  ASSERT_EQ(scene.mNumMeshes, parts.size());
  aiColor3D color;
  ASSERT_EQ(scene.mMaterials[scene.mMeshes[1]->mMaterialIndex]->Get(
                AI_MATKEY_COLOR_DIFFUSE, color),
            aiReturn_SUCCESS);
  EXPECT_NEAR(color.g, partColor(1).green / 255.0, 1e-6);
}

TEST_F(AssimpTest, OpensTheMeshesOfAllPartsInOne)
{
  forEachExportedScene([&](const ExportedScene& exported) {
    for (const char* const name : {"hulls.ply", "hulls.stl"}) {
      const aiScene& scene = open(exported.file(name));
      ASSERT_EQ(scene.mNumMeshes, 1u);
      EXPECT_EQ(scene.mMeshes[0]->mNumFaces, trianglesOf(exported.parts())) << name;
    }
  });
}

TEST_F(AssimpTest, FindsTheNodesOfAGLTFWhereThePartsAre)
{
  forEachExportedScene([&](const ExportedScene& exported) {
    const aiScene& scene = open(exported.file("scene.glb"));
    const aiNode& root = *scene.mRootNode;
    ASSERT_EQ(root.mNumChildren, exported.parts().size());
    for (unsigned int i = 0; i < root.mNumChildren; ++i) {
      const aiNode& node = *root.mChildren[i];
      EXPECT_EQ(node.mName.C_Str(), exported.partName(i));
      ASSERT_EQ(node.mNumMeshes, 1u);
      const aiMesh& mesh = *scene.mMeshes[node.mMeshes[0]];
      const TriangleMesh& hull = exported.parts()[i].hull;
      ASSERT_EQ(mesh.mNumFaces, hull.triangles.size());
      EXPECT_EQ(mesh.mNumVertices, hull.vertices.size());
      expectClosed(mesh);
      EXPECT_GT(volumeOf(mesh), 0.0);
      const aiMatrix4x4 pose = root.mTransformation * node.mTransformation;
      Eigen::AlignedBox3d box; // x, z, -y
      for (unsigned int v = 0; v < mesh.mNumVertices; ++v) {
        const aiVector3D place = pose * mesh.mVertices[v];
        box.extend(Eigen::Vector3d(place.x, -place.z, place.y));
      }
      // Poses are in float there.
      const double rounding = 1e-6 * (1.0 + exported.description().origin.norm());
      EXPECT_LT((box.min() - boxOf(hull).min()).norm(), rounding);
      EXPECT_LT((box.max() - boxOf(hull).max()).norm(), rounding);
    }
  });
}

TEST_F(AssimpTest, FindsEachPartsOwnMeshClosedAndFacingOutward)
{
  forEachExportedScene([&](const ExportedScene& exported) {
    for (std::size_t i = 0; i < exported.parts().size(); ++i) {
      const aiScene& scene = open(exported.mesh(i));
      const ConvexPart& part = exported.parts()[i];
      ASSERT_EQ(scene.mNumMeshes, 1u);
      const aiMesh& mesh = *scene.mMeshes[0];
      EXPECT_EQ(mesh.mNumVertices, part.hull.vertices.size());
      EXPECT_EQ(mesh.mNumFaces, part.hull.triangles.size());
      expectClosed(mesh);
      // Corners are rounded to float: by this much, over all of the surface.
      const double rounding = 1e-6 * part.area;
      EXPECT_NEAR(volumeOf(mesh), part.volume, rounding + 1e-5 * part.volume);
    }
  });
}

} // namespace
} // namespace pcl_cid::test
