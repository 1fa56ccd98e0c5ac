/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Meshes of parts, read again by PCL's own readers.
 */

#include "cloud_files.h"
#include "hulls.h"

#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/polygon_mesh.h>

#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include <pcl/conversions.h>
#include <pcl/io/obj_io.h>
#include <pcl/io/ply_io.h>

namespace pcl_cid::test {
namespace {

/** Hulls of two boxes, far apart, at coordinates that float cannot hold. */
std::vector<ConvexPart>
twoParts()
{
  std::vector<ConvexPart> parts;
  for (const float shift : {0.0f, 5.0f}) {
    PointSet points;
    points.frame.origin = Eigen::Vector3d(500000.001, 4100000.001, 0.0);
    pcl::Indices members;
    for (int corner = 0; corner < 8; ++corner) {
      points.points.emplace_back(shift + static_cast<float>(corner & 1),
                                 static_cast<float>(corner >> 1 & 1),
                                 static_cast<float>(corner >> 2));
      points.source.push_back(corner);
      members.push_back(corner);
    }
    parts.push_back(makeConvexPart(points, members, {}));
  }
  return parts;
}

std::size_t
occurrences(const std::string& text, const std::string& what)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + 1))
    ++count;
  return count;
}

TEST(OBJFile, HasAnObjectForEachPartThatPCLReads)
{
  const std::vector<ConvexPart> parts = twoParts();
  std::ostringstream text;
  writeOBJ(text, parts, "hulls.mtl");
  EXPECT_EQ(occurrences(text.str(), "\no "), 2u);
  EXPECT_EQ(occurrences(text.str(), "\no part_000\n"), 1u);
  EXPECT_EQ(occurrences(text.str(), "\no part_001\n"), 1u);
  EXPECT_EQ(text.str().rfind("mtllib hulls.mtl\n", 0), 0u);

  const TemporaryFolder folder;
  std::ofstream materials(folder.file("hulls.mtl"));
  writeMTL(materials, parts);
  materials.close();
  EXPECT_EQ(occurrences(readText(folder.file("hulls.mtl")), "newmtl part_"), 2u);
  writeText(folder.file("hulls.obj"), text.str());
  pcl::PolygonMesh mesh;
  ASSERT_GE(pcl::OBJReader().read(folder.file("hulls.obj"), mesh), 0);
  EXPECT_EQ(mesh.cloud.width * mesh.cloud.height, 16u);
  ASSERT_EQ(mesh.polygons.size(), trianglesOf(parts));
  std::set<pcl::index_t> used;
  for (const pcl::Vertices& polygon : mesh.polygons) {
    EXPECT_EQ(polygon.vertices.size(), 3u);
    used.insert(polygon.vertices.begin(), polygon.vertices.end());
  }
  EXPECT_EQ(used.size(), 16u);
}

TEST(OBJFile, KeepsEveryDigit)
{
  const std::vector<ConvexPart> parts = twoParts();
  std::ostringstream text;
  writeOBJ(text, parts, "hulls.mtl");
  std::istringstream lines(text.str());
  std::size_t vertex = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("v ", 0) != 0)
      continue;
    std::istringstream numbers(line.substr(2));
    Eigen::Vector3d v;
    numbers >> v.x() >> v.y() >> v.z();
    EXPECT_EQ(v, parts[vertex / 8].hull.vertices[vertex % 8]);
    ++vertex;
  }
  EXPECT_EQ(vertex, 16u);
}

TEST(PLYMesh, IsReadByPCLAndHoldsPartsAndColors)
{
  const std::vector<ConvexPart> parts = twoParts();
  const TemporaryFolder folder;
  std::ofstream stream(folder.file("hulls.ply"), std::ios::binary);
  writePLY(stream, parts);
  stream.close();
  pcl::PolygonMesh mesh;
  ASSERT_GE(pcl::io::loadPLYFile(folder.file("hulls.ply"), mesh), 0);
  ASSERT_EQ(mesh.polygons.size(), trianglesOf(parts));
  const std::vector<double> x = valuesOf<double>(mesh.cloud, "x");
  ASSERT_EQ(x.size(), 16u);
  for (std::size_t vertex = 0; vertex < x.size(); ++vertex)
    EXPECT_EQ(x[vertex], parts[vertex / 8].hull.vertices[vertex % 8].x());
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    const std::size_t part = i / parts[0].hull.triangles.size();
    const auto& triangle =
        parts[part].hull.triangles[i % parts[0].hull.triangles.size()];
    for (std::size_t corner = 0; corner < 3; ++corner)
      EXPECT_EQ(static_cast<std::size_t>(mesh.polygons[i].vertices[corner]),
                triangle[corner] + part * parts[0].hull.vertices.size());
  }
  // The last face: 3 vertices, its color, its part.
  const std::string bytes = readText(folder.file("hulls.ply"));
  std::int32_t part = -1;
  std::memcpy(&part, &bytes[bytes.size() - 4], 4);
  EXPECT_EQ(part, 1);
  EXPECT_EQ(static_cast<std::uint8_t>(bytes[bytes.size() - 7]), partColor(1).red);
}

