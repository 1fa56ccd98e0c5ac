/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The graph of a surface, its runs, and the pieces of groups, against floods.
 */

#include "clouds.h"
#include "prepared_points.h"

#include "base/random.h"
#include "grouping/surface_pieces.h"

#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using Vertex = SurfaceGraph::Vertex;

PreparedScan::ConstPtr
withGraph(const Points& points)
{
  PreparationSettings settings = plainSettings();
  settings.connected = true;
  return prepared(points, settings);
}

/** The clouds of all tests, one with each point twice, and a larger one. */
std::vector<Points>
cloudsWithRepeats()
{
  std::vector<Points> clouds;
  for (const NamedPoints& cloud : allClouds())
    clouds.push_back(cloud.points);
  Points twice = twoBoxes(700, 8);
  const Points once = twice;
  twice.insert(twice.end(), once.begin(), once.end());
  clouds.push_back(twice);
  clouds.push_back(twoBoxes(6000, 12));
  return clouds;
}

/** What edges join with a vertex, among those that \a may says. */
template <typename May>
std::set<Vertex>
flood(const SurfaceGraph& graph, Vertex start, const May& may)
{
  std::set<Vertex> reached = {start};
  std::vector<Vertex> open = {start};
  while (!open.empty()) {
    const Vertex v = open.back();
    open.pop_back();
    graph.forEachEdge(v, [&](Vertex q) {
      if (may(q) && reached.insert(q).second)
        open.push_back(q);
    });
  }
  return reached;
}

TEST(SurfaceGraph, EdgesAreMutualAndListedOnce)
{
  for (const Points& points : cloudsWithRepeats()) {
    const auto scan = withGraph(points);
    const SurfaceGraph& graph = *scan->graph();
    std::set<std::pair<Vertex, Vertex>> edges;
    for (Vertex v = 0; v < graph.size(); ++v) {
      EXPECT_EQ(graph.vertexOf(graph.pointOf(v)), v);
      graph.forEachEdge(v, [&](Vertex q) {
        EXPECT_NE(v, q);
        EXPECT_TRUE(edges.insert({v, q}).second);
      });
    }
    for (const auto& [v, q] : edges)
      EXPECT_EQ(edges.count({q, v}), 1u);
  }
}

TEST(SurfaceGraph, RunsHangTogetherAndAreLinked)
{
  for (const Points& points : cloudsWithRepeats()) {
    const auto scan = withGraph(points);
    const SurfaceGraph& graph = *scan->graph();
    std::vector<std::size_t> run_of(graph.size());
    Vertex end = 0;
    for (std::size_t k = 0; k < graph.runs(); ++k) {
      const auto [first, last] = graph.run(k);
      ASSERT_EQ(first, end);
      ASSERT_LT(first, last);
      end = last;
      std::fill(run_of.begin() + first, run_of.begin() + last, k);
      const auto inside = [first = first, last = last](Vertex q) {
        return q >= first && q < last;
      };
      EXPECT_EQ(flood(graph, first, inside).size(), last - first);
    }
    ASSERT_EQ(end, graph.size());
    std::set<std::pair<std::size_t, std::size_t>> expected;
    std::set<std::pair<std::size_t, std::size_t>> links;
    for (Vertex v = 0; v < graph.size(); ++v)
      graph.forEachEdge(v, [&](Vertex q) {
        if (run_of[v] < run_of[q])
          expected.insert({run_of[v], run_of[q]});
      });
    for (std::size_t k = 0; k < graph.runs(); ++k)
      graph.forEachLaterRun(k, [&](std::size_t later) {
        EXPECT_TRUE(links.insert({k, later}).second);
      });
    EXPECT_EQ(links, expected);
  }
}

/** Groups of any shape: few, in halves, at random. */
std::vector<pcl::index_t>
someGroups(const Points& points,
           std::size_t share_of_others,
           RandomGenerator& generator)
{
  std::vector<pcl::index_t> groups(points.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    groups[i] = points[i].x() > points[0].x() ? 1 : 0;
    if (share_of_others > 0 && drawBelow(generator, share_of_others) == 0)
      groups[i] = static_cast<pcl::index_t>(drawBelow(generator, 3));
  }
  return groups;
}

