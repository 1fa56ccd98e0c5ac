/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What was written is read back bit by bit, and nothing else is read.
 */

#include "cloud_files.h"
#include "part_scenes.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_import.h>

#include <sstream>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

void
expectSame(const TriangleMesh& read, const TriangleMesh& written)
{
  EXPECT_EQ(read.vertices, written.vertices);
  EXPECT_EQ(read.triangles, written.triangles);
}

class MeshImport : public testing::Test {
protected:
  /** Write what \a writer prints to a file, and give its path. */
  template <typename Writer>
  std::string
  fileWith(const Writer& writer) const
  {
    std::ostringstream stream;
    writer(stream);
    return fileOf(stream.str());
  }

  std::string
  fileOf(const std::string& content) const
  {
    const std::string path = folder_.file("m\xC3\xA4sh of parts");
    writeText(path, content);
    return path;
  }

  /** Expect that a content is refused, with these words, and that the message begins
   *  with the file. */
  template <typename Reader>
  void
  expectRefused(const Reader& reader,
                const std::string& content,
                const std::string& complaint) const
  {
    const std::string path = fileOf(content);
    try {
      reader(path);
      FAIL() << "'" << content << "' was read";
    }
    catch (const CIDException& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.rfind(path + ": ", 0), 0u) << message;
      EXPECT_NE(message.find(complaint), std::string::npos) << message;
    }
  }

  TemporaryFolder folder_;
};

TEST_F(MeshImport, ReadsOBJAndPLYBackToTheLastBit)
{
  for (const PartScene& scene : partScenes()) {
    SCOPED_TRACE(scene.name);
    const auto obj = readOBJ(
        fileWith([&](std::ostream& s) { writeOBJ(s, scene.parts, "hulls.mtl"); }));
    const auto ply =
        readPLY(fileWith([&](std::ostream& s) { writePLY(s, scene.parts); }));
    ASSERT_EQ(obj.size(), scene.parts.size());
    ASSERT_EQ(ply.size(), scene.parts.size());
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
      expectSame(obj[i], scene.parts[i].hull);
      expectSame(ply[i], scene.parts[i].hull);
    }
  }
}

TEST_F(MeshImport, ReadsSTLBackAsFloat)
{
  for (const PartScene& scene : {roomParts(), thinParts(Eigen::Vector3d::Zero())})
    for (const ConvexPart& part : scene.parts) {
      SCOPED_TRACE(scene.name);
      const TriangleMesh mesh =
          readSTL(fileWith([&](std::ostream& s) { writeSTLMesh(s, part.hull); }));
      EXPECT_EQ(mesh.vertices.size(), part.hull.vertices.size());
      ASSERT_EQ(mesh.triangles.size(), part.hull.triangles.size());
      for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t corner = 0; corner < 3; ++corner)
          EXPECT_EQ(mesh.vertices[mesh.triangles[i][corner]],
                    part.hull.vertices[part.hull.triangles[i][corner]]
                        .cast<float>()
                        .cast<double>());
    }
}

TEST_F(MeshImport, ReadsNoPartsAsNoMeshes)
{
  EXPECT_TRUE(
      readOBJ(fileWith([](std::ostream& s) { writeOBJ(s, {}, "hulls.mtl"); })).empty());
  EXPECT_TRUE(readPLY(fileWith([](std::ostream& s) { writePLY(s, {}); })).empty());
  EXPECT_TRUE(
      readSTL(fileWith([](std::ostream& s) { writeSTL(s, {}); })).triangles.empty());
}

