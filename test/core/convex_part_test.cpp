/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What every hull guarantees, checked vertex by vertex against face by face.
 */

#include "clouds.h"

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/exceptions.h>

#include <cmath>
#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace pcl_cid::test {
namespace {

PointSet
pointSet(const Points& points)
{
  pcl::Indices indices(points.size());
  std::iota(indices.begin(), indices.end(), 0);
  return PointSet(points, indices);
}

ConvexPart
partOf(const Points& points, double min_thickness = 0.005)
{
  const PointSet set = pointSet(points);
  pcl::Indices members(set.size());
  std::iota(members.begin(), members.end(), 0);
  ConvexPartOptions options;
  options.min_thickness = min_thickness;
  return makeConvexPart(set, members, options);
}

Eigen::Vector3d
normalOf(const TriangleMesh& hull, const std::array<std::uint32_t, 3>& t)
{
  const Eigen::Vector3d& a = hull.vertices[t[0]];
  return (hull.vertices[t[1]] - a).cross(hull.vertices[t[2]] - a);
}

double
diagonalOf(const TriangleMesh& hull)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : hull.vertices)
    box.extend(v);
  return box.diagonal().norm();
}

/** Closed: each directed edge once, and once the other way round. */
void
expectClosed(const TriangleMesh& hull)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : hull.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      ++edges[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  const int euler = static_cast<int>(hull.vertices.size()) -
                    static_cast<int>(edges.size()) / 2 +
                    static_cast<int>(hull.triangles.size());
  EXPECT_EQ(euler, 2);
}

void
expectHullOf(const ConvexPart& part, const Points& points, double min_thickness)
{
  const TriangleMesh& hull = part.hull;
  ASSERT_GE(hull.vertices.size(), 4u);
  expectClosed(hull);
  const double tolerance = 1e-5 * diagonalOf(hull);
  double volume = 0.0;
  const Eigen::Vector3d somewhere = hull.vertices[0];
  for (const auto& t : hull.triangles) {
    const Eigen::Vector3d normal = normalOf(hull, t);
    volume += normal.dot(hull.vertices[t[0]] - somewhere) / 6.0;
    if (normal.norm() < 1e-9 * diagonalOf(hull) * diagonalOf(hull))
      continue;
    const Eigen::Vector3d unit = normal.normalized();
    for (const Eigen::Vector3d& v : hull.vertices)
      EXPECT_LE(unit.dot(v - hull.vertices[t[0]]), tolerance);
    for (const Eigen::Vector3f& p : points)
      EXPECT_LE(unit.dot(p.cast<double>() - hull.vertices[t[0]]), tolerance);
  }
  EXPECT_GT(part.volume, 0.0);
  EXPECT_NEAR(part.volume, volume, 1e-6 * volume);
  EXPECT_GE(part.thickness, (1.0 - 1e-5) * min_thickness);
  EXPECT_GE(part.area, 2.0 * part.volume / diagonalOf(hull));
}

class HullOfClouds : public testing::TestWithParam<NamedPoints> {};

TEST_P(HullOfClouds, ContainsItsPointsAndIsConvexClosedAndThick)
{
  for (const double thickness : {0.005, 0.05}) {
    const ConvexPart part = partOf(GetParam().points, thickness);
    expectHullOf(part, GetParam().points, thickness);
    EXPECT_FALSE(part.boxed);
    EXPECT_EQ(part.indices.size(), GetParam().points.size());
  }
}

TEST_P(HullOfClouds, SameAtUtmCoordinates)
{
  // Coordinates on a quarter-metre grid survive the shift, so the hull must, too.
  Points near = GetParam().points;
  for (Eigen::Vector3f& p : near)
    p = (4.0f * p).array().round() / 4.0f;
  Points far = near;
  const Eigen::Vector3f shift(524288.0f, 1048576.0f, 1024.0f);
  for (Eigen::Vector3f& p : far)
    p += shift;
  const ConvexPart here = partOf(near);
  const ConvexPart there = partOf(far);
  EXPECT_NEAR(here.volume, there.volume, 1e-6 * here.volume);
  ASSERT_EQ(here.hull.vertices.size(), there.hull.vertices.size());
}

