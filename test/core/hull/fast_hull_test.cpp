/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls to compare by: closed, convex, around all points, and as large as qhull's.
 */

#include "hull/clean_hull.h"
#include "hull/fast_hull.h"
#include "hull/hull_mesh.h"
#include "hulls.h"
#include "portable_draw.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

struct SolidCloud {
  std::string name;
  std::vector<Eigen::Vector3d> points;
};

Eigen::Vector3d
drawInCube(RandomGenerator& generator)
{
  const double x = drawUnit(generator);
  const double y = drawUnit(generator);
  const double z = drawUnit(generator);
  return {x, y, z};
}

std::vector<Eigen::Vector3d>
drawnInCube(std::size_t count, std::uint64_t seed)
{
  RandomGenerator generator(seed);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(drawInCube(generator));
  return points;
}

/** All points are corners of the hull. */
std::vector<Eigen::Vector3d>
drawnOnSphere(std::size_t count, std::uint64_t seed)
{
  RandomGenerator generator(seed);
  std::vector<Eigen::Vector3d> points;
  while (points.size() < count) {
    const Eigen::Vector3d p = drawInCube(generator) - Eigen::Vector3d::Constant(0.5);
    if (p.norm() > 0.1 && p.norm() < 0.5)
      points.push_back(p.normalized());
  }
  return points;
}

/** Most of its points are on faces and edges of the hull. */
std::vector<Eigen::Vector3d>
cubeGrid(int side, double step)
{
  std::vector<Eigen::Vector3d> points;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z)
        points.emplace_back(step * x, step * y, step * z);
  return points;
}

/** As the cells of a scan are: a small cube about each of the points. */
std::vector<Eigen::Vector3d>
cubesAround(const std::vector<Eigen::Vector3d>& points, double side)
{
  std::vector<Eigen::Vector3d> corners;
  for (const Eigen::Vector3d& p : points)
    for (const Eigen::Vector3d& corner : cubeGrid(2, side))
      corners.push_back(p + corner);
  return corners;
}

std::vector<Eigen::Vector3d>
mapped(std::vector<Eigen::Vector3d> points, const Eigen::Affine3d& map)
{
  for (Eigen::Vector3d& p : points)
    p = map * p;
  return points;
}

Eigen::Affine3d
anyTurn()
{
  return Eigen::Affine3d(
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.3, -0.5, 0.8).normalized()));
}

std::vector<SolidCloud>
solidClouds()
{
  const Eigen::Affine3d slab(Eigen::Scaling(3.0, 2.0, 1e-3));
  std::vector<SolidCloud> clouds = {
      {"tetrahedron", {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}},
      {"cube", cubeGrid(2, 1.0)},
      {"few", drawnInCube(6, 1)},
      {"random", drawnInCube(500, 2)},
      {"sphere", drawnOnSphere(400, 3)},
      {"grid", cubeGrid(7, 0.1)},
      {"turned_grid", mapped(cubeGrid(7, 0.1), anyTurn())},
      {"slab", mapped(drawnInCube(300, 4), slab)},
      {"turned_slab", mapped(cubeGrid(6, 0.2), anyTurn() * slab)},
      {"needle",
       mapped(drawnInCube(100, 5), Eigen::Affine3d(Eigen::Scaling(1e-3, 1e-3, 1.0)))},
      {"cells", cubesAround(drawnInCube(60, 6), 0.005)},
      {"thick_square",
       cubesAround({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, 0.005)},
      {"thick_point", cubesAround({{0.3, 0.2, 0.1}}, 0.005)},
  };
  std::vector<Eigen::Vector3d> twice = drawnInCube(40, 7);
  twice.insert(twice.end(), twice.begin(), twice.end());
  clouds.push_back({"duplicates", twice});
  const std::size_t basic = clouds.size();
  for (std::size_t i = 0; i < basic; ++i) {
    const SolidCloud& cloud = clouds[i];
    SolidCloud far{cloud.name + "_far", cloud.points};
    for (Eigen::Vector3d& p : far.points)
      p += Eigen::Vector3d(1000.0, -1000.0, 500.0);
    SolidCloud tiny{cloud.name + "_tiny", cloud.points};
    for (Eigen::Vector3d& p : tiny.points)
      p *= 1e-6;
    SolidCloud huge{cloud.name + "_huge", cloud.points};
    for (Eigen::Vector3d& p : huge.points)
      p *= 1e6;
    clouds.insert(clouds.end(), {far, tiny, huge});
  }
  return clouds;
}

double
extentOf(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points)
    box.extend(p);
  return box.diagonal().norm();
}

