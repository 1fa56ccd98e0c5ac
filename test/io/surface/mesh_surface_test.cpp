/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Meshes as clouds: which triangles are read, and how points lie on them.
 */

#include "cloud_files.h"

#include "base/random.h"

#include <pcl_cid/io/mesh_surface.h>
#include <pcl_cid/io/scan_source.h>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <pcl/kdtree/kdtree_flann.h>

namespace pcl_cid::test {
namespace {

/** A pyramid on a square, as every file below holds it. */
TriangleMesh
pyramid()
{
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 1.5}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return mesh;
}

/** The corners of all triangles, one after the other. */
std::vector<double>
cornersOf(const TriangleMesh& mesh)
{
  std::vector<double> corners;
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle)
      for (int axis = 0; axis < 3; ++axis)
        corners.push_back(mesh.vertices.at(vertex)[axis]);
  return corners;
}

struct MeshFile {
  const char* name;
  const char* file; ///< its name
  std::string content;
};

void
PrintTo(const MeshFile& mesh, std::ostream* stream)
{
  *stream << mesh.name;
}

std::string
asciiSTL()
{
  std::string text = "solid a pyramid\n";
  const std::vector<double> corners = cornersOf(pyramid());
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    if (i % 9 == 0)
      text += " facet normal 0 0 0\n  outer loop\n";
    text += "   vertex " + std::to_string(corners[i]) + " " +
            std::to_string(corners[i + 1]) + " " + std::to_string(corners[i + 2]) +
            "\n";
    if (i % 9 == 6)
      text += "  endloop\n endfacet\n";
  }
  return text + "endsolid a pyramid\n";
}

