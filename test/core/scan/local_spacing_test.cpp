/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Local spacing: what it is, and when a cloud is uneven.
 */

#include "base/random.h"
#include "clouds.h"
#include "colored_room.h"
#include "scan/isolated_points.h"
#include "scan/local_spacing.h"
#include "scan_kinds.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** A square lattice in the plane z = 0. */
Points
lattice(int side, float spacing, float x0)
{
  Points points;
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k)
      points.emplace_back(
          x0 + spacing * static_cast<float>(i), spacing * static_cast<float>(k), 0.0f);
  return points;
}

Points
operator+(Points a, const Points& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

float
uniform(RandomGenerator& generator)
{
  return static_cast<float>(drawBelow(generator, 1u << 24)) / (1u << 24);
}

/** Points of a square of 1 metre, drawn evenly. */
Points
evenSquare(std::size_t count)
{
  RandomGenerator generator(1);
  Points points;
  while (points.size() < count) {
    const float x = uniform(generator);
    points.emplace_back(x, uniform(generator), 0.0f);
  }
  return points;
}

/** A floor as one depth camera above it sees it: equal angles, 1.5 m up, from 0.5 m to
 *  6 m away. */
Points
floorInOneView(int side)
{
  Points points;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double angle = std::atan(1.5 / 6.0) +
                           (std::atan(1.5 / 0.5) - std::atan(1.5 / 6.0)) * row / side;
      const double range = 1.5 / std::tan(angle);
      points.emplace_back(static_cast<float>(range),
                          static_cast<float>(range * (column - side / 2) / side),
                          0.0f);
    }
  return points;
}

NearestNeighbors
neighborsOf(const Points& points)
{
  ExecutionOptions execution;
  execution.threads = 1; // they are too few for more
  return NearestNeighbors(points, execution);
}

/// By hand: an inner point of a lattice has four neighbors at 1 and four at the
/// diagonal. The lattice that is twice as wide has twice as much, and the median is
/// that of the larger of the two.
TEST(LocalSpacing, IsRelativeToTheMedian)
{
  const int side = 30;
  const Points points = lattice(side, 0.125f, 0.0f) + lattice(side / 2, 0.25f, 128.0f);
  const std::vector<float> spacing = localSpacing(neighborsOf(points), 1.0f);
  EXPECT_EQ(spacing[side * 10 + 10], 1.0f);
  EXPECT_EQ(spacing[static_cast<std::size_t>(side * side + side / 2 * 5 + 5)], 2.0f);
}

TEST(LocalSpacing, IsTakenToThePower)
{
  const NearestNeighbors neighbors = neighborsOf(twoBoxes(500, 3));
  const std::vector<float> spacing = localSpacing(neighbors, 1.0f);
  const std::vector<float> squared = localSpacing(neighbors, 2.0f);
  for (std::size_t i = 0; i < spacing.size(); ++i)
    ASSERT_FLOAT_EQ(squared[i], spacing[i] * spacing[i]);
  EXPECT_EQ(localSpacing(neighbors, 0.0f), std::vector<float>(500, 1.0f));
}

/// The lattices differ 100 times in spacing; the finer one counts as a fifth.
TEST(LocalSpacing, IsClampedBelow)
{
  const Points points = lattice(30, 1.0f, 0.0f) + lattice(10, 0.01f, 100.0f);
  const std::vector<float> spacing = localSpacing(neighborsOf(points), 1.0f);
  EXPECT_EQ(*std::min_element(spacing.begin(), spacing.end()), least_spacing);
}

class SpacingOfPoints : public testing::TestWithParam<NamedPoints> {};

TEST_P(SpacingOfPoints, IsAboveZeroAndFinite)
{
  const NearestNeighbors neighbors = neighborsOf(GetParam().points);
  for (const float spacing : localSpacing(neighbors, 1.0f))
    ASSERT_TRUE(spacing >= least_spacing && spacing <= most_spacing) << spacing;
  for (const float spacing : localSpacing(neighbors, 4.0f))
    ASSERT_TRUE(spacing > 0.0f && std::isfinite(spacing)) << spacing;
  const float spread = spacingSpread(neighbors, {});
  EXPECT_TRUE(spread >= 0.0f && std::isfinite(spread)) << spread;
}

INSTANTIATE_TEST_SUITE_P(AllClouds,
                         SpacingOfPoints,
                         testing::ValuesIn(allClouds()),
                         [](const auto& info) { return info.param.name; });

TEST(LocalSpacing, RefusesABadPower)
{
  const NearestNeighbors neighbors = neighborsOf(twoBoxes(100, 3));
  EXPECT_THROW(localSpacing(neighbors, -1.0f), CIDException);
  EXPECT_THROW(localSpacing(neighbors, NAN), CIDException);
  EXPECT_THROW(localSpacing(neighbors, 4.5f), CIDException);
}

/// The squared distance to the eighth of points that are even in a plane follows
/// Gamma(8), whose quantiles are 4.656 and 11.771; regions differ by less than a tenth.
TEST(SpacingSpread, OfEvenPointsIsThatOfTheirDistribution)
{
  const float spread = spacingSpread(neighborsOf(evenSquare(20000)), {});
  EXPECT_GE(spread, std::sqrt(4.656 / 11.771));
  EXPECT_LT(spread, 1.2 * std::sqrt(4.656 / 11.771));
}