double
mostOutside(const FastHull& hull, const std::vector<Eigen::Vector3d>& points)
{
  double most = -std::numeric_limits<double>::infinity();
  for (const HalfSpace& face : hull.faces)
    for (const Eigen::Vector3d& p : points)
      most = std::max(most, face.excess(p));
  return most;
}

/** Each side once in either direction, and the neighbor is the face with the other. */
void
expectClosed(const FastHull& hull, const std::string& what)
{
  ASSERT_EQ(hull.triangles.size(), hull.faces.size()) << what;
  ASSERT_EQ(hull.neighbors.size(), hull.faces.size()) << what;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> face_of_side;
  for (std::uint32_t f = 0; f < hull.faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_LT(hull.triangles[f][k], hull.vertices.size()) << what;
      const auto side =
          std::make_pair(hull.triangles[f][k], hull.triangles[f][(k + 1) % 3]);
      ASSERT_TRUE(face_of_side.emplace(side, f).second) << what << ": a side twice";
    }
  for (const auto& [side, face] : face_of_side) {
    const auto back = face_of_side.find({side.second, side.first});
    ASSERT_NE(back, face_of_side.end()) << what << ": an open side";
    const Triangle& triangle = hull.triangles[face];
    const auto k = static_cast<std::size_t>(
        std::find(triangle.begin(), triangle.end(), side.first) - triangle.begin());
    ASSERT_EQ(hull.neighbors[face][k], back->second) << what;
  }
  // One body without holes, of vertices that are all used.
  ASSERT_EQ(hull.vertices.size() + hull.faces.size() - face_of_side.size() / 2, 2u)
      << what;
}

void
expectHullOf(const std::vector<Eigen::Vector3d>& points, const std::string& what)
{
  const FastHull hull = fastHull(points);
  ASSERT_FALSE(hull.faces.empty()) << what;
  expectClosed(hull, what);
  const double extent = extentOf(points);
  EXPECT_LE(mostOutside(hull, points), 1e-8 * extent) << what;
  for (const HalfSpace& face : hull.faces)
    EXPECT_NEAR(face.normal.norm(), 1.0, 1e-12) << what;
  for (std::size_t f = 0; f < hull.faces.size(); ++f)
    for (const std::uint32_t corner : hull.triangles[f])
      EXPECT_NEAR(hull.faces[f].excess(hull.vertices[corner]), 0.0, 1e-8 * extent)
          << what;
  for (const Eigen::Vector3d& v : hull.vertices)
    EXPECT_NE(std::find(points.begin(), points.end(), v), points.end()) << what;
  EXPECT_GT(hull.volume, 0.0) << what;
}

TEST(FastHull, IsClosedAndHoldsAllPoints)
{
  for (const SolidCloud& cloud : solidClouds())
    expectHullOf(cloud.points, cloud.name);
}

TEST(FastHull, IsAsLargeAsQhulls)
{
  for (const SolidCloud& cloud : solidClouds()) {
    const TriangleMesh mesh = convexHull(cloud.points);
    if (mesh.triangles.empty()) // too thin for it
      continue;
    const double volume = volumeOf(mesh);
    EXPECT_NEAR(fastHull(cloud.points).volume, volume, 1e-6 * volume) << cloud.name;
  }
}

TEST(FastHull, VolumesThatAreKnown)
{
  EXPECT_NEAR(fastHull(cubeGrid(2, 2.0)).volume, 8.0, 1e-12);
  EXPECT_NEAR(fastHull(cubeGrid(9, 0.25)).volume, 8.0, 1e-12);
  EXPECT_NEAR(
      fastHull({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}).volume, 1.0, 1e-12);
}

