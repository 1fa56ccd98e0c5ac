/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls from files of this and of other programs.
 */

#include "hull_files.h"

#include "cloud_files.h"
#include "hulls.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/mesh_formats.h>

#include <fstream>

#include <gtest/gtest.h>

namespace pcl_cid::benchmarks {
namespace {

class HullFiles : public testing::Test {
protected:
  std::vector<ConvexPart>
  read(const std::string& name, const std::string& text)
  {
    test::writeText(folder_.file(name), text);
    return readHulls(folder_.file(name), Frame(), 1);
  }

  test::TemporaryFolder folder_;
};

TEST_F(HullFiles, KeepThePartsOfEveryFormat)
{
  const std::vector<ConvexPart> parts{
      test::partOf(test::randomCube(40, 1)),
      test::partOf({{5, 0, 0}, {7, 0, 0}, {5, 1, 0}, {5, 0, 4}})};
  for (const std::string& extension : meshExtensions()) {
    const std::string path = folder_.file("hulls" + extension);
    {
      std::ofstream stream(path, std::ios::binary);
      writeMesh(stream, parts, path);
    }
    const std::vector<ConvexPart> hulls = readHulls(path, Frame(), 1);
    ASSERT_EQ(hulls.size(), 2u) << path;
    for (std::size_t k = 0; k < hulls.size(); ++k) {
      EXPECT_NEAR(hulls[k].volume, parts[k].volume, 1e-5) << path;
      EXPECT_EQ(hulls[k].indices.size(), parts[k].hull.vertices.size()) << path;
    }
  }
}

TEST_F(HullFiles, TakeTheHullOfAPartThatHasNone)
{
  const std::vector<ConvexPart> hulls =
      read("other.obj",
           "# of another program\nmtllib a.mtl\no empty\no convex_0\nusemtl a\n"
           "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0.1 0.1 0.1\n"
           "f 1 2 5\nf 2 3 5\nf 3 1 5\n");
  ASSERT_EQ(hulls.size(), 1u);
  EXPECT_NEAR(hulls[0].volume, 1.0 / 6.0, 1e-6);
  EXPECT_EQ(hulls[0].hull.vertices.size(), 4u);
}

TEST_F(HullFiles, FarAwayKeepTheirShape)
{
  Frame frame;
  frame.origin = {458000.0, 5000000.0, 0.0};
  test::writeText(folder_.file("far.obj"),
                  "o a\nv 458001.001 5000001 0\nv 458001.002 5000001 0\n"
                  "v 458001.001 5000001.001 0\nv 458001.001 5000001 0.001\n");
  const ConvexPart hull = readHulls(folder_.file("far.obj"), frame, 1).at(0);
  EXPECT_NEAR(hull.volume, 1e-9 / 6.0, 1e-12);
  EXPECT_NEAR(hull.hull.vertices[0].x(), 458001.0015, 0.001);
}

TEST_F(HullFiles, WithoutAHullAreRefused)
{
  EXPECT_THROW(read("none.obj", ""), CIDException);
  EXPECT_THROW(read("none.obj", "o a\n"), CIDException);
  EXPECT_THROW(read("huge.obj", "o a\nv 0 0 2e15\n"), CIDException);
  EXPECT_THROW(read("none.txt", ""), CIDException);
}

TEST(PiecesOfAMesh, AreJoinedByTriangles)
{
  TriangleMesh mesh;
  mesh.vertices.resize(8);
  mesh.triangles = {{7, 6, 5}, {0, 3, 1}, {1, 3, 4}};
  EXPECT_EQ(piecesOf(mesh), (std::vector<int>{0, 0, -1, 0, 0, 1, 1, 1}));
}

} // namespace
} // namespace pcl_cid::benchmarks
