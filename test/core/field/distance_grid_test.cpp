/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Certified bounds are bounds, and what the grid answers is exact.
 */

#include "field/distance_grid.h"

#include "clouds.h"

#include "base/random.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

constexpr std::size_t plenty = std::size_t{1} << 30;

/** A tree and a grid over it. */
struct Indexed {
  Progress silent{{}};
  BlockTree tree;
  DistanceGrid grid;

  explicit Indexed(const Points& points, std::size_t budget = plenty, int threads = 2)
  : tree(points, threads, silent), grid(tree, budget, threads, silent)
  {
  }

  float
  squaredDistance(const Eigen::Vector3f& x) const
  {
    BlockTree::Nearest nearest;
    tree.descend(1, padded(x), nearest);
    return nearest.squared_distance;
  }

  double
  distance(const Eigen::Vector3f& x) const
  {
    return std::sqrt(static_cast<double>(squaredDistance(x)));
  }
};

/** Even, uneven and blown-up clouds. */
std::vector<NamedPoints>
clouds()
{
  Points uneven = twoBoxes(20000, 131);
  for (std::size_t i = 0; i < uneven.size(); ++i)
    if (i % 2 == 0)
      uneven[i] = 0.01f * uneven[i] + Eigen::Vector3f(0.3f, 0.2f, 0.1f);
  Points outliers = twoBoxes(20000, 132);
  outliers.emplace_back(3000.0f, -2000.0f, 1000.0f);
  outliers.emplace_back(-2500.0f, 900.0f, 50.0f);
  Points repeated = randomCube(20, 133);
  for (int i = 0; i < 10; ++i)
    repeated.insert(repeated.end(), repeated.begin(), repeated.begin() + 20);
  std::vector<NamedPoints> all = allClouds();
  all.push_back({"large", twoBoxes(30000, 134)});
  all.push_back({"uneven", uneven});
  all.push_back({"outliers", outliers});
  all.push_back({"repeated", repeated});
  return all;
}

/** On segments between points, near points, and anywhere in and around the box. */
Points
probes(const Points& points, std::size_t count, std::uint64_t seed)
{
  RandomGenerator generator(seed);
  const auto unit = [&] {
    return static_cast<float>(drawBelow(generator, 1 << 20)) / (1 << 20);
  };
  const auto any = [&] { return points[drawBelow(generator, points.size())]; };
  Points result;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3f p = any(), q = any();
    const Eigen::Vector3f jitter(unit() - 0.5f, unit() - 0.5f, unit() - 0.5f);
    result.push_back(p + unit() * (q - p));
    result.push_back(p + 0.01f * jitter);
    result.push_back(p + 20.0f * jitter);
  }
  return result;
}

class GridOfClouds : public testing::TestWithParam<NamedPoints> {};

TEST_P(GridOfClouds, BoundsHoldAtEveryProbe)
{
  const Indexed indexed(GetParam().points);
  std::size_t violated = 0;
  for (const Eigen::Vector3f& x : probes(GetParam().points, 40000, 135)) {
    const DistanceBounds bounds = indexed.grid.look(x).bounds;
    const double d = indexed.distance(x);
    violated += static_cast<double>(bounds.low) > d;
    violated += static_cast<double>(bounds.high) < d;
    EXPECT_EQ(indexed.grid.lowerBound(x), bounds.low);
    const double likely = (x - indexed.grid.likelyNearest(x)).cast<double>().norm();
    violated += static_cast<double>(bounds.high) < likely;
  }
  EXPECT_EQ(violated, 0u);
}