/** Small coordinates make many points repeated, collinear and coplanar. */
TEST(FastHull, ManyRandomCloudsOnGrids)
{
  RandomGenerator generator(11);
  int solid = 0;
  for (int round = 0; round < 3000; ++round) {
    const std::uint64_t count = 1 + drawBelow(generator, 40);
    const std::uint64_t side = 2 + drawBelow(generator, 5);
    std::vector<Eigen::Vector3d> points;
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto x = static_cast<double>(drawBelow(generator, side));
      const auto y = static_cast<double>(drawBelow(generator, side));
      const auto z = static_cast<double>(drawBelow(generator, side));
      points.emplace_back(0.1 * x, 0.1 * y, 0.1 * z);
    }
    if (round % 2 == 1)
      points = mapped(points, anyTurn());
    const std::string what = "round " + std::to_string(round);
    Eigen::MatrixXd differences(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
      differences.col(static_cast<Eigen::Index>(i)) = points[i] - points.front();
    Eigen::FullPivLU<Eigen::MatrixXd> rank(differences);
    rank.setThreshold(1e-6);
    if (rank.rank() == 3) {
      expectHullOf(points, what);
      ++solid;
    }
    else
      EXPECT_TRUE(fastHull(points).faces.empty()) << what;
    if (HasFailure())
      return;
  }
  EXPECT_GT(solid, 2000);
}

TEST(FastHull, ManyRandomSmallClouds)
{
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    const std::vector<Eigen::Vector3d> points = inDouble(randomSmallCloud(seed));
    const FastHull hull = fastHull(points);
    const std::string what = "seed " + std::to_string(seed);
    // Where quickhull is spoiled, it is as exact as the hulls that are handed out.
    if (!hull.faces.empty()) {
      expectClosed(hull, what);
      EXPECT_LE(mostOutside(hull, points), 1e-6 * extentOf(points)) << what;
    }
    // What is made in the fitting: points with some thickness always fill space.
    const FastHull thick =
        fastHull(cubesAround(points, 1e-3 * std::max(1e-3, extentOf(points))));
    ASSERT_FALSE(thick.faces.empty()) << what;
    expectClosed(thick, what);
    EXPECT_LE(mostOutside(thick, points), 1e-6 * extentOf(points)) << what;
    if (HasFailure())
      return;
  }
}

TEST(FastHull, PointsOnOneFaceInAnyOrder)
{
  RandomGenerator generator(12);
  for (int round = 0; round < 200; ++round) {
    std::vector<Eigen::Vector3d> points = cubeGrid(4, 1.0 / 3.0);
    for (std::size_t i = points.size(); i > 1; --i)
      std::swap(points[i - 1], points[drawBelow(generator, i)]);
    const FastHull hull = fastHull(points);
    EXPECT_NEAR(hull.volume, 1.0, 1e-9) << round;
    expectClosed(hull, std::to_string(round));
  }
}

TEST(FastHull, FlatPointsHaveNoFaces)
{
  const Eigen::Vector3d p(0.3, -0.2, 0.7);
  EXPECT_TRUE(fastHull({}).faces.empty());
  for (std::size_t count = 1; count <= 6; ++count) {
    EXPECT_TRUE(fastHull(std::vector<Eigen::Vector3d>(count, p)).faces.empty());
    std::vector<Eigen::Vector3d> line;
    for (std::size_t i = 0; i < count; ++i)
      line.push_back(0.1 * static_cast<double>(i) * p);
    EXPECT_TRUE(fastHull(line).faces.empty()) << count;
  }
  const Eigen::Affine3d flat(Eigen::Scaling(2.0, 1.0, 0.0));
  for (const double scale : {1e-6, 1.0, 1e6})
    for (const auto& points : {drawnInCube(200, 13), cubeGrid(5, 0.25)}) {
      const Eigen::Affine3d map =
          anyTurn() * Eigen::Affine3d(Eigen::Scaling(scale)) * flat;
      EXPECT_TRUE(fastHull(mapped(points, map)).faces.empty());
      EXPECT_TRUE(fastHull(mapped(points, map)).vertices.empty());
      EXPECT_EQ(fastHull(mapped(points, map)).volume, 0.0);
    }
}

TEST(FastHull, MovesAndScalesWithThePoints)
{
  const std::vector<Eigen::Vector3d> points = drawnInCube(300, 14);
  const FastHull hull = fastHull(points);
  for (const double scale : {0x1p-20, 0x1p20}) {
    const FastHull scaled =
        fastHull(mapped(points, Eigen::Affine3d(Eigen::Scaling(scale))));
    EXPECT_EQ(scaled.triangles, hull.triangles);
    EXPECT_DOUBLE_EQ(scaled.volume, scale * scale * scale * hull.volume);
  }
  EXPECT_NEAR(fastHull(mapped(points, anyTurn())).volume, hull.volume, 1e-12);
}

} // namespace
} // namespace pcl_cid::test
