/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Neighbors, wrong regions and inmost points, against brute force.
 */

#include "annotation/wrong_regions.h"
#include "clouds.h"
#include "literal_regions.h"
#include "prepared_points.h"
#include "scan/nearest_neighbors.h"
#include "session/inmost_point.h"
#include "session/radius_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** A dense cube, a sparse one, and each tenth point of it twice. */
Points
unevenPoints(std::uint64_t seed)
{
  Points points = randomCube(150, seed);
  for (const Eigen::Vector3f& p : randomCube(60, seed + 1))
    points.push_back(4.0f * p + Eigen::Vector3f(1.2f, 0.0f, 0.0f));
  for (std::size_t i = 0; i < 200; i += 10)
    points.push_back(points[i]);
  return points;
}

Labels
randomLabels(std::size_t size, std::uint32_t most, std::uint64_t seed)
{
  std::mt19937_64 generator(seed);
  Labels labels(size);
  for (std::uint32_t& label : labels)
    label = static_cast<std::uint32_t>(generator() % (most + 1));
  return labels;
}

class RegionsOfClouds : public testing::TestWithParam<std::uint64_t> {
protected:
  const Points points_ = unevenPoints(GetParam());
  Progress silent_{{}};
  const BlockTree tree_{points_, 1, silent_};
  const RadiusGraph graph_{points_, tree_, onThreads(1)};
};

TEST_P(RegionsOfClouds, NeighborsAreWithinTwoSpacingsOfEachOther)
{
  const NearestNeighbors nearest(points_, onThreads(1));
  const std::vector<std::set<std::size_t>> expected = literalNeighbors(points_);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    std::set<std::size_t> earlier;
    for (const pcl::index_t j : graph_.earlierNeighbors(i))
      EXPECT_TRUE(earlier.insert(static_cast<std::size_t>(j)).second);
    std::set<std::size_t> expected_earlier;
    for (const std::size_t j : expected[i])
      if (j < i)
        expected_earlier.insert(j);
    EXPECT_EQ(earlier, expected_earlier) << i;
  }
}

TEST_P(RegionsOfClouds, TheLargestConnectedOneIsThatOfAFlood)
{
  const std::vector<std::set<std::size_t>> neighbors = literalNeighbors(points_);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Labels truth = randomLabels(points_.size(), 3, seed);
    const Labels labels = randomLabels(points_.size(), 1, seed + 100);
    EXPECT_EQ(largestConnectedWrongRegion(graph_, truth, labels),
              literalWrongRegion(neighbors, truth, labels));
  }
}

TEST_P(RegionsOfClouds, RegionsOfPairsAreAllThatIsWrong)
{
  const Labels truth = randomLabels(points_.size(), 3, 5);
  const Labels labels = randomLabels(points_.size(), 3, 6);
  std::set<pcl::index_t> seen;
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const pcl::Indices& region : wrongRegions(truth, labels)) {
    const auto first = static_cast<std::size_t>(region.front());
    EXPECT_TRUE(pairs.insert({truth[first], labels[first]}).second);
    EXPECT_TRUE(std::is_sorted(region.begin(), region.end()));
    for (const pcl::index_t point : region) {
      const auto i = static_cast<std::size_t>(point);
      EXPECT_EQ(truth[i], truth[first]);
      EXPECT_EQ(labels[i], labels[first]);
      EXPECT_TRUE(seen.insert(point).second);
    }
  }
  for (std::size_t i = 0; i < points_.size(); ++i)
    EXPECT_EQ(seen.count(static_cast<pcl::index_t>(i)) > 0,
              truth[i] != 0 && truth[i] != labels[i]);
}

TEST_P(RegionsOfClouds, InmostPointsAreThoseOfBruteForceOnThreads)
{
  InmostPoints inmost_points(points_, tree_);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Labels truth = randomLabels(points_.size(), 4, seed);
    if (seed % 2 == 0) // regions that have an inside
      for (std::size_t i = 0; i < truth.size(); ++i)
        truth[i] = static_cast<std::uint32_t>(points_[i].x() * 3.0f);
    const std::vector<pcl::Indices> regions =
        wrongRegions(truth, Labels(points_.size(), 0));
    for (const unsigned int threads : {1u, 3u}) {
      const std::vector<InmostPoint> found = inmost_points.of(regions, threads);
      ASSERT_EQ(found.size(), regions.size());
      for (std::size_t r = 0; r < regions.size(); ++r) {
        const InmostPoint expected = literalInmostPoint(points_, regions[r]);
        EXPECT_EQ(found[r].point, expected.point);
        EXPECT_EQ(found[r].squared_distance, expected.squared_distance);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, RegionsOfClouds, testing::Values(1, 2, 3));

TEST(InmostPoints, OfARegionWithoutAnOutsideIsItsFirstPoint)
{
  const Points points = randomCube(40, 3);
  Progress silent{{}};
  const BlockTree tree(points, 1, silent);
  pcl::Indices all(points.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = static_cast<pcl::index_t>(i);
  const InmostPoint found = InmostPoints(points, tree).of({all}, 1).front();
  EXPECT_EQ(found.point, 0);
  EXPECT_TRUE(std::isinf(found.squared_distance));
}

TEST(LargestInstance, IsThatWithMostPointsAndTheLowestLabelOfEquals)
{
  EXPECT_EQ(largestInstance({0, 0, 0, 5, 2, 5, 2}), (pcl::Indices{4, 6}));
  EXPECT_EQ(largestInstance({0, 9, 3, 9}), (pcl::Indices{1, 3}));
  EXPECT_TRUE(largestInstance({0, 0}).empty());
}

TEST(WrongRegions, AreNoneWhereLabelsAreRightOrThereIsNoTruth)
{
  EXPECT_TRUE(wrongRegions({1, 2, 0, 0}, {1, 2, 7, 0}).empty());
  const Points points = randomCube(4, 1);
  Progress silent{{}};
  const BlockTree tree(points, 1, silent);
  const RadiusGraph graph(points, tree, onThreads(1));
  EXPECT_TRUE(largestConnectedWrongRegion(graph, {1, 2, 0, 0}, {1, 2, 7, 0}).empty());
}

} // namespace
} // namespace pcl_cid::test