std::string
binarySTL()
{
  std::string bytes = "solid, as some programs begin";
  bytes.resize(80, ' ');
  const auto append = [&](auto value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  const std::vector<double> corners = cornersOf(pyramid());
  append(static_cast<std::uint32_t>(corners.size() / 9));
  for (std::size_t i = 0; i < corners.size(); i += 9) {
    for (int k = 0; k < 3; ++k)
      append(0.0f);
    for (std::size_t k = 0; k < 9; ++k)
      append(static_cast<float>(corners[i + k]));
    append(std::uint16_t{0});
  }
  return bytes;
}

const std::string obj_vertices =
    "v 0 0 0\nv 2 0 0 1 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 1.5\n";
const std::string off_vertices = "0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 1.5\n";
const std::string ply_header =
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float "
    "x\nproperty float y\nproperty float z\n";

std::vector<MeshFile>
meshFiles()
{
  return {
      {"OBJ",
       "a.obj",
       "# made by hand\nmtllib a b.mtl\no one\n" + obj_vertices +
           "vt 0 0\nvn 0 0 1\nusemtl red\ns off\nf 1 2 3 4\nf 1/1 2/1 5/1\nf 2/1/1 "
           "3/1/1 "
           "5/1/1\nf 3//1 4//1 5//1\nf -2 -5 -1\n"},
      {"OBJWindows",
       "a.OBJ",
       "v 0 0 0\r\nv 2 0 0\r\nv 2 2 0\r\nv 0 2 0\r\nv 1 1 1.5\r\nf 1 2 3 4\r\nf 1 2 "
       "5\r\nf "
       "2 3 5\r\nf 3 4 5\r\nf 4 1 5\r\n"},
      {"STLAscii", "a.stl", asciiSTL()},
      {"STLBinary", "a.stl", binarySTL()},
      {"OFF",
       "a.off",
       "OFF\n# comment\n5 5 0\n" + off_vertices +
           "4 0 1 2 3\n3 0 1 4\n3 1 2 4 0.5 0.5 0.5\n3 2 3 4\n3 3 0 4\n"},
      {"OFFWithColors",
       "a.off",
       "COFF 5 5 0\n0 0 0 1 1 1 1\n2 0 0 1 1 1 1\n2 2 0 1 1 1 1\n0 2 0 1 1 1 1\n1 1 "
       "1.5 1 "
       "1 1 1\n\n4 0 1 2 3\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n"},
      {"PLY",
       "a.ply",
       ply_header +
           "element face 5\nproperty uchar red\nproperty list uchar int "
           "vertex_indices\nend_header\n" +
           off_vertices + "9 4 0 1 2 3\n9 3 0 1 4\n9 3 1 2 4\n9 3 2 3 4\n9 3 3 0 4\n"},
      {"PLYWithItsFacesFirst",
       "a.ply",
       "ply\nformat ascii 1.0\nelement face 5\nproperty list uchar uint "
       "vertex_index\nelement vertex 5\nproperty double z\nproperty double y\nproperty "
       "double x\nend_header\n4 0 1 2 3\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n0 0 0\n0 "
       "0 "
       "2\n0 2 2\n0 2 0\n1.5 1 1\n"}};
}

class MeshFiles : public testing::TestWithParam<MeshFile> {};

INSTANTIATE_TEST_SUITE_P(Formats,
                         MeshFiles,
                         testing::ValuesIn(meshFiles()),
                         [](const testing::TestParamInfo<MeshFile>& info) {
                           return info.param.name;
                         });

TEST_P(MeshFiles, AreReadWithAllTheirTriangles)
{
  const TemporaryFolder folder;
  const std::string path = folder.file(GetParam().file);
  writeText(path, GetParam().content);
  EXPECT_EQ(cornersOf(readSurface(path)), cornersOf(pyramid()));
  EXPECT_EQ(isSurfaceFile(path), path.substr(path.size() - 3) != "ply");
}

TEST_P(MeshFiles, AreRefusedWhereverTheyAreCut)
{
  const TemporaryFolder folder;
  const std::string path = folder.file(GetParam().file);
  const std::string whole = GetParam().content;
  const bool has_count =
      whole.find("v 0 0 0") != 0 && whole[0] != '#'; // an OBJ has none
  // Nothing tells how many faces an OBJ has: one is enough.
  const std::size_t end = has_count
                              ? std::min(whole.size() - 6, whole.rfind("endsolid"))
                              : whole.find("\nf ");
  for (std::size_t size = 0; size < end; ++size) {
    writeText(path, whole.substr(0, size));
    const std::string complaint = complaintAbout(path, [&] { readSurface(path); });
    EXPECT_NE(complaint, "none") << "cut to " << size << " bytes";
  }
}

TEST_P(MeshFiles, NeverCrashTheReader)
{
  const TemporaryFolder folder;
  const std::string path = folder.file(GetParam().file);
  RandomGenerator generator(3);
  for (int round = 0; round < 300; ++round) {
    std::string damaged = GetParam().content;
    for (std::uint64_t change = 0; change <= drawBelow(generator, 3); ++change)
      damaged[drawBelow(generator, damaged.size())] = static_cast<char>(
          drawBelow(generator, 2) == 0 ? drawBelow(generator, 256)
                                       : '0' + drawBelow(generator, 10));
    writeText(path, damaged);
    try {
      const TriangleMesh mesh = readSurface(path);
      for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
          ASSERT_LT(vertex, mesh.vertices.size());
    }
    catch (const CIDException&) {
    }
  }
}

/** The distance of a point from a triangle, by Ericson, Real-Time Collision Detection,
 *  5.1.5, written as the least over a fine grid of it. */
double
distanceFromGrid(const Eigen::Vector3d& p,
                 const TriangleMesh& mesh,
                 const std::array<std::uint32_t, 3>& triangle)
{
  constexpr int steps = 60;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j) {
      const double u = static_cast<double>(i) / steps;
      const double v = static_cast<double>(j) / steps;
      const Eigen::Vector3d x = (1.0 - u - v) * mesh.vertices[triangle[0]] +
                                u * mesh.vertices[triangle[1]] +
                                v * mesh.vertices[triangle[2]];
      least = std::min(least, (x - p).norm());
    }
  return least;
}

