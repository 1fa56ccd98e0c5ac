/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The graph of a surface, its patches, and the pieces of groups, against floods.
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

TEST(SurfaceGraph, PatchesHangTogetherAndAreLinked)
{
  for (const Points& points : cloudsWithRepeats()) {
    const auto scan = withGraph(points);
    const SurfaceGraph& graph = *scan->graph();
    std::vector<std::size_t> patch_of(graph.size());
    Vertex end = 0;
    for (std::size_t k = 0; k < graph.patches(); ++k) {
      const auto [first, last] = graph.patch(k);
      ASSERT_EQ(first, end);
      ASSERT_LT(first, last);
      end = last;
      std::fill(patch_of.begin() + first, patch_of.begin() + last, k);
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
        if (patch_of[v] < patch_of[q])
          expected.insert({patch_of[v], patch_of[q]});
      });
    for (std::size_t k = 0; k < graph.patches(); ++k)
      graph.forEachLaterPatch(k, [&](std::size_t later) {
        EXPECT_TRUE(links.insert({k, later}).second);
      });
    EXPECT_EQ(links, expected);
  }
}

/** Groups of any shape: few, in halves, at random. */
TEST(SurfacePieces, AreThoseOfAFlood)
{
  RandomGenerator generator(3);
  for (const Points& points : cloudsWithRepeats()) {
    const auto scan = withGraph(points);
    const SurfaceGraph& graph = *scan->graph();
    for (const std::size_t share_of_others : {0, 100, 10, 2}) {
      std::vector<pcl::index_t> groups(graph.size());
      for (std::size_t i = 0; i < groups.size(); ++i) {
        groups[i] = points[i].x() > points[0].x() ? 1 : 0;
        if (share_of_others > 0 && drawBelow(generator, share_of_others) == 0)
          groups[i] = static_cast<pcl::index_t>(drawBelow(generator, 3));
      }
      for (const int threads : {1, 2, 3}) {
        Progress silent(nullptr);
        const SurfacePieces pieces(graph, groups, threads, silent);
        std::vector<bool> seen(graph.size(), false);
        for (Vertex v = 0; v < graph.size(); ++v) {
          if (seen[v])
            continue;
          const auto group = groups[graph.pointOf(v)];
          for (const Vertex q : flood(graph, v, [&](Vertex w) {
                 return groups[graph.pointOf(w)] == group;
               })) {
            seen[q] = true;
            ASSERT_EQ(pieces.of(q), v);
          }
        }
        Vertex end = 0;
        pieces.forEachRun([&](SurfaceGraph::Patch run) {
          ASSERT_EQ(run.begin, end);
          end = run.end;
          for (Vertex v = run.begin; v < run.end; ++v)
            ASSERT_EQ(pieces.of(v), pieces.of(run.begin));
        });
        ASSERT_EQ(end, graph.size());
      }
    }
  }
}

} // namespace
} // namespace pcl_cid::test
