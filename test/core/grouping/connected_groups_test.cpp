/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Groups in one piece, against a literal search.
 */

#include "clouds.h"
#include "prepared_points.h"

#include "grouping/connected_groups.h"

#include <pcl_cid/core/concavity.h>
#include <pcl_cid/core/grouping.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

PreparedScan::ConstPtr
preparedWithGraph(const Points& points, bool connected = true, bool with_cues = true)
{
  PreparationSettings settings = plainSettings();
  settings.connected = connected;
  settings.normals = with_cues ? 0.03f : 0.0f;
  return prepared(points, settings);
}

/** The points that a point is joined with. */
std::vector<std::set<std::size_t>>
edgesOf(const SurfaceGraph& graph)
{
  std::vector<std::set<std::size_t>> edges(graph.size());
  for (std::size_t p = 0; p < graph.size(); ++p)
    graph.forEachEdge(graph.vertexOf(p), [&](SurfaceGraph::Vertex q) {
      edges[p].insert(graph.pointOf(q));
    });
  return edges;
}

/** A piece of a group, by flooding. */
std::set<std::size_t>
pieceAround(const std::vector<std::set<std::size_t>>& edges,
            const std::vector<pcl::index_t>& groups,
            std::size_t start)
{
  std::set<std::size_t> piece = {start};
  std::vector<std::size_t> open = {start};
  while (!open.empty()) {
    const std::size_t p = open.back();
    open.pop_back();
    for (const std::size_t q : edges[p])
      if (groups[q] == groups[start] && piece.insert(q).second)
        open.push_back(q);
  }
  return piece;
}

/** The rule by its words: of all islands next to a connected group, again and again the
 *  one with the least cost joins. */
std::vector<pcl::index_t>
connectLiterally(const PreparedScan& scan,
                 int samples,
                 const pcl::Indices& seeds,
                 const std::vector<pcl::index_t>& groups)
{
  const Points& points = scan.working().points();
  const auto edges = edgesOf(*scan.graph());
  std::vector<pcl::index_t> connected(groups.size(), -1);
  for (const pcl::index_t seed : seeds)
    for (const std::size_t p :
         pieceAround(edges, groups, static_cast<std::size_t>(seed)))
      connected[p] = groups[p];
  const auto costOf = [&](std::size_t p, pcl::index_t group) {
    const auto seed = static_cast<std::size_t>(seeds[static_cast<std::size_t>(group)]);
    return scan.working().costs().between(seed, p).of(
        pointCID(scan.field(), points[seed], points[p], samples));
  };
  for (;;) {
    std::tuple<float, pcl::index_t, std::size_t> best(INFINITY, 0, 0);
    for (std::size_t p = 0; p < groups.size(); ++p)
      if (connected[p] < 0)
        for (const std::size_t q : edges[p])
          if (connected[q] >= 0) {
            const auto island = *pieceAround(edges, groups, p).begin();
            best = std::min(best, {costOf(p, connected[q]), connected[q], island});
          }
    if (std::get<0>(best) == INFINITY)
      break;
    for (const std::size_t p : pieceAround(edges, groups, std::get<2>(best)))
      connected[p] = std::get<1>(best);
  }
  for (std::size_t p = 0; p < groups.size(); ++p)
    if (connected[p] < 0)
      connected[p] = groups[p];
  return connected;
}

Points
firstOf(const Points& points, std::size_t count)
{
  return Points(points.begin(),
                points.begin() +
                    static_cast<std::ptrdiff_t>(std::min(count, points.size())));
}

/** Points that are given twice hang together. */
TEST(ConnectedGroups, OfRepeatedPointsAreTheSame)
{
  const Points once = twoBoxes(300, 8);
  Points twice = once;
  twice.insert(twice.end(), once.begin(), once.end());
  Grouping grouping(preparedWithGraph(twice));
  grouping.propose(12);
  const auto groups = grouping.groupsOfWorkingPoints();
  for (std::size_t i = 0; i < once.size(); ++i)
    EXPECT_EQ(groups[i], groups[i + once.size()]) << i;
}

TEST(ConnectedGroups, AreThoseOfALiteralSearch)
{
  std::vector<NamedPoints> clouds = allClouds();
  if (const auto scan = loadSharedScan("office1.pcd"))
    clouds.push_back({"office1", crop(*scan, 300, 31)});
  std::size_t moved = 0;
  for (const NamedPoints& cloud : clouds)
    for (const bool with_cues : {false, true}) {
      SCOPED_TRACE(cloud.name);
      const auto scan = preparedWithGraph(firstOf(cloud.points, 300), true, with_cues);
      GroupingSettings settings;
      settings.samples = 20;
      Grouping grouping(scan, settings);
      grouping.propose(9);
      Grouping plain(preparedWithGraph(firstOf(cloud.points, 300), false, with_cues),
                     settings);
      plain.propose(9);
      ASSERT_EQ(grouping.seeds(), plain.seeds());
      const auto groups = grouping.groupsOfWorkingPoints();
      EXPECT_EQ(
          groups,
          connectLiterally(*scan, 20, grouping.seeds(), plain.groupsOfWorkingPoints()));
      moved += groups != plain.groupsOfWorkingPoints() ? 1 : 0;
      for (const unsigned int threads : {2u, 3u, 8u})
        EXPECT_EQ(grouping.groupsOfWorkingPoints(onThreads(threads)), groups);
    }
  EXPECT_GT(moved, 3u);
}

TEST(ConnectedGroups, HangTogetherWithTheirSeeds)
{
  const Points points = twoBoxes(3000, 12);
  const auto scan = preparedWithGraph(points);
  Grouping grouping(scan);
  grouping.propose(25);
  const auto groups = grouping.groupsOfWorkingPoints();
  const auto edges = edgesOf(*scan->graph());
  std::set<std::size_t> reached;
  for (const pcl::index_t seed : grouping.seeds()) {
    const auto piece = pieceAround(edges, groups, static_cast<std::size_t>(seed));
    reached.insert(piece.begin(), piece.end());
  }
  EXPECT_EQ(reached.size(), points.size());
}

/// Given groups, seen from nowhere near a seed: they stay what they are.
TEST(ConnectedGroups, WhatNoGroupComesNextToStays)
{
  Points points;
  for (const float x : {0.0f, 100.0f, 200.0f})
    for (int i = 0; i < 30; ++i)
      points.emplace_back(
          x, 0.1f * static_cast<float>(i % 6), 0.1f * static_cast<float>(i / 6));
  const auto scan = preparedWithGraph(points);
  std::vector<pcl::index_t> groups(90, 1);
  std::fill_n(groups.begin(), 30, 0);
  Progress progress(nullptr);
  // The third cluster belongs to seed 1, which is on the second.
  KnownCosts costs(scan->working(), 10);
  EXPECT_EQ(connectGroups(*scan->graph(), costs, {0, 40}, groups, 1, progress), groups);
}

} // namespace
} // namespace pcl_cid::test