/** A random point of a mesh, all triangles alike: slivers, too. */
Eigen::Vector3d
randomPointOn(const TriangleMesh& mesh, RandomGenerator& generator)
{
  const auto& t = mesh.triangles[drawBelow(generator, mesh.triangles.size())];
  double u = static_cast<double>(drawBelow(generator, 1001)) / 1000.0;
  double v = static_cast<double>(drawBelow(generator, 1001)) / 1000.0;
  if (u + v > 1.0) {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  return (1.0 - u - v) * mesh.vertices[t[0]] + u * mesh.vertices[t[1]] +
         v * mesh.vertices[t[2]];
}

double
nearest(const Eigen::Vector3d& p, const std::vector<Eigen::Vector3d>& points)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& each : points)
    least = std::min(least, (each - p).norm());
  return least;
}

/** A pyramid, a sliver, many tiny triangles, one that is a point, one given twice. */
TriangleMesh
unevenMesh()
{
  TriangleMesh mesh = pyramid();
  const auto add = [&](const Eigen::Vector3d& a,
                       const Eigen::Vector3d& b,
                       const Eigen::Vector3d& c) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  add({5, 0, 0}, {9, 0, 0.001}, {7, 0.002, 0});
  add({5, 5, 5}, {5, 5, 5}, {5, 5, 5});
  mesh.triangles.push_back(mesh.triangles[0]);
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j) {
      const Eigen::Vector3d corner(-3.0 + 0.02 * i, 0.02 * j, 0.0);
      add(corner,
          corner + Eigen::Vector3d(0.02, 0, 0),
          corner + Eigen::Vector3d(0, 0.02, 0));
    }
  return mesh;
}

TEST(SurfaceSamples, AreFarApartAndLeaveNoHoles)
{
  const TriangleMesh mesh = unevenMesh();
  for (const double spacing : {0.5, 0.11, 0.07}) {
    const std::vector<Eigen::Vector3d> samples = sampleSurface(mesh, spacing);
    for (std::size_t i = 0; i < samples.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        ASSERT_GE((samples[i] - samples[j]).norm(), spacing * (1.0 - 1e-12));
    RandomGenerator generator(5);
    for (int k = 0; k < 1000; ++k) {
      const Eigen::Vector3d p = randomPointOn(mesh, generator);
      ASSERT_LE(nearest(p, samples), 1.5 * spacing) << p.transpose();
    }
  }
}

TEST(SurfaceSamples, LieOnTheSurface)
{
  const TriangleMesh mesh = pyramid();
  for (const Eigen::Vector3d& p : sampleSurface(mesh, 0.4)) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& triangle : mesh.triangles)
      least = std::min(least, distanceFromGrid(p, mesh, triangle));
    EXPECT_LT(least, 0.05) << p.transpose(); // a step of the grid is 0.05 at most
  }
}

TEST(SurfaceSamples, AreAsEvenFarFromTheOrigin)
{
  TriangleMesh mesh = pyramid();
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex += Eigen::Vector3d(691234.001, -5334321.002, 520.003);
  const std::vector<Eigen::Vector3d> samples = sampleSurface(mesh, 0.2);
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_GE((samples[i] - samples[j]).norm(), 0.2 * (1.0 - 1e-12));
  RandomGenerator generator(5);
  for (int k = 0; k < 1000; ++k)
    ASSERT_LE(nearest(randomPointOn(mesh, generator), samples), 0.3);
}

TEST(SurfaceSamples, AreNotTakenWhereCoordinatesAreTooCoarse)
{
  TriangleMesh mesh = pyramid();
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex += Eigen::Vector3d::Constant(1e16);
  EXPECT_THROW(sampleSurface(mesh, 0.2), CIDException);
}

TEST(SurfaceSamples, AreAboutAsManyAsUsual)
{
  for (const double size : {0.001, 1.0, 1000.0}) {
    TriangleMesh mesh = pyramid();
    for (Eigen::Vector3d& vertex : mesh.vertices)
      vertex *= size;
    const std::size_t count = sampleSurface(mesh, usualSpacing(mesh)).size();
    EXPECT_GT(count, 150000u);
    EXPECT_LT(count, 250000u);
  }
}