TEST_F(MeshImport, RefusesOtherOBJFiles)
{
  const std::string triangle = "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(readOBJ(fileOf("# by hand\n" + triangle + "f 1 2 3\n")).size(), 1u);
  expectRefused(readOBJ, "v 0 0 0\n", "line 1: 'v 0 0 0' stands before");
  expectRefused(readOBJ, "o a\nv 0 0\n", "line 2");
  expectRefused(readOBJ, "o a\nv 0 0 x\n", "'x' where a number");
  expectRefused(readOBJ, "o a\nv 0 0 1e999\n", "'1e999' where a number");
  expectRefused(readOBJ, "o a\nv 0 0 nan\n", "not finite");
  expectRefused(readOBJ, "o a\nvt 0 0 0\n", "line 2: 'vt 0 0 0' is not");
  expectRefused(readOBJ, triangle + "f 1 2 4\n", "line 5: 'f 1 2 4' names a vertex");
  expectRefused(readOBJ, triangle + "f 0 1 2\n", "names a vertex");
  expectRefused(readOBJ, triangle + "f -1 1 2\n", "'-1' where a number");
  expectRefused(readOBJ, triangle + "f 1 2 3 1\n", "line 5");
  expectRefused(readOBJ, triangle + "o b\nf 1 2 3\n", "line 6");
}

TEST_F(MeshImport, RefusesOtherPLYFiles)
{
  std::ostringstream stream;
  writePLY(stream, thinParts(Eigen::Vector3d::Zero()).parts);
  const std::string good = stream.str();
  const std::size_t body = good.find("end_header\n") + 11;
  EXPECT_EQ(readPLY(fileOf(good)).size(), 7u);
  expectRefused(readPLY, good.substr(0, good.size() - 1), "bytes from here on");
  expectRefused(readPLY, good + "x", "bytes from here on");
  expectRefused(readPLY, good.substr(0, body - 20), "");
  expectRefused(readPLY, "no mesh\n", "");

  std::string text = good;
  text.replace(text.find("property double x"), 17, "property float x ");
  expectRefused(readPLY, text, "its header is not");

  std::string gap = good; // the last face is of part 8 after one of part 6
  gap[gap.size() - 4] = 8;
  expectRefused(readPLY, gap, "is of part 8 after one of part 6");
  std::string negative = good;
  negative.replace(negative.size() - 4, 4, "\xFF\xFF\xFF\xFF");
  expectRefused(readPLY, negative, "is of part -1");

  std::string shared = good; // a corner of the last face becomes vertex 0
  shared.replace(shared.size() - 11, 4, std::string(4, '\0'));
  expectRefused(readPLY, shared, "shares vertex 0 with part 0");
  std::string wild = good;
  wild.replace(wild.size() - 11, 4, "\xFF\xFF\xFF\x7F");
  expectRefused(readPLY, wild, "which is none");

  std::string infinite = good; // the first coordinate
  infinite.replace(body, 8, std::string("\0\0\0\0\0\0\xF0\x7F", 8));
  expectRefused(readPLY,
                infinite,
                "offset " + std::to_string(body) + ": is a vertex that is not finite");
}

TEST_F(MeshImport, RefusesVerticesOfNoFace)
{
  std::vector<ConvexPart> parts = thinParts(Eigen::Vector3d::Zero()).parts;
  parts[2].hull.vertices.emplace_back(0.0, 0.0, 0.0);
  const std::string path =
      fileWith([&](std::ostream& stream) { writePLY(stream, parts); });
  EXPECT_THROW(readPLY(path), CIDException);
}

TEST_F(MeshImport, RefusesOtherSTLFiles)
{
  std::ostringstream stream;
  writeSTLMesh(stream, thinParts(Eigen::Vector3d::Zero()).parts[0].hull);
  const std::string good = stream.str();
  EXPECT_FALSE(readSTL(fileOf(good)).triangles.empty());
  expectRefused(readSTL, good.substr(0, good.size() - 1), "offset 84: has");
  expectRefused(readSTL, good + "x", "offset 84: has");
  expectRefused(readSTL, good.substr(0, 50), "ends too early");
  expectRefused(readSTL, "solid text\nendsolid\n", "ends too early");
  std::string infinite = good; // the first coordinate, after the normal
  infinite.replace(84 + 12, 4, std::string("\0\0\x80\x7F", 4));
  expectRefused(readSTL, infinite, "offset 96: is a vertex that is not finite");
}

TEST_F(MeshImport, RefusesFilesThatAreNotThere)
{
  const std::string path = folder_.file("nothing");
  EXPECT_THROW(readOBJ(path), CIDException);
  EXPECT_THROW(readPLY(path), CIDException);
  EXPECT_THROW(readSTL(path), CIDException);
}

} // namespace
} // namespace pcl_cid::test
