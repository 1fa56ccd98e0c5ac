/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * OBJ opened by tinyobjloader, which Open3D and many engines read it with.
 */

#include "cloud_files.h"
#include "part_scenes.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_formats.h>

#include <fstream>

#include <gtest/gtest.h>
#include <tiny_obj_loader.h>

namespace pcl_cid::test {
namespace {

TEST(Tinyobj, FindsTheColorsWhateverTheNameOfTheFile)
{
  const std::vector<ConvexPart> parts = thinParts(Eigen::Vector3d::Zero()).parts;
  const TemporaryFolder folder;
  for (const char* const file : {"hulls.obj",
                                 "my new  hulls.obj",
                                 "K\xC3\xBC"
                                 "che.obj"}) {
    const std::string path = folder.file(file);
    std::ofstream mesh(path);
    writeMesh(mesh, parts, path, "hall");
    mesh.close();
    std::ofstream materials(materialsBeside(path));
    writeMaterials(materials, parts, path, "hall");
    materials.close();

    tinyobj::ObjReader reader;
    ASSERT_TRUE(reader.ParseFromFile(path)) << reader.Error();
    EXPECT_EQ(reader.Warning(), "");
    ASSERT_EQ(reader.GetMaterials().size(), parts.size()) << file;
    ASSERT_EQ(reader.GetShapes().size(), parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const tinyobj::shape_t& shape = reader.GetShapes()[i];
      EXPECT_EQ(shape.name, partName(i, "hall"));
      EXPECT_EQ(shape.mesh.num_face_vertices.size(), parts[i].hull.triangles.size());
      const auto material = static_cast<std::size_t>(shape.mesh.material_ids.at(0));
      const tinyobj::material_t& color = reader.GetMaterials().at(material);
      EXPECT_EQ(color.name, partName(i, "hall"));
      EXPECT_NEAR(color.diffuse[1], partColor(i).green / 255.0, 1e-6);
    }
  }
}

} // namespace
} // namespace pcl_cid::test