/** Any point of each group; the groups are numbered by these then. */
pcl::Indices
drawSeeds(std::vector<pcl::index_t>& groups, RandomGenerator& generator)
{
  pcl::Indices seeds;
  std::vector<pcl::index_t> number(3, -1);
  for (std::size_t tries = 0; tries < 20 || seeds.empty(); ++tries) {
    const std::size_t point = drawBelow(generator, groups.size());
    pcl::index_t& of_group = number[static_cast<std::size_t>(groups[point])];
    if (of_group >= 0)
      continue;
    of_group = static_cast<pcl::index_t>(seeds.size());
    seeds.push_back(static_cast<pcl::index_t>(point));
  }
  for (pcl::index_t& group : groups) // that no seed was drawn for: the first one's
    group = std::max(number[static_cast<std::size_t>(group)], 0);
  return seeds;
}

/** By vertex: the seed of its group, and its piece. */
using Places = std::vector<std::pair<pcl::index_t, Vertex>>;

Places
floodPieces(const SurfaceGraph& graph,
            const pcl::Indices& seeds,
            const std::vector<pcl::index_t>& groups)
{
  const auto groupOf = [&](Vertex v) { return groups[graph.pointOf(v)]; };
  Places places(graph.size(), {-1, 0});
  for (Vertex v = 0; v < graph.size(); ++v) {
    if (places[v].first >= 0)
      continue;
    const pcl::index_t seed = seeds[static_cast<std::size_t>(groupOf(v))];
    const std::set<Vertex> piece =
        flood(graph, v, [&](Vertex w) { return groupOf(w) == groupOf(v); });
    const bool is_mainland =
        piece.count(graph.vertexOf(static_cast<std::size_t>(seed))) > 0;
    for (const Vertex q : piece)
      places[q] = {seed, is_mainland ? SurfacePieces::mainland : v};
  }
  return places;
}

TEST(SurfacePieces, AreThoseOfAFloodHoweverGroupsChanged)
{
  RandomGenerator generator(3);
  for (const Points& points : cloudsWithRepeats()) {
    const auto scan = withGraph(points);
    const SurfaceGraph& graph = *scan->graph();
    for (const int threads : {1, 2, 3}) {
      SurfacePieces pieces(graph);
      Places before(graph.size(), {-1, 0});
      for (const std::size_t share_of_others : {0, 100, 10, 2, 100, 0}) {
        std::vector<pcl::index_t> groups =
            someGroups(points, share_of_others, generator);
        const pcl::Indices seeds = drawSeeds(groups, generator);
        Progress silent(nullptr);
        const auto change = pieces.update(seeds, groups, threads, silent);
        const Places expected = floodPieces(graph, seeds, groups);
        const std::set<Vertex> changed(change.vertices.begin(), change.vertices.end());
        for (Vertex v = 0; v < graph.size(); ++v) {
          ASSERT_EQ(pieces.groupOf(v), groups[graph.pointOf(v)]);
          ASSERT_EQ(pieces.of(v), expected[v].second);
          if (expected[v] != before[v]) {
            ASSERT_EQ(changed.count(v), 1u);
          }
        }
        before = expected;
      }
    }
  }
}

/** Where one vertex goes from one group to another, this and no other one, unless it
 *  held pieces together, is said to have changed. */
TEST(SurfacePieces, SayWhatChanged)
{
  Points row;
  for (int i = 0; i < 100; ++i)
    row.emplace_back(static_cast<float>(i), 0.0f, 0.0f);
  const auto scan = withGraph(row);
  const SurfaceGraph& graph = *scan->graph();
  SurfacePieces pieces(graph);
  Progress silent(nullptr);
  std::vector<pcl::index_t> groups(100, 0);
  std::fill_n(groups.begin() + 50, 50, 1);
  const auto changed = [&](const pcl::Indices& seeds) {
    std::set<std::size_t> points;
    for (const Vertex v : pieces.update(seeds, groups, 1, silent).vertices)
      points.insert(graph.pointOf(v));
    return points;
  };
  EXPECT_EQ(changed({0, 99}).size(), 100u);
  EXPECT_EQ(changed({0, 99}).size(), 0u);
  groups[49] = 1;
  EXPECT_EQ(changed({0, 99}), std::set<std::size_t>{49});
  for (pcl::index_t& group : groups) // a third seed before both
    ++group;
  groups[20] = 0;
  EXPECT_EQ(changed({20, 0, 99}), std::set<std::size_t>{20});
  for (pcl::index_t& group : groups) // and away
    group = std::max(group - 1, 0);
  EXPECT_EQ(changed({0, 99}), std::set<std::size_t>{20});
  for (pcl::index_t& group : groups) // seeds that change places
    group = 1 - group;
  EXPECT_FALSE(changed({99, 0}).empty());
}

} // namespace
} // namespace pcl_cid::test