/// As the vertices of a mesh: a wide lattice everywhere, and a fine one around each
/// seventh point of it.
TEST(SpacingSpread, FromPointToPointDoesNotCount)
{
  Points points = lattice(120, 0.125f, 0.0f);
  const Points wide = points;
  for (std::size_t i = 0; i < wide.size(); i += 7)
    for (int k = 1; k < 6; ++k)
      points.emplace_back(wide[i] + Eigen::Vector3f(0.0f, 0.01f * float(k), 0.0f));
  const NearestNeighbors neighbors = neighborsOf(points);
  const std::vector<float> spacing = localSpacing(neighbors, 1.0f);
  const auto [least, most] = std::minmax_element(spacing.begin(), spacing.end());
  EXPECT_GE(*most / *least, 2.0f);
  EXPECT_LT(spacingSpread(neighbors, {}), uneven_spread);
}

TEST(SpacingSpread, OfOnePlaceIsNone)
{
  EXPECT_EQ(spacingSpread(neighborsOf(Points(5, Eigen::Vector3f::Ones())), {}), 0.0f);
  EXPECT_EQ(spacingSpread(neighborsOf({}), {}), 0.0f);
}

/// By hand: half of the area has one spacing, and half three times that; the borders
/// and the sparsest points are less than a tenth. Within a region there is no
/// difference, which counts as 1.4.
TEST(SpacingSpread, IsByArea)
{
  const Points points = lattice(240, 0.125f, 0.0f) + lattice(80, 0.375f, 128.0f);
  EXPECT_NEAR(spacingSpread(neighborsOf(points), {}), 3.0f / 1.4f, 1e-4f);
}

TEST(SpacingSpread, OfOneViewOfAFloorIsUneven)
{
  EXPECT_GT(spacingSpread(neighborsOf(floorInOneView(100)), {}), uneven_spread);
}

/// Just under 2 % of the points, in a region of their own, stand for as much area as
/// all others.
TEST(SpacingSpread, LeavesOutAFewSparsePoints)
{
  Points points = lattice(100, 0.125f, 0.0f);
  for (int i = 0; i < 200; ++i)
    points.emplace_back(128.0f + 0.25f * static_cast<float>(i), 0.0f, 0.0f);
  EXPECT_LT(spacingSpread(neighborsOf(points), {}), uneven_spread);
  for (int i = 0; i < 1000; ++i)
    points.emplace_back(128.0f + 0.25f * static_cast<float>(i), 64.0f, 0.0f);
  EXPECT_GT(spacingSpread(neighborsOf(points), {}), uneven_spread);
}

TEST(SpacingSpread, LeavesOutWhatItIsTold)
{
  Points points = lattice(100, 0.125f, 0.0f);
  pcl::Indices stray;
  for (int i = 0; i < 1200; ++i) {
    stray.push_back(static_cast<pcl::index_t>(points.size()));
    points.emplace_back(128.0f + 0.25f * static_cast<float>(i), 0.0f, 0.0f);
  }
  const NearestNeighbors neighbors = neighborsOf(points);
  EXPECT_GT(spacingSpread(neighbors, {}), uneven_spread);
  EXPECT_LT(spacingSpread(neighbors, stray), uneven_spread);
}

/// A cloud whose points are all there several times has the spread of its places.
TEST(SpacingSpread, OfDoubledPointsIsTheSame)
{
  const Points points = floorInOneView(60);
  EXPECT_EQ(spacingSpread(neighborsOf(points + points), {}),
            spacingSpread(neighborsOf(points), {}));
}

TEST(SpacingSpread, OfGeneratedScansIsByTheSensor)
{
  for (const std::uint64_t seed : {4u, 5u}) {
    const ColoredRoom room = makeColoredRoom(seed);
    const auto spread = [&](ScanKind kind) {
      LabelledScan scan = choosePoints(room.scene, kind, 20000, seed);
      disturb(scan, usualErrors(kind), seed);
      return spacingSpread(neighborsOf(scan.points), {});
    };
    EXPECT_LT(spread(ScanKind::even), uneven_spread);
    EXPECT_LT(spread(ScanKind::mesh_vertices), uneven_spread);
    EXPECT_GT(spread(ScanKind::sensor), uneven_spread);
    EXPECT_GT(spread(ScanKind::merged), uneven_spread);
    EXPECT_GT(spread(ScanKind::single_view), uneven_spread);
    EXPECT_GT(spread(ScanKind::lidar), uneven_spread);
  }
}

/// All of these are of sensors.
TEST(SpacingSpread, OfScansIsAsTheyWereMade)
{
  for (const char* name : {"milk_cartoon_all_small_clorox.pcd",
                           "mosd_learn13.pcd",
                           "mosd_learn24.pcd",
                           "mosd_learn4.pcd",
                           "mosd_learn41.pcd",
                           "office1.pcd",
                           "region_growing_tutorial.pcd",
                           "room_scan1.pcd",
                           "table_scene_mug_stereo_textured.pcd",
                           "terrain_csite3_utm.pcd"}) {
    const auto scan = loadSharedScan(name);
    if (!scan)
      GTEST_SKIP() << "the scans of ../shared/data are not here";
    Points points;
    for (const pcl::PointXYZ& p : *scan)
      if (p.getVector3fMap().allFinite())
        points.push_back(p.getVector3fMap());
    const NearestNeighbors neighbors = neighborsOf(points);
    const pcl::Indices isolated =
        isolatedPoints(points, neighbors, setting::isolated_neighbors.initial);
    EXPECT_GT(spacingSpread(neighbors, isolated), uneven_spread) << name;
  }
}

} // namespace
} // namespace pcl_cid::test