INSTANTIATE_TEST_SUITE_P(Clouds,
                         HullOfClouds,
                         testing::ValuesIn(allClouds()),
                         [](const auto& info) { return info.param.name; });

TEST(ConvexPart, UnitCube)
{
  Points corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? 1.0f : 0.0f, i & 2 ? 1.0f : 0.0f, i & 4 ? 1.0f : 0.0f);
  const ConvexPart part = partOf(corners);
  EXPECT_NEAR(part.volume, 1.0, 1e-6);
  EXPECT_NEAR(part.area, 6.0, 1e-6);
  EXPECT_NEAR(part.thickness, 1.0, 1e-6);
  EXPECT_FALSE(part.thickened);
}

TEST(ConvexPart, AFlatSquareBecomesASlab)
{
  const ConvexPart part = partOf({{0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {1, 1, 2}}, 0.01);
  EXPECT_TRUE(part.thickened);
  EXPECT_NEAR(part.volume, 0.01, 1e-6);
  EXPECT_NEAR(part.thickness, 0.01, 1e-6);
  double lowest = 9.0, highest = -9.0; // symmetric about the points
  for (const Eigen::Vector3d& v : part.hull.vertices) {
    lowest = std::min(lowest, v.z());
    highest = std::max(highest, v.z());
  }
  EXPECT_NEAR(0.5 * (lowest + highest), 2.0, 1e-6);
}

TEST(ConvexPart, ASinglePointBecomesACube)
{
  const ConvexPart part = partOf({{1, 2, 3}}, 0.02);
  EXPECT_TRUE(part.thickened);
  EXPECT_NEAR(part.volume, 8e-6, 1e-9);
}

TEST(ConvexPart, SaysNothingOnStderr)
{
  testing::internal::CaptureStderr();
  for (const NamedPoints& cloud : allClouds())
    partOf(cloud.points);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ConvexPart, HullsOfPartsOfARealScan)
{
  for (const char* name :
       {"office1.pcd", "room_scan1.pcd", "region_growing_tutorial.pcd"}) {
    const auto scan = loadSharedScan(name);
    if (!scan)
      GTEST_SKIP() << "../shared/data/" << name << " is absent";
    const Points points = crop(*scan, 3000, 17);
    const float scale =
        std::string(name) == "region_growing_tutorial.pcd" ? 1e3f : 1.0f;
    const double thickness = 0.005 * static_cast<double>(scale);
    expectHullOf(partOf(points, thickness), points, thickness);
  }
}

TEST(ConvexParts, EveryPointOnceAndTheSameForEveryNumberOfThreads)
{
  const Points points = twoBoxes(500, 51);
  const PointSet set = pointSet(points);
  std::vector<int> part(points.size());
  for (std::size_t i = 0; i < part.size(); ++i)
    part[i] = i % 10 == 9 ? -1 : static_cast<int>(i % 2);
  ExecutionOptions execution;
  execution.threads = 1;
  const auto serial = makeConvexParts(set, part, {}, execution);
  ASSERT_EQ(serial.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k)
    for (const pcl::index_t index : serial[k].indices)
      EXPECT_EQ(part[static_cast<std::size_t>(index)], static_cast<int>(k));
  for (const unsigned int threads : {2u, 3u, 8u}) {
    execution.threads = threads;
    const auto parallel = makeConvexParts(set, part, {}, execution);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(parallel[k].hull.vertices, serial[k].hull.vertices);
      EXPECT_EQ(parallel[k].hull.triangles, serial[k].hull.triangles);
    }
  }
}

TEST(ConvexPart, RefusesBadValues)
{
  const PointSet set = pointSet(randomCube(10, 52));
  EXPECT_THROW(makeConvexPart(set, {}, {}), CIDException);
  for (const double thickness : {0.0, -1.0, static_cast<double>(NAN)}) {
    ConvexPartOptions options;
    options.min_thickness = thickness;
    EXPECT_THROW(makeConvexPart(set, {0, 1, 2, 3}, options), CIDException);
  }
}

} // namespace
} // namespace pcl_cid::test