TEST_P(GridOfClouds, AnswersAreExactToTheBit)
{
  const Indexed indexed(GetParam().points);
  std::size_t wrong = 0;
  std::size_t answered = 0;
  const Points x = probes(GetParam().points, 10000, 136);
  for (const Eigen::Vector3f& probe : x) {
    const BlockTree::Nearest nearest = indexed.grid.nearest(probe);
    if (nearest.slot < 0)
      continue;
    ++answered;
    wrong += nearest.squared_distance != indexed.squaredDistance(probe);
    // The point is that near, up to the order in which its squares are added.
    const float apart = (probe - indexed.tree.position(nearest.slot)).norm();
    wrong += std::abs(apart - std::sqrt(nearest.squared_distance)) > 1e-6f * apart;
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_GT(answered, x.size() / 20) << "the grid must answer near the surface";
}

TEST_P(GridOfClouds, LittleMemoryIsKeptToAndChangesNoAnswer)
{
  const Indexed rich(GetParam().points);
  for (const std::size_t budget :
       {std::size_t{1}, std::size_t{4096}, std::size_t{100000}}) {
    const Indexed poor(GetParam().points, budget);
    // Every piece of the even grid may overrun by one division and its lists.
    EXPECT_LE(poor.grid.bytes(), budget + 512 * 8 * (8 + 4 * 130));
    for (const Eigen::Vector3f& x : probes(GetParam().points, 200, 137)) {
      const DistanceBounds bounds = poor.grid.look(x).bounds;
      const double d = rich.distance(x);
      EXPECT_LE(static_cast<double>(bounds.low), d);
      EXPECT_GE(static_cast<double>(bounds.high), d);
      const BlockTree::Nearest nearest = poor.grid.nearest(x);
      if (nearest.slot >= 0) {
        EXPECT_EQ(nearest.squared_distance, rich.squaredDistance(x));
      }
    }
  }
}

TEST_P(GridOfClouds, IsTheSameForEveryNumberOfThreads)
{
  const Indexed serial(GetParam().points, plenty, 1);
  const Points x = probes(GetParam().points, 500, 138);
  for (const int threads : {2, 3, 8}) {
    const Indexed parallel(GetParam().points, plenty, threads);
    EXPECT_EQ(parallel.grid.bytes(), serial.grid.bytes());
    for (const Eigen::Vector3f& probe : x) {
      EXPECT_EQ(parallel.grid.look(probe).bounds.low,
                serial.grid.look(probe).bounds.low);
      EXPECT_EQ(parallel.grid.look(probe).bounds.high,
                serial.grid.look(probe).bounds.high);
      EXPECT_EQ(parallel.grid.nearest(probe).slot, serial.grid.nearest(probe).slot);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Clouds,
                         GridOfClouds,
                         testing::ValuesIn(clouds()),
                         [](const auto& info) { return info.param.name; });

TEST(DistanceGrid, CellsAreSmallOnlyWhereSegmentsPass)
{
  // Two walls: what is between them is in their box, what is behind them is in the
  // cube of the grid alone.
  Points walls = randomCube(20000, 139);
  for (std::size_t i = 0; i < walls.size(); ++i)
    walls[i].x() = i % 2 == 0 ? 0.0f : 0.5f;
  const Indexed indexed(walls);
  double between = 0.0, behind = 0.0;
  for (const Eigen::Vector3f& wall : randomCube(2000, 141)) {
    const auto gap = [&](float x) {
      const Eigen::Vector3f probe(x, wall.y(), wall.z());
      return static_cast<double>(indexed.grid.look(probe).bounds.high) -
             indexed.distance(probe);
    };
    between += gap(0.49f);
    behind += gap(0.51f);
  }
  EXPECT_LT(2.0 * between, behind);
}

TEST(DistanceGrid, BoundsAreTightNearTheSurface)
{
  // Otherwise they would be certified but useless.
  const Points points = twoBoxes(30000, 139);
  const Indexed indexed(points);
  double gap = 0.0;
  const Points x = probes(points, 3000, 140);
  for (const Eigen::Vector3f& probe : x)
    gap += static_cast<double>(indexed.grid.look(probe).bounds.high) -
           indexed.distance(probe);
  const double spacing = std::sqrt(12.0 / 30000.0);
  EXPECT_LT(gap / static_cast<double>(x.size()), 2.0 * spacing);
}

TEST(DistanceGrid, BoundsHoldOnRealScans)
{
  for (const char* name : {"office1.pcd", "room_scan1.pcd"}) {
    const auto scan = loadSharedScan(name);
    if (!scan)
      GTEST_SKIP() << "../shared/data/" << name << " is absent";
    const Points points = crop(*scan, 50000, 2);
    const Indexed indexed(points);
    std::size_t violated = 0;
    for (const Eigen::Vector3f& x : probes(points, 30000, 141)) {
      const DistanceBounds bounds = indexed.grid.look(x).bounds;
      const double d = indexed.distance(x);
      violated += static_cast<double>(bounds.low) > d;
      violated += static_cast<double>(bounds.high) < d;
    }
    EXPECT_EQ(violated, 0u) << name;
  }
}

} // namespace
} // namespace pcl_cid::test
