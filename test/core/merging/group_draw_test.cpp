/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Draws that are spread over a group, and the pairs that a lattice takes of them.
 */

#include "clouds.h"
#include "merging/group_draw.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

pcl::Indices
everySecondOf(const Points& points)
{
  pcl::Indices members;
  for (std::size_t i = 0; i < points.size(); i += 2)
    members.push_back(static_cast<pcl::index_t>(i));
  return members;
}

pcl::Indices
draw(const Points& points,
     const pcl::Indices& members,
     std::size_t count,
     std::uint64_t seed = 0)
{
  RandomGenerator generator(seed);
  return drawSpread(points, members, count, generator);
}

TEST(DrawSpread, DrawsSomeOfTheMembersOnceEach)
{
  for (const NamedPoints& cloud : allClouds()) {
    SCOPED_TRACE(cloud.name);
    const pcl::Indices members = everySecondOf(cloud.points);
    for (const std::size_t count : {1u, 2u, 7u, 32u, 100000u}) {
      const pcl::Indices drawn = draw(cloud.points, members, count);
      EXPECT_EQ(drawn.size(), std::min(count, members.size()));
      const std::set<pcl::index_t> once(drawn.begin(), drawn.end());
      EXPECT_EQ(once.size(), drawn.size());
      EXPECT_TRUE(
          std::includes(members.begin(), members.end(), once.begin(), once.end()));
    }
  }
}

TEST(DrawSpread, DrawsFromCellsOfEqualNumbers)
{
  // Along a line, cell after cell, in whatever order the points come.
  Points line;
  for (int i = 0; i < 60; ++i)
    line.emplace_back(0.3f, static_cast<float>(i * 37 % 60), 0.0f);
  pcl::Indices members(line.size());
  std::iota(members.begin(), members.end(), 0);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const pcl::Indices drawn = draw(line, members, 10, seed);
    for (std::size_t cell = 0; cell < drawn.size(); ++cell)
      EXPECT_EQ(std::floor(line[static_cast<std::size_t>(drawn[cell])].y() / 6.0f),
                static_cast<float>(cell));
  }
}

TEST(DrawSpread, DrawsEveryMemberEquallyOften)
{
  const Points points = randomCube(24, 301);
  const pcl::Indices members = everySecondOf(points); // 12, of which 3 are drawn
  std::vector<int> times(points.size(), 0);
  constexpr int draws = 4000;
  for (std::uint64_t seed = 0; seed < draws; ++seed)
    for (const pcl::index_t drawn : draw(points, members, 3, seed))
      ++times[static_cast<std::size_t>(drawn)];
  const double expected = draws * 3.0 / 12.0;
  for (const pcl::index_t member : members)
    EXPECT_NEAR(times[static_cast<std::size_t>(member)],
                expected,
                5.0 * std::sqrt(expected * 0.75));
}

TEST(DrawSpread, DoesNotDependOnTheOrderOfTheMembers)
{
  const Points points = twoBoxes(300, 302);
  pcl::Indices members = everySecondOf(points);
  const pcl::Indices drawn = draw(points, members, 32);
  std::reverse(members.begin(), members.end());
  EXPECT_EQ(draw(points, members, 32), drawn);
}

TEST(PairLattice, HasOnePairInEachRowAndColumn)
{
  for (std::size_t size = 1; size <= 200; ++size) {
    const PairLattice lattice(size);
    std::set<std::size_t> rows;
    for (std::size_t column = 0; column < size; ++column)
      rows.insert(lattice.row(column));
    EXPECT_EQ(rows.size(), size);
    EXPECT_LT(*rows.rbegin(), size);
  }
}

TEST(PairLattice, IsThatOfTheFibonacciNumbers)
{
  for (const auto& [size, step] :
       {std::pair{5u, 3u}, {21u, 13u}, {34u, 21u}, {89u, 55u}})
    EXPECT_EQ(PairLattice(size).step(), step);
}

} // namespace
} // namespace pcl_cid::test