TEST(SurfaceSamples, AreAboutAsManyHoweverFineTheMeshIs)
{
  for (const std::uint32_t steps : {50u, 150u, 316u, 600u}) {
    TriangleMesh plane;
    for (std::uint32_t i = 0; i <= steps; ++i)
      for (std::uint32_t j = 0; j <= steps; ++j)
        plane.vertices.emplace_back(
            static_cast<double>(i) / steps, static_cast<double>(j) / steps, 0.0);
    for (std::uint32_t i = 0; i < steps; ++i)
      for (std::uint32_t j = 0; j < steps; ++j) {
        const std::uint32_t corner = i * (steps + 1) + j;
        const std::uint32_t across = corner + steps + 2;
        plane.triangles.push_back({corner, corner + 1, across});
        plane.triangles.push_back({corner, across, across - 1});
      }
    const std::size_t count = sampleSurface(plane, usualSpacing(plane)).size();
    EXPECT_GT(count, 100000u) << steps;
    EXPECT_LT(count, 300000u) << steps;
  }
}

TEST(SurfaceSamples, AreNotWithoutEndOnASliver)
{
  TriangleMesh sliver;
  sliver.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-12, 0}};
  sliver.triangles = {{0, 1, 2}};
  EXPECT_LT(sampleSurface(sliver, usualSpacing(sliver)).size(), 1000000u);
  EXPECT_THROW(sampleSurface(sliver, 1e-12), CIDException);
}

TEST(SurfaceSamples, AreRefusedWhereThereIsNone)
{
  TriangleMesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.triangles = {{0, 1, 2}};
  EXPECT_THROW(sampleSurface(flat, 0.1), CIDException);
  EXPECT_THROW(usualSpacing(flat), CIDException);
  EXPECT_THROW(sampleSurface(pyramid(), 0.0), CIDException);
  EXPECT_THROW(sampleSurface(pyramid(), -1.0), CIDException);
  EXPECT_THROW(sampleSurface(pyramid(), std::nan("")), CIDException);
  EXPECT_THROW(sampleSurface(pyramid(), 1e-9), CIDException);
}

TEST(MeshAsScan, IsReadByItsNameOrWhereASpacingIsGiven)
{
  const TemporaryFolder folder;
  std::string said;
  const RemarkCallback remark = [&](const std::string& text) { said += text + "\n"; };
  for (const MeshFile& mesh : meshFiles()) {
    const std::string path = folder.file(mesh.file);
    writeText(path, mesh.content);
    const LabelledCloud sampled = readScan(path, {"", remark, 1.0, 0.25});
    EXPECT_GT(sampled.size(), 50u);
    EXPECT_LT(sampled.size(), 300u);
    EXPECT_NE(said.find("6 triangles, is sampled with a spacing of 0.25"),
              std::string::npos)
        << said;
  }
  const std::string ply = folder.file("a.ply");
  EXPECT_EQ(readScan(ply).size(), 5u); // its vertices
  EXPECT_THROW(readScan(folder.file("a.pcd"), {"", {}, 1.0, 0.25}), CIDException);
  EXPECT_THROW(readScan(ply, {"", {}, 1.0, -0.25}), CIDException);
  EXPECT_THROW(readScan(ply, {"", {}, 0.0, 0.0}), CIDException);
}

TEST(ScaledScan, HasMetersAndKeepsItsFields)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("mm.xyz");
  writeText(path, "1000 -2000 3.5\n4 5 6\n");
  const LabelledCloud cloud = readScan(path, {"", {}, 0.001, 0.0});
  const CloudPoints points = pointsOf(cloud);
  EXPECT_FLOAT_EQ((*points.points)[0].x, 1.0f);
  EXPECT_FLOAT_EQ((*points.points)[0].y, -2.0f);
  EXPECT_FLOAT_EQ((*points.points)[1].z, 0.006f);
  EXPECT_EQ(valuesOf<float>(cloud.fields, "x"), (std::vector<float>{1000, 4}));
}

} // namespace
} // namespace pcl_cid::test