TEST(STLFile, HasEveryTriangleWithItsNormalOutward)
{
  std::vector<ConvexPart> parts = twoParts();
  moveToFile(Frame{{-500000.001, -4100000.001, 0.0}}, parts);
  std::ostringstream stream;
  writeSTL(stream, parts);
  const std::string bytes = stream.str();
  ASSERT_EQ(bytes.size(), 84 + 50 * trianglesOf(parts));
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, &bytes[80], 4);
  EXPECT_EQ(triangles, trianglesOf(parts));
  EXPECT_NE(bytes.rfind("solid", 0), 0u); // that would mean text
  for (std::size_t i = 0; i < triangles; ++i) {
    Eigen::Matrix<float, 3, 4> triangle; // normal, then corners
    std::memcpy(triangle.data(), &bytes[84 + 50 * i], 48);
    const Eigen::Vector3f center(i < triangles / 2 ? 0.5f : 5.5f, 0.5f, 0.5f);
    EXPECT_NEAR(triangle.col(0).norm(), 1.0f, 1e-5f);
    for (int corner = 1; corner < 4; ++corner)
      EXPECT_NEAR(triangle.col(0).dot(triangle.col(corner) - center), 0.5f, 1e-5f);
  }
}

TEST(MeshExport, GivesNeighboringPartsDifferentColors)
{
  std::set<int> colors;
  for (std::size_t part = 0; part < 256; ++part) {
    const PartColor color = partColor(part);
    colors.insert(color.red << 16 | color.green << 8 | color.blue);
  }
  EXPECT_EQ(colors.size(), 256u);
  EXPECT_EQ(partColor(256).red, partColor(0).red);
  EXPECT_EQ(partName(7), "part_007");
  EXPECT_EQ(partName(12345), "part_12345");
  EXPECT_EQ(partName(7, "hall"), "hall_part_007");
}

TEST(PartsName, IsOfLettersDigitsAndUnderscores)
{
  for (const char* const name : {"a", "hall", "Hall_2", "a__", "world_2", "World"})
    EXPECT_NO_THROW(requirePartsName(name)) << name;
  for (const char* const name : {"",
                                 "2nd",
                                 "_hall",
                                 "world",
                                 "a b",
                                 "a-b",
                                 "a.b",
                                 "a/b",
                                 "a::b",
                                 "a\n",
                                 "K\xC3\xBC"
                                 "che"})
    try {
      requirePartsName(name);
      FAIL() << name << " passes";
    }
    catch (const CIDException& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find("letters"), std::string::npos) << said;
    }
}

TEST(PartsName, CanBeMadeOfAnyText)
{
  EXPECT_EQ(partsNameFrom("hall"), "hall");
  EXPECT_EQ(partsNameFrom("Hall_2"), "Hall_2");
  EXPECT_EQ(partsNameFrom("2nd floor (new)"), "scan_2nd_floor_new");
  EXPECT_EQ(partsNameFrom("scene0000_00"), "scene0000_00");
  EXPECT_EQ(partsNameFrom("K\xC3\xBC"
                          "che"),
            "K_che");
  EXPECT_EQ(partsNameFrom("world"), "scan_world");
  EXPECT_EQ(partsNameFrom("__a--b__"), "a_b");
  EXPECT_EQ(partsNameFrom(""), "scan");
  EXPECT_EQ(partsNameFrom("\xE6\x97\xA5"), "scan");
  std::string all;
  for (int c = 1; c < 256; ++c) {
    all += static_cast<char>(c);
    for (const std::string& text : {all, std::string(1, static_cast<char>(c))}) {
      EXPECT_NO_THROW(requirePartsName(partsNameFrom(text))) << text;
      EXPECT_EQ(partsNameFrom(partsNameFrom(text)), partsNameFrom(text));
    }
  }
}

TEST(OBJFile, NamesItsPartsAndTheirMaterialsAlike)
{
  std::ostringstream text;
  writeOBJ(text, twoParts(), "hulls.mtl", "hall");
  std::ostringstream materials;
  writeMTL(materials, twoParts(), "hall");
  EXPECT_EQ(occurrences(text.str(), "part_"), 4u);
  for (const char* const name : {"hall_part_000\n", "hall_part_001\n"}) {
    EXPECT_EQ(occurrences(text.str(), std::string("\no ") + name), 1u);
    EXPECT_EQ(occurrences(text.str(), std::string("\nusemtl ") + name), 1u);
    EXPECT_EQ(occurrences(materials.str(), std::string("newmtl ") + name), 1u);
  }
}

TEST(MeshExport, MakesMeshesOfPCL)
{
  std::vector<ConvexPart> parts = twoParts();
  moveToFile(Frame{{-500000.0, -4100000.0, 0.0}}, parts);
  const pcl::PolygonMesh mesh = toPolygonMesh(parts[0].hull);
  ASSERT_EQ(mesh.polygons.size(), parts[0].hull.triangles.size());
  pcl::PointCloud<pcl::PointXYZ> vertices;
  pcl::fromPCLPointCloud2(mesh.cloud, vertices);
  ASSERT_EQ(vertices.size(), parts[0].hull.vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    EXPECT_TRUE(vertices[i].getVector3fMap().isApprox(
        parts[0].hull.vertices[i].cast<float>(), 1e-6f));
}

TEST(MeshExport, WritesNoPartsAsEmptyMeshes)
{
  std::ostringstream stl;
  writeSTL(stl, {});
  EXPECT_EQ(stl.str().size(), 84u);
  std::ostringstream ply;
  writePLY(ply, {});
  EXPECT_NE(ply.str().find("element face 0"), std::string::npos);
}

} // namespace
} // namespace pcl_cid::test
