/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The draw of the working set, and how its groups reach every point.
 */

#include "clouds.h"

#include "scan/working_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** Points with gaps in their indices, as invalid points leave them. */
PointSet
sparseSet(std::size_t count)
{
  PointSet set;
  set.points = twoBoxes(count, 61);
  for (std::size_t i = 0; i < count; ++i)
    set.source.push_back(static_cast<pcl::index_t>(2 * i + 1));
  return set;
}

WorkingSet
draw(const PointSet& set, std::size_t subsample, const pcl::Indices& always, int seed)
{
  RandomGenerator generator(static_cast<std::uint64_t>(seed));
  return WorkingSet(set, {}, {}, subsample, always, generator);
}

TEST(WorkingSet, WithoutSubsampleIsEverything)
{
  const PointSet set = sparseSet(50);
  for (const std::size_t subsample : {0u, 50u, 1000u}) {
    const WorkingSet working = draw(set, subsample, {3}, 0);
    EXPECT_EQ(working.points(), set.points);
    EXPECT_EQ(working.field().size(), set.size());
    EXPECT_EQ(working.indexOf(17), 17);
  }
}

TEST(WorkingSet, DrawsThatManyDistinctPointsWithTheWantedOnes)
{
  const PointSet set = sparseSet(200);
  for (int seed = 0; seed < 20; ++seed) {
    const WorkingSet working = draw(set, 40, {199, 0, 7}, seed);
    EXPECT_EQ(working.points().size(), 40u);
    std::set<pcl::index_t> drawn;
    for (pcl::index_t position = 0; position < 200; ++position)
      if (const pcl::index_t index = working.indexOf(position); index >= 0) {
        drawn.insert(index);
        EXPECT_EQ(working.points()[static_cast<std::size_t>(index)],
                  set.points[static_cast<std::size_t>(position)]);
      }
    EXPECT_EQ(drawn.size(), 40u);
    for (const pcl::index_t wanted : {0, 7, 199})
      EXPECT_GE(working.indexOf(wanted), 0);
  }
}

TEST(WorkingSet, EveryPointIsDrawnEquallyOften)
{
  const PointSet set = sparseSet(100);
  std::vector<int> times(100, 0);
  constexpr int draws = 2000;
  for (int seed = 0; seed < draws; ++seed) {
    const WorkingSet working = draw(set, 25, {}, seed);
    for (pcl::index_t position = 0; position < 100; ++position)
      times[static_cast<std::size_t>(position)] += working.indexOf(position) >= 0;
  }
  for (const int count : times) // 500 expected, standard deviation 19
    EXPECT_NEAR(count, draws / 4, 120);
}

TEST(WorkingSet, CarriesValuesOnToTheNearestPoint)
{
  const PointSet set = sparseSet(150);
  const WorkingSet working = draw(set, 30, {5}, 3);
  std::vector<pcl::index_t> numbers(30);
  std::iota(numbers.begin(), numbers.end(), 0);
  const std::vector<pcl::index_t> carried =
      working.carryOn(numbers, 310, pcl::index_t{-1});
  ASSERT_EQ(carried.size(), 310u);
  EXPECT_EQ(working.cloudIndexOf(working.indexOf(5)), 11);
  for (std::size_t i = 0; i < 310; ++i) {
    if (i % 2 == 0 || i >= 300) {
      EXPECT_EQ(carried[i], -1);
      continue;
    }
    const Eigen::Vector3f p = set.points[i / 2];
    float nearest = std::numeric_limits<float>::infinity();
    for (const Eigen::Vector3f& q : working.points())
      nearest = std::min(nearest, (p - q).norm());
    const auto followed = static_cast<std::size_t>(carried[i]);
    EXPECT_FLOAT_EQ((working.points()[followed] - p).norm(), nearest);
  }
}

TEST(WorkingSet, CarriesEveryValueOnWithoutASubsample)
{
  const PointSet set = sparseSet(20);
  const std::vector<float> carried =
      draw(set, 0, {}, 0).carryOn(std::vector<float>(20, 0.5f), 45, NAN);
  for (std::size_t i = 0; i < 45; ++i)
    EXPECT_EQ(std::isnan(carried[i]), i % 2 == 0 || i >= 40) << i;
}

TEST(WorkingSet, ASurfaceOfItsOwnIsMeasuredAgainst)
{
  const PointSet set = sparseSet(80);
  RandomGenerator generator(0);
  const Points surface = randomCube(33, 62);
  const WorkingSet working(set, {surface, {}}, {}, 20, {}, generator);
  EXPECT_EQ(working.field().size(), 33u);
  EXPECT_EQ(working.points().size(), 20u);
}

} // namespace
} // namespace pcl_cid::test
