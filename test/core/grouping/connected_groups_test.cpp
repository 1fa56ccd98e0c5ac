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

#include "base/random.h"
#include "grouping/connected_groups.h"

#include <pcl_cid/core/concavity.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <set>
#include <thread>
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
  ConnectedGroups connected(*scan->graph(), scan->working(), 10);
  for (int twice = 0; twice < 2; ++twice)
    EXPECT_EQ(connected.connect({0, 40}, groups, 1, progress), groups);
}

TEST(ConnectedGroups, WithoutSeedsNothingIsInAGroup)
{
  const auto scan = preparedWithGraph(twoBoxes(200, 8));
  const std::vector<pcl::index_t> none(200, -1);
  const std::vector<pcl::index_t> all(200, 0);
  ConnectedGroups connected(*scan->graph(), scan->working(), 10);
  Progress silent(nullptr);
  for (int twice = 0; twice < 2; ++twice) {
    EXPECT_EQ(connected.connect({}, none, 1, silent), none);
    EXPECT_EQ(connected.connect({5}, all, 1, silent), all);
  }
}

/** Seeds and groups of any shape that change a little, or much, from step to step. */
class ChangingGroups {
public:
  ChangingGroups(const PreparedScan& scan, std::uint64_t random_seed)
  : scan_(scan), generator_(random_seed), seed_of_(scan.working().size(), 0)
  {
    seeds_ = {0};
    for (int k = 0; k < 5; ++k)
      addSeed();
  }

  void
  step()
  {
    switch (draw(6)) {
    case 0:
      addSeed();
      break;
    case 1:
      if (seeds_.size() > 1)
        removeSeed();
      break;
    case 2: // nothing but the numbers change
      std::swap(seeds_[draw(seeds_.size())], seeds_[draw(seeds_.size())]);
      break;
    case 3:
      break;
    default:
      moveBall(draw(2) == 0 ? 0.1f : 1.0f, seeds_[draw(seeds_.size())]);
    }
  }

  const pcl::Indices&
  seeds() const
  {
    return seeds_;
  }

  std::vector<pcl::index_t>
  groups() const
  {
    std::vector<pcl::index_t> groups;
    for (const pcl::index_t seed : seed_of_)
      groups.push_back(static_cast<pcl::index_t>(
          std::find(seeds_.begin(), seeds_.end(), seed) - seeds_.begin()));
    return groups;
  }

private:
  std::size_t
  draw(std::size_t count)
  {
    return drawBelow(generator_, count);
  }

  /** Points around any one, all or some here and there, go to a seed; a seed stays its
   *  own. */
  void
  moveBall(float radius, pcl::index_t seed)
  {
    const Points& points = scan_.working().points();
    const Eigen::Vector3f center = points[draw(points.size())];
    const std::size_t one_of = 1 + draw(4);
    for (std::size_t i = 0; i < points.size(); ++i)
      if ((points[i] - center).norm() <= radius && draw(one_of) == 0)
        seed_of_[i] = seed;
    for (const pcl::index_t each : seeds_)
      seed_of_[static_cast<std::size_t>(each)] = each;
  }

  void
  addSeed()
  {
    const auto seed = static_cast<pcl::index_t>(draw(seed_of_.size()));
    if (std::find(seeds_.begin(), seeds_.end(), seed) != seeds_.end())
      return;
    seeds_.insert(seeds_.begin() + static_cast<std::ptrdiff_t>(draw(seeds_.size() + 1)),
                  seed);
    moveBall(1.0f, seed);
  }

  void
  removeSeed()
  {
    const auto gone = seeds_.begin() + static_cast<std::ptrdiff_t>(draw(seeds_.size()));
    const pcl::index_t seed = *gone;
    seeds_.erase(gone);
    std::replace(seed_of_.begin(), seed_of_.end(), seed, seeds_[draw(seeds_.size())]);
  }

  const PreparedScan& scan_;
  RandomGenerator generator_;
  pcl::Indices seeds_;
  std::vector<pcl::index_t> seed_of_; ///< by point
};

/** Clouds of the tests, small and larger, with and without distances that tie. */
std::vector<PreparedScan::ConstPtr>
scansToConnect()
{
  std::vector<PreparedScan::ConstPtr> scans;
  for (const NamedPoints& cloud : allClouds())
    scans.push_back(preparedWithGraph(cloud.points, true, false));
  scans.push_back(preparedWithGraph(firstOf(twoBoxes(300, 8), 1)));
  scans.push_back(preparedWithGraph(twoBoxes(4000, 9)));
  return scans;
}

TEST(ConnectedGroupsThreads, AreTheSameAfterAnyHistory)
{
  constexpr int samples = 10;
  for (const PreparedScan::ConstPtr& scan : scansToConnect())
    for (const int threads : {1, 2, 3, 8}) {
      ConnectedGroups connected(*scan->graph(), scan->working(), samples);
      ChangingGroups changing(*scan, static_cast<std::uint64_t>(threads));
      for (int step = 0; step < 40; ++step) {
        changing.step();
        if (step % 7 == 3) { // one that comes to nothing
          Progress stopped([](double) { return false; });
          EXPECT_THROW(
              connected.connect(changing.seeds(), changing.groups(), threads, stopped),
              CIDCancelled);
          continue;
        }
        Progress silent(nullptr);
        ConnectedGroups fresh(*scan->graph(), scan->working(), samples);
        ASSERT_EQ(
            connected.connect(changing.seeds(), changing.groups(), threads, silent),
            fresh.connect(changing.seeds(), changing.groups(), 1, silent))
            << scan->working().size() << " points, step " << step;
      }
    }
}

/** Fresh ones after each step are right, too. */
TEST(ConnectedGroups, AreThoseOfALiteralSearchAfterAnyHistory)
{
  for (const NamedPoints& cloud : allClouds()) {
    SCOPED_TRACE(cloud.name);
    const auto scan = preparedWithGraph(firstOf(cloud.points, 150), true, false);
    ConnectedGroups connected(*scan->graph(), scan->working(), 10);
    ChangingGroups changing(*scan, 5);
    Progress silent(nullptr);
    for (int step = 0; step < 12; ++step) {
      changing.step();
      ASSERT_EQ(connected.connect(changing.seeds(), changing.groups(), 1, silent),
                connectLiterally(*scan, 10, changing.seeds(), changing.groups()));
    }
  }
}

/** Groups of different histories, side by side. */
TEST(ConnectedGroupsThreads, MayBeConnectedSideBySide)
{
  const auto scan = preparedWithGraph(twoBoxes(2000, 9));
  ConnectedGroups connected(*scan->graph(), scan->working(), 10);
  std::vector<std::thread> threads;
  std::vector<int> different(4, 0);
  for (std::size_t t = 0; t < different.size(); ++t)
    threads.emplace_back([&, t] {
      ChangingGroups changing(*scan, t);
      for (int step = 0; step < 20; ++step) {
        changing.step();
        Progress silent(nullptr);
        ConnectedGroups fresh(*scan->graph(), scan->working(), 10);
        different[t] +=
            connected.connect(changing.seeds(), changing.groups(), 2, silent) ==
                    fresh.connect(changing.seeds(), changing.groups(), 1, silent)
                ? 0
                : 1;
      }
    });
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(different, std::vector<int>(4, 0));
}

} // namespace
} // namespace pcl_cid::test
