/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Nearest neighbors against a search of all points.
 */

#include "clouds.h"
#include "prepared_points.h"
#include "scan/nearest_neighbors.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** The first point of each place. */
pcl::Indices
placesOf(const Points& points)
{
  pcl::Indices places;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::find(points.begin(),
                  points.begin() + static_cast<std::ptrdiff_t>(i),
                  points[i]) == points.begin() + static_cast<std::ptrdiff_t>(i))
      places.push_back(static_cast<pcl::index_t>(i));
  return places;
}

/** Neighbors by looking at all places. */
pcl::Indices
neighborsByBruteForce(const Points& points,
                      const pcl::Indices& places,
                      std::size_t i,
                      std::size_t wanted)
{
  std::vector<std::tuple<float, pcl::index_t>> found;
  for (const pcl::index_t place : places) {
    const Eigen::Vector3f& q = points[static_cast<std::size_t>(place)];
    const Eigen::Vector3f d = points[i] - q;
    if (q != points[i])
      found.emplace_back((d.x() * d.x() + d.y() * d.y()) + d.z() * d.z(), place);
  }
  std::sort(found.begin(), found.end());
  pcl::Indices neighbors;
  for (std::size_t k = 0; k < std::min(found.size(), wanted); ++k)
    neighbors.push_back(std::get<1>(found[k]));
  return neighbors;
}

pcl::Indices
neighborsOf(const NearestNeighbors& neighbors, std::size_t i)
{
  pcl::Indices found;
  for (std::size_t k = 0; k < neighbors.count(); ++k)
    found.push_back(neighbors.neighbor(i, k));
  return found;
}

class NeighborsOfPoints : public testing::TestWithParam<NamedPoints> {};

TEST_P(NeighborsOfPoints, AreThoseOfASearchOfAllPlaces)
{
  const Points& points = GetParam().points;
  const pcl::Indices places = placesOf(points);
  const std::size_t near = std::min(NearestNeighbors::most_near, places.size() - 1);
  for (const std::size_t wanted :
       {NearestNeighbors::most_near, NearestNeighbors::most}) {
    const NearestNeighbors neighbors(points, onThreads(1), wanted);
    ASSERT_EQ(neighbors.size(), points.size());
    ASSERT_EQ(neighbors.count(), std::min(wanted, places.size() - 1));
    ASSERT_EQ(neighbors.nearCount(), near);
    const std::size_t stride = std::max<std::size_t>(1, points.size() / 200);
    for (std::size_t i = 0; i < points.size(); i += stride) {
      const pcl::Indices expected = neighborsByBruteForce(points, places, i, wanted);
      ASSERT_EQ(neighborsOf(neighbors, i), expected) << i;
      const float reach =
          near == 0 ? 0.0f
                    : (points[i] - points[static_cast<std::size_t>(expected[near - 1])])
                          .norm();
      ASSERT_EQ(neighbors.reach(i), reach) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllClouds,
                         NeighborsOfPoints,
                         testing::ValuesIn(allClouds()),
                         [](const auto& info) { return info.param.name; });

/// By hand: on a line at 0, 1, 2 ... the fourth neighbors of an inner point are two
/// away on either side, so the eighth is four away; at an end it is eight away.
TEST(NearestNeighbors, ReachTheEighthOnALine)
{
  Points line;
  for (int i = 0; i < 20; ++i)
    line.emplace_back(static_cast<float>(i), 0.0f, 0.0f);
  const NearestNeighbors neighbors(line, onThreads(1));
  EXPECT_EQ(neighbors.reach(10), 4.0f);
  EXPECT_EQ(neighbors.reach(0), 8.0f);
  EXPECT_EQ(neighborsOf(neighbors, 10), (pcl::Indices{9, 11, 8, 12, 7, 13, 6, 14}));
}

TEST(NearestNeighbors, AreTheSamePlacesWhenPointsAreDoubled)
{
  const Points points = twoBoxes(500, 3);
  Points doubled = points;
  doubled.insert(doubled.end(), points.begin(), points.end());
  const NearestNeighbors once(points, onThreads(1));
  const NearestNeighbors twice(doubled, onThreads(1));
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(neighborsOf(twice, i), neighborsOf(once, i));
    EXPECT_EQ(neighborsOf(twice, points.size() + i), neighborsOf(once, i));
  }
}

TEST(NearestNeighbors, OfNoPointsAreNone)
{
  EXPECT_EQ(NearestNeighbors({}, onThreads(1)).size(), 0u);
}

TEST(NearestNeighborsThreads, GiveTheSameNeighbors)
{
  const Points points = randomCube(3000, 5);
  const NearestNeighbors expected(points, onThreads(1));
  for (const unsigned int threads : {2u, 3u, 8u}) {
    const NearestNeighbors neighbors(points, onThreads(threads));
    for (std::size_t i = 0; i < points.size(); ++i)
      ASSERT_EQ(neighborsOf(neighbors, i), neighborsOf(expected, i));
  }
}

TEST(NearestNeighborsThreads, AreCancelled)
{
  ExecutionOptions execution = onThreads(2);
  execution.progress = [](double) { return false; };
  EXPECT_THROW(NearestNeighbors(randomCube(3000, 5), execution), CIDCancelled);
}

} // namespace
} // namespace pcl_cid::test
