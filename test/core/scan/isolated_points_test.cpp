/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Isolated points: stray ones are, those of a sparse wall are not.
 */

#include "clouds.h"
#include "scan/isolated_points.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

constexpr int least = 4;

/** A wall in the plane x = \a x. */
Points
wall(int side, float spacing, float x)
{
  Points points;
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k)
      points.emplace_back(
          x, spacing * static_cast<float>(i), spacing * static_cast<float>(k));
  return points;
}

pcl::Indices
isolatedOf(const Points& points, int near = least)
{
  ExecutionOptions execution;
  execution.threads = 1; // they are too few for more
  return isolatedPoints(points, NearestNeighbors(points, execution), near);
}

TEST(IsolatedPoints, AreStrayPointsAndPairsButNoSparseWall)
{
  Points points = wall(40, 0.01f, 1.0f);
  const Points sparse = wall(10, 0.5f, 30.0f); // 50 times the spacing
  points.insert(points.end(), sparse.begin(), sparse.end());
  const auto first = static_cast<pcl::index_t>(points.size());
  points.emplace_back(0.5f, 0.2f, 0.2f);
  points.emplace_back(0.8f, 0.1f, 0.3f);
  points.emplace_back(0.8f, 0.1f, 0.301f);
  EXPECT_EQ(isolatedOf(points), (pcl::Indices{first, first + 1, first + 2}));
}

TEST(IsolatedPoints, StayIsolatedWhenTheyAreDoubled)
{
  Points points = wall(20, 0.01f, 1.0f);
  points.emplace_back(0.5f, 0.2f, 0.2f);
  const std::size_t once = points.size();
  for (int copy = 1; copy < 10; ++copy)
    points.push_back(points[once - 1]);
  const pcl::Indices isolated = isolatedOf(points);
  ASSERT_EQ(isolated.size(), 10u);
  EXPECT_EQ(isolated.front(), static_cast<pcl::index_t>(once - 1));
}

/// By hand: seven points in a row stand 1 apart, and one stands alone. The row's points
/// reach the lone one as the last, so there is nothing to compare with: with nine
/// places, not eight, spacings begin to tell.
TEST(IsolatedPoints, AreNoneOfFewerThanNinePlaces)
{
  Points points;
  for (int i = 0; i < 7; ++i)
    points.emplace_back(static_cast<float>(i), 0.0f, 0.0f);
  points.emplace_back(1000.0f, 0.0f, 0.0f);
  points.push_back(points.front());
  EXPECT_TRUE(isolatedOf(points).empty());
}

class IsolatedOfPoints : public testing::TestWithParam<NamedPoints> {};

TEST_P(IsolatedOfPoints, AreAscendingAndNeverAll)
{
  const Points& points = GetParam().points;
  for (const int near : {1, least, static_cast<int>(NearestNeighbors::most_near)}) {
    const pcl::Indices isolated = isolatedOf(points, near);
    EXPECT_LT(isolated.size(), points.size());
    EXPECT_TRUE(std::is_sorted(isolated.begin(), isolated.end()));
  }
  EXPECT_TRUE(isolatedOf(points, 0).empty());
}

INSTANTIATE_TEST_SUITE_P(AllClouds,
                         IsolatedOfPoints,
                         testing::ValuesIn(allClouds()),
                         [](const auto& info) { return info.param.name; });

TEST(IsolatedPoints, AreNoneOfAnEvenSurface)
{
  EXPECT_TRUE(isolatedOf(twoBoxes(5000, 3)).empty());
}

TEST(IsolatedPoints, NeedANumberOfNeighborsThatIsLookedFor)
{
  const Points points = twoBoxes(100, 3);
  EXPECT_THROW(isolatedOf(points, -1), CIDException);
  EXPECT_THROW(isolatedOf(points, static_cast<int>(NearestNeighbors::most_near) + 1),
               CIDException);
}

} // namespace
} // namespace pcl_cid::test
