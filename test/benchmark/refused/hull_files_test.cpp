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

/** A tetrahedron of volume 1/6, and one of 8/6, 5 m away along x. */
const char* const small_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const char* const large_vertices = "v 5 0 0\nv 7 0 0\nv 5 2 0\nv 5 0 2\n";
const char* const small_faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
const char* const large_faces = "f 5 7 6\nf 5 6 8\nf 6 7 8\nf 5 8 7\n";

class HullFiles : public testing::Test {
protected:
  std::vector<ConvexPart>
  read(const std::string& name, const std::string& text)
  {
    test::writeText(folder_.file(name), text);
    return readHulls(folder_.file(name), Frame(), 1);
  }

  /** The two tetrahedra, in this order. */
  void
  expectBoth(const std::string& text)
  {
    const std::vector<ConvexPart> hulls = read("both.obj", text);
    ASSERT_EQ(hulls.size(), 2u) << text;
    EXPECT_NEAR(hulls[0].volume, 1.0 / 6.0, 1e-5) << text;
    EXPECT_NEAR(hulls[1].volume, 8.0 / 6.0, 1e-5) << text;
  }

  /** What is said of a file, without its name. */
  std::string
  complaint(const std::string& text)
  {
    const std::string path = folder_.file("bad.obj");
    return test::complaintAbout(path, [&] { read("bad.obj", text); });
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

TEST_F(HullFiles, OfAnOBJHaveNamesInManyWays)
{
  const std::string small = std::string(small_vertices) + small_faces;
  const std::string large = std::string(large_vertices) + large_faces;
  const std::string vertices = std::string(small_vertices) + large_vertices;
  expectBoth("o convex_0\n" + small + "o convex_1\n" + large); // V-HACD, CoACD, ours
  expectBoth("o convex\n" + small + "o convex\n" + large);
  expectBoth("g a\n" + small + "g b\n" + large);
  expectBoth("o all\n" + vertices + "g a\n" + small_faces + "g b\n" + large_faces);
  expectBoth("g default\n" + vertices + "g a\n" + small_faces + "g b\n" + large_faces);
  expectBoth("o a\ng wood\n" + small + "o b\ng wood\n" + large);
  expectBoth("o a\n" + small + "o b\ng wood\n" + large_vertices +
             "f 5 7 6\nf 5 6 8\ng iron\nf 6 7 8\nf 5 8 7\n");
  expectBoth("g a\n" + small + "g b\n" + large + "g a\nf 1 2 3\n"); // a goes on
  expectBoth(small + large); // no name: connected pieces
  expectBoth(vertices + small_faces + large_faces);
  expectBoth(small + large + "v 100 100 100\n"); // in no piece
}

TEST_F(HullFiles, OfAnOBJAreWrittenInManyWays)
{
  const std::string small = std::string(small_vertices) + small_faces;
  expectBoth("# Blender\nmtllib a.mtl\no Cube\n" + std::string(small_vertices) +
             "vn -0.5 0 1\nvt 0.25 1\ns 1\nusemtl Material\n"
             "f 1/1/1 3/1/1 2/1/1\nf 1/1/1 2/1/1 4/1/1\nf 2//1 3//1 4//1\n"
             "f 1/1 4/1 3/1\nl 1 2\ns off\no Cube.001\n" +
             large_vertices + large_faces);
  expectBoth("o a\n" + small + "o b\n" + large_vertices +
             "f -4 -2 -3\nf -4/-1/-1 -3/-1/-1 -1/-1/-1\nf -3//-1 -2//-1 -1//-1\n");
  expectBoth("o a\n" + small + "o b\n" + large_vertices +
             "v 5 0.5 0.5\nf 5 7 9 8 6 # not even flat\n");
  expectBoth("\n\t\n  o a\n" + small +
             "o b\nv 5 0 0 1\nv 7. 0 0 .5 .5 .5\nv\t5 +2e0 0  # x\nv 5 0 2\n" +
             large_faces);
  std::string of_windows = "o a\n" + small + "o b\n" + large_vertices + large_faces;
  for (std::size_t at = 0; (at = of_windows.find('\n', at)) != std::string::npos;
       at += 2)
    of_windows.insert(at, 1, '\r');
  expectBoth(of_windows);
  of_windows.pop_back(); // the last line has no end
  of_windows.pop_back();
  expectBoth(of_windows);
}

TEST_F(HullFiles, OfAnOBJThatIsBrokenSayWhere)
{
  const std::string small = std::string("o a\n") + small_vertices;
  EXPECT_EQ(complaint("o a\nv 0 0\n"),
            ": line 2: 'v 0 0' has fewer than the 3 coordinates of a vertex");
  EXPECT_EQ(complaint("o a\r\nv 0 0 x\r\n"),
            ": line 2: 'v 0 0 x' has 'x' where a finite number must be");
  EXPECT_EQ(complaint("o a\nv 0 0 nan\n"),
            ": line 2: 'v 0 0 nan' has 'nan' where a finite number must be");
  EXPECT_EQ(complaint(small + "\nf 1 2\n"),
            ": line 7: 'f 1 2' has fewer than the 3 corners of a face");
  EXPECT_EQ(complaint(small + "f 1 2 5\n"),
            ": line 6: 'f 1 2 5' names vertex 5; there are 4 before it");
  EXPECT_EQ(complaint(small + "f 1 2 -5\n"),
            ": line 6: 'f 1 2 -5' names vertex -5; there are 4 before it");
  EXPECT_EQ(complaint(small + "f 0 1 2\n"),
            ": line 6: 'f 0 1 2' names vertex 0; there are 4 before it");
  EXPECT_EQ(complaint(small + "f 1 2 /3\n"),
            ": line 6: 'f 1 2 /3' has '/3' where the number of a vertex must be");
  EXPECT_EQ(
      complaint(small + "f 1 2 99999999999999999999\n"),
      ": line 6: 'f 1 2 99999999999999999999' has '99999999999999999999' where the "
      "number of a vertex must be");
  EXPECT_EQ(complaint(small + "curv 0 1 1 2\n"),
            ": line 6: 'curv 0 1 1 2' is not understood");
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
  EXPECT_THROW(read("none.obj", "v 0 0 0\nv 1 1 1\n"), CIDException);
  EXPECT_THROW(readHulls(folder_.file("absent.obj"), Frame(), 1), CIDException);
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
