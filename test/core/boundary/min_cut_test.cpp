/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Minimum cuts against all cuts.
 */

#include "boundary/min_cut.h"

#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** What a cut costs, by its definition. */
std::int64_t
costOfCut(const CutGraph& graph, const std::vector<bool>& source_side)
{
  std::int64_t cost = 0;
  for (std::size_t i = 0; i < source_side.size(); ++i)
    cost += source_side[i] ? std::max<std::int64_t>(-graph.from_source[i], 0)
                           : std::max<std::int64_t>(graph.from_source[i], 0);
  for (const CutGraph::Edge& edge : graph.edges)
    if (source_side[edge.first] != source_side[edge.second])
      cost += edge.capacity;
  return cost;
}

std::vector<bool>
sideOf(std::size_t mask, std::size_t nodes)
{
  std::vector<bool> side(nodes);
  for (std::size_t i = 0; i < nodes; ++i)
    side[i] = (mask >> i) & 1;
  return side;
}

/** The nodes on the source's side of every minimum cut: they are one themselves. */
std::vector<bool>
smallestByAllCuts(const CutGraph& graph)
{
  const std::size_t nodes = graph.from_source.size();
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  std::size_t common = 0;
  for (std::size_t mask = 0; mask < std::size_t{1} << nodes; ++mask) {
    const std::int64_t cost = costOfCut(graph, sideOf(mask, nodes));
    common = cost < least ? mask : cost == least ? common & mask : common;
    least = std::min(least, cost);
  }
  return sideOf(common, nodes);
}

/** Small capacities make many ties. */
CutGraph
randomGraph(std::mt19937_64& random, std::size_t nodes, std::uint64_t most)
{
  CutGraph graph;
  for (std::size_t i = 0; i < nodes; ++i)
    graph.from_source.push_back(static_cast<std::int64_t>(random() % (2 * most + 1)) -
                                static_cast<std::int64_t>(most));
  for (std::size_t i = 0; i < nodes; ++i)
    for (std::size_t k = i + 1; k < nodes; ++k)
      if (random() % 3 == 0)
        graph.edges.push_back({i, k, static_cast<std::int64_t>(random() % (most + 1))});
  return graph;
}

TEST(MinCut, IsTheSmallestOfAllMinimumCuts)
{
  std::mt19937_64 random(1);
  for (int round = 0; round < 3000; ++round) {
    const std::uint64_t most = round % 2 == 0 ? 3 : 1000000;
    const CutGraph graph = randomGraph(random, 1 + random() % 10, most);
    ASSERT_EQ(smallestSourceSide(graph), smallestByAllCuts(graph)) << round;
  }
}

TEST(MinCut, EndsOfALongChainAgree)
{
  CutGraph graph;
  graph.from_source.assign(100000, 0);
  for (std::size_t i = 0; i + 1 < graph.from_source.size(); ++i)
    graph.edges.push_back({i, i + 1, i == 40000 ? 1 : 2});
  graph.from_source.front() = 5;
  graph.from_source.back() = -5;
  const std::vector<bool> side = smallestSourceSide(graph);
  EXPECT_EQ(std::count(side.begin(), side.end(), true), 40001);
}

TEST(MinCut, ThereMayBeNothingToCut)
{
  EXPECT_TRUE(smallestSourceSide({}).empty());
  EXPECT_EQ(smallestSourceSide({{0, 0}, {{0, 1, 7}}}), std::vector<bool>(2, false));
  EXPECT_EQ(smallestSourceSide({{1, 0}, {{0, 1, 7}}}), std::vector<bool>(2, true));
  EXPECT_EQ(smallestSourceSide({{-1}, {}}), std::vector<bool>(1, false));
}

} // namespace
} // namespace pcl_cid::test
