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
#include "scan/local_spacing.h"

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
  EXPECT_TRUE(spread >= 1.0f && std::isfinite(spread)) << spread;
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
/// Gamma(8); weighted by area, by that square, Gamma(9). Below 14.817, which 98 % of
/// the points do not exceed, are 0.9589 of the area; a tenth of that is below 5.382 and
/// nine tenths below 12.288. The border adds a little.
TEST(SpacingSpread, OfEvenPointsIsThatOfTheirDistribution)
{
  const float spread = spacingSpread(neighborsOf(evenSquare(20000)), {});
  EXPECT_NEAR(spread, std::sqrt(12.288 / 5.382), 0.05);
  EXPECT_LT(spread, uneven_spread);
}

/// By hand: half of the area has one spacing, and half three times that; the borders
/// and the sparsest points are less than a tenth.
TEST(SpacingSpread, IsByArea)
{
  const Points points = lattice(240, 0.125f, 0.0f) + lattice(80, 0.375f, 128.0f);
  EXPECT_NEAR(spacingSpread(neighborsOf(points), {}), 3.0f, 1e-4f);
}

TEST(SpacingSpread, OfOneViewOfAFloorIsUneven)
{
  EXPECT_GT(spacingSpread(neighborsOf(floorInOneView(100)), {}), uneven_spread);
}

/// 24 of 1225 points, just under 2 %, stand for as much area as all others.
TEST(SpacingSpread, LeavesOutAFewSparsePoints)
{
  const Points even = lattice(35, 0.125f, 0.0f);
  Points points = even;
  for (int i = 0; i < 24; ++i)
    points.emplace_back(128.0f + static_cast<float>(i), 0.0f, 0.0f);
  EXPECT_LT(spacingSpread(neighborsOf(points), {}), uneven_spread);
  for (int i = 0; i < 24; ++i)
    points.emplace_back(256.0f + static_cast<float>(i), 0.0f, 0.0f);
  EXPECT_GT(spacingSpread(neighborsOf(points), {}), uneven_spread);
}

TEST(SpacingSpread, LeavesOutWhatItIsTold)
{
  Points points = lattice(35, 0.125f, 0.0f);
  pcl::Indices stray;
  for (int i = 0; i < 48; ++i) {
    stray.push_back(static_cast<pcl::index_t>(points.size()));
    points.emplace_back(128.0f + static_cast<float>(i), 0.0f, 0.0f);
  }
  const NearestNeighbors neighbors = neighborsOf(points);
  EXPECT_GT(spacingSpread(neighbors, {}), uneven_spread);
  EXPECT_LT(spacingSpread(neighbors, stray), uneven_spread);
}

TEST(SpacingSpread, OfScansIsAsTheyWereMade)
{
  for (const char* name : {"office1.pcd", "mosd_learn41.pcd", "room_scan1.pcd"}) {
    const auto scan = loadSharedScan(name);
    if (!scan)
      GTEST_SKIP() << "the scans of ../shared/data are not here";
    Points points;
    for (const pcl::PointXYZ& p : *scan)
      if (p.getVector3fMap().allFinite())
        points.push_back(p.getVector3fMap());
    EXPECT_GT(spacingSpread(neighborsOf(points), {}), uneven_spread) << name;
  }
}

} // namespace
} // namespace pcl_cid::test
