/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Smooth patches, against their words taken literally.
 */

#include "clouds.h"
#include "even_sampler.h"
#include "prepared_points.h"
#include "room_scene.h"

#include "cid/working_points.h"
#include "grouping/smooth_regions.h"
#include "scan/working_set.h"

#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/smooth_patches.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** What patches are made of. */
struct Surface {
  explicit Surface(const Points& of_points)
  : points(of_points)
  , neighbors(points, onThreads(1), NearestNeighbors::most)
  , graph(points, neighbors)
  , shape(surfaceShape(points, neighbors, onThreads(1)))
  , edges(points.size())
  {
    for (std::size_t p = 0; p < points.size(); ++p)
      graph.forEachEdge(graph.vertexOf(p), [&](SurfaceGraph::Vertex q) {
        edges[p].insert(graph.pointOf(q));
      });
  }

  /** Degrees between the normals of two points. */
  double
  angle(std::size_t p, std::size_t q) const
  {
    const Eigen::Vector3d a = shape.normals[p].cast<double>();
    const Eigen::Vector3d b = shape.normals[q].cast<double>();
    if (a.norm() == 0.0 || b.norm() == 0.0)
      return a.norm() == b.norm() ? 0.0 : 90.0;
    return std::acos(std::min(std::abs(a.dot(b)), 1.0)) * 180.0 / M_PI;
  }

  Points points;
  NearestNeighbors neighbors;
  SurfaceGraph graph;
  SurfaceShape shape;
  std::vector<std::set<std::size_t>> edges;
};

using Patch = std::set<std::size_t>;

/** All points that a region takes of those that are left. */
Patch
regionFrom(const Surface& surface, std::size_t first, const Patch& left)
{
  Patch region = {first};
  for (bool grows = true; grows;) {
    grows = false;
    for (const std::size_t q : left)
      for (const std::size_t p : surface.edges[q])
        if (region.count(p) > 0 && region.count(q) == 0 &&
            surface.angle(first, q) <= 8.0) {
          region.insert(q);
          grows = true;
        }
  }
  return region;
}

std::vector<Patch>
literalRegions(const Surface& surface)
{
  std::vector<Patch> regions;
  Patch left;
  for (std::size_t p = 0; p < surface.points.size(); ++p)
    left.insert(left.end(), p);
  while (!left.empty()) {
    const auto flattest =
        std::min_element(left.begin(), left.end(), [&](std::size_t p, std::size_t q) {
          return surface.shape.curvatures[p] < surface.shape.curvatures[q];
        });
    regions.push_back(regionFrom(surface, *flattest, left));
    for (const std::size_t p : regions.back())
      left.erase(p);
  }
  return regions;
}

/** Taken one by one, always a largest one that comes first. */
std::vector<Patch>
literalLargest(std::vector<Patch> regions, std::size_t most)
{
  std::vector<Patch> largest;
  while (!regions.empty() && largest.size() < most) {
    const auto next = std::max_element(
        regions.begin(), regions.end(), [](const Patch& a, const Patch& b) {
          return a.size() < b.size();
        });
    largest.push_back(*next);
    regions.erase(next);
  }
  return largest;
}

/** The shortest way to each point from a patch, and its number: by going along every
 *  edge until nothing gets shorter (Bellman and Ford). */
std::vector<std::pair<float, pcl::index_t>>
literalWays(const Surface& surface, const std::vector<Patch>& patches)
{
  constexpr float far = std::numeric_limits<float>::infinity();
  std::vector<std::pair<float, pcl::index_t>> ways(surface.points.size(), {far, -1});
  for (std::size_t k = 0; k < patches.size(); ++k)
    for (const std::size_t p : patches[k])
      ways[p] = {0.0f, static_cast<pcl::index_t>(k)};
  const auto is_grown = [&](std::size_t p) {
    return std::any_of(patches.begin(), patches.end(), [&](const Patch& patch) {
      return patch.count(p) > 0;
    });
  };
  for (bool changes = true; changes;) {
    changes = false;
    for (std::size_t q = 0; q < ways.size(); ++q)
      if (!is_grown(q))
        for (const std::size_t p : surface.edges[q]) {
          const float step = (surface.points[q] - surface.points[p]).norm();
          const std::pair<float, pcl::index_t> way(ways[p].first + step,
                                                   ways[p].second);
          if (way.first < far && way < ways[q]) {
            ways[q] = way;
            changes = true;
          }
        }
  }
  return ways;
}

/** The lowest patch of the points that are nearest to one, of those that a way leads
 *  to. */
pcl::index_t
nearestPatch(const Surface& surface,
             const std::vector<std::pair<float, pcl::index_t>>& ways,
             std::size_t q)
{
  std::set<pcl::index_t> nearest;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t p = 0; p < ways.size(); ++p) {
    if (ways[p].second < 0)
      continue;
    const Eigen::Vector3f d = surface.points[p] - surface.points[q];
    const float squared = (d.x() * d.x() + d.y() * d.y()) + d.z() * d.z();
    if (squared < least)
      nearest.clear();
    if (squared <= least)
      nearest.insert(ways[p].second);
    least = std::min(least, squared);
  }
  return *nearest.begin();
}

void
expectAreTheLiteralOnes(const SmoothPatches& patches, std::size_t most)
{
  const Surface surface(patches.scan().working().points());
  const std::vector<Patch> expected = literalLargest(literalRegions(surface), most);
  ASSERT_EQ(patches.numberOfPatches(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_EQ(patches.grownSizes()[k], expected[k].size()) << k;
  const auto ways = literalWays(surface, expected);
  const std::vector<pcl::index_t>& groups = patches.groupsOfWorkingPoints();
  ASSERT_EQ(groups.size(), ways.size());
  for (std::size_t p = 0; p < groups.size(); ++p) {
    const pcl::index_t along_surface = ways[p].second;
    EXPECT_EQ(groups[p],
              along_surface >= 0 ? along_surface : nearestPatch(surface, ways, p))
        << p;
  }
}

Points
firstOfCloud(const Points& points, std::size_t count)
{
  return Points(points.begin(),
                points.begin() +
                    static_cast<std::ptrdiff_t>(std::min(count, points.size())));
}

std::vector<NamedPoints>
cloudsForPatches()
{
  std::vector<NamedPoints> clouds;
  for (const NamedPoints& cloud : allClouds())
    clouds.push_back({cloud.name, firstOfCloud(cloud.points, 300)});
  RoomOptions room;
  room.seed = 3;
  clouds.push_back({"room", sampleRoomEvenly(makeRoom(room), 600, 3).points});
  Points twice = clouds.back().points;
  twice.resize(300);
  twice.insert(twice.end(), twice.begin(), twice.begin() + 150);
  clouds.push_back({"repeated", twice});
  for (const char* name :
       {"office1.pcd", "mosd_learn4.pcd", "table_scene_mug_stereo_textured.pcd"})
    if (const auto scan = loadSharedScan(name))
      clouds.push_back({name, crop(*scan, 500, 23)});
  return clouds;
}

TEST(SmoothPatches, AreTheLiteralOnes)
{
  std::size_t filled = 0;
  for (const NamedPoints& cloud : cloudsForPatches())
    for (const std::size_t most : {1u, 3u, 20u, 100000u}) {
      SCOPED_TRACE(cloud.name + ", at most " + std::to_string(most));
      const SmoothPatches patches(prepared(cloud.points), most);
      expectAreTheLiteralOnes(patches, most);
      std::size_t grown = 0;
      for (const std::size_t size : patches.grownSizes())
        grown += size;
      filled += cloud.points.size() - grown;
    }
  EXPECT_GT(filled, 1000u); // the clouds ask for something
}

TEST(SmoothPatches, HaveEveryPointOnceAndNoneIsEmpty)
{
  for (const NamedPoints& cloud : cloudsForPatches()) {
    SCOPED_TRACE(cloud.name);
    const SmoothPatches patches(prepared(cloud.points), 7);
    std::vector<std::size_t> sizes(patches.numberOfPatches(), 0);
    ASSERT_GE(sizes.size(), 1u);
    ASSERT_LE(sizes.size(), 7u);
    for (const pcl::index_t patch : patches.groups()) {
      ASSERT_GE(patch, 0);
      ASSERT_LT(static_cast<std::size_t>(patch), sizes.size());
      ++sizes[static_cast<std::size_t>(patch)];
    }
    const std::vector<std::size_t>& grown = patches.grownSizes();
    EXPECT_TRUE(std::is_sorted(grown.rbegin(), grown.rend()));
    EXPECT_GE(grown.back(), 1u);
    for (std::size_t k = 0; k < sizes.size(); ++k)
      EXPECT_GE(sizes[k], grown[k]);
  }
}

TEST(SmoothPatches, AreTheSameForEveryNumberOfThreads)
{
  for (const NamedPoints& cloud : cloudsForPatches()) {
    SCOPED_TRACE(cloud.name);
    const auto scan = prepared(cloud.points);
    const SmoothPatches serial(scan, 12, onThreads(1));
    for (const unsigned int threads : {2u, 3u, 8u}) {
      const SmoothPatches patches(scan, 12, onThreads(threads));
      EXPECT_EQ(patches.groupsOfWorkingPoints(), serial.groupsOfWorkingPoints());
      EXPECT_EQ(patches.grownSizes(), serial.grownSizes());
    }
  }
}

/** The graph of the scan is that which is made here without one, and neither costs nor
 *  seeds matter. */
TEST(SmoothPatches, DependOnTheSurfaceAlone)
{
  const Points points = twoBoxes(500, 9);
  const SmoothPatches plain(prepared(points), 9);
  PreparationSettings settings = plainSettings();
  settings.connected = true;
  settings.normals = 0.1f;
  settings.density = DensityWeight::on;
  settings.random_seed = 5;
  settings.start_index = 77;
  const SmoothPatches other(prepared(points, settings), 9);
  EXPECT_EQ(plain.groups(), other.groups());
  EXPECT_EQ(plain.grownSizes(), other.grownSizes());
}

/** A box has six sides. */
TEST(SmoothPatches, OfBoxesAreTheirSides)
{
  Points points;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j)
      for (const int side : {0, 1}) {
        const auto u = (static_cast<float>(i) + 0.5f) / 12.0f;
        const auto v = (static_cast<float>(j) + 0.5f) / 12.0f;
        const auto w = static_cast<float>(side);
        points.insert(points.end(), {{u, v, w}, {u, w, v}, {w, u, v}});
      }
  const auto scan = prepared(points);
  const std::vector<std::size_t> sizes = SmoothPatches(scan, 100).grownSizes();
  ASSERT_GT(sizes.size(), 6u); // at the edges
  EXPECT_GT(sizes[5], 2 * sizes[6]);
  const SmoothPatches patches(scan, 6);
  const std::vector<pcl::index_t> groups = patches.groups();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_EQ(groups[i] == groups[j], i % 6 == j % 6) << i << ", " << j;
}

TEST(SmoothPatches, OfLinesAndFewPoints)
{
  EXPECT_EQ(SmoothPatches(prepared({{1, 2, 3}})).groups(),
            std::vector<pcl::index_t>{0});
  EXPECT_EQ(SmoothPatches(prepared(Points(50, {1, 2, 3}))).numberOfPatches(), 1u);
  Points line;
  for (int i = 0; i < 40; ++i)
    line.emplace_back(static_cast<float>(i), 0.0f, 0.0f);
  EXPECT_EQ(SmoothPatches(prepared(line)).numberOfPatches(), 1u)
      << "no point has a normal";
  for (int i = 0; i < 40; ++i)
    line.emplace_back(static_cast<float>(i), 1000.0f, 0.0f);
  const SmoothPatches of_two(prepared(line));
  EXPECT_EQ(of_two.grownSizes(), (std::vector<std::size_t>{40, 40}));
  const SmoothPatches of_one(prepared(line), 1);
  EXPECT_EQ(of_one.grownSizes(), std::vector<std::size_t>{40});
  EXPECT_EQ(of_one.groups(), std::vector<pcl::index_t>(80, 0));
}

/** A subsample is worked on; the others follow. */
TEST(SmoothPatches, CarryOnToAllPoints)
{
  PreparationSettings settings = plainSettings();
  settings.subsample = 200;
  const auto scan = prepared(twoBoxes(500, 44), settings);
  const SmoothPatches patches(scan, 10);
  EXPECT_EQ(patches.groupsOfWorkingPoints().size(), 200u);
  EXPECT_EQ(patches.groups(),
            scan->workingSet().carryOn(
                patches.groupsOfWorkingPoints(), 500, pcl::index_t{-1}));
  expectAreTheLiteralOnes(patches, 10);
}

TEST(SmoothPatches, BadValuesAndCancel)
{
  EXPECT_THROW(SmoothPatches(nullptr), CIDException);
  const auto scan = prepared(randomCube(3000, 4));
  EXPECT_THROW(SmoothPatches(scan, 0), CIDException);
  ExecutionOptions execution;
  for (const int calls : {0, 1, 2, 3}) {
    int called = 0;
    execution.progress = [&](double) { return called++ < calls; };
    EXPECT_THROW(SmoothPatches(scan, 5, execution), CIDCancelled) << calls;
  }
  // While neighbors are searched for, regions grow, and are filled in.
  for (const double limit : {0.0, 0.1, 0.4, 0.7, 1.0}) {
    execution.progress = [&](double fraction) { return fraction < limit; };
    EXPECT_THROW(SmoothPatches(scan, 5, execution), CIDCancelled) << limit;
  }
}

/** Many points that no way leads to are no reason to ask more often. */
TEST(SmoothPatches, ProgressIsToldAFewTimes)
{
  Points points = twoBoxes(500, 12);
  const Points dust = randomCube(20000, 4);
  for (const Eigen::Vector3f& p : dust)
    points.push_back(1e4f * p + Eigen::Vector3f(1e6f, 0.0f, 0.0f));
  int called = 0;
  ExecutionOptions execution;
  execution.threads = 1;
  execution.progress = [&](double) {
    ++called;
    return true;
  };
  const SmoothPatches patches(prepared(points), 1, execution);
  EXPECT_EQ(patches.numberOfPatches(), 1u);
  EXPECT_GT(called, 3);
  EXPECT_LT(called, 1000);
}

TEST(SmoothPatches, ProgressGoesUpToTheEnd)
{
  std::vector<double> told;
  ExecutionOptions execution;
  execution.progress = [&](double fraction) {
    told.push_back(fraction);
    return true;
  };
  SmoothPatches(prepared(randomCube(3000, 4)), 5, execution);
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1.0);
}

TEST(SmoothPatches, MergeAsGroupsOfSeedsDo)
{
  PreparationSettings settings = plainSettings();
  settings.density = DensityWeight::on;
  settings.normals = 0.05f;
  const auto scan = prepared(twoBoxes(500, 44), settings);
  const auto patches = std::make_shared<const SmoothPatches>(scan, 14);
  const MergeTree tree = mergeGroups(*patches, 20);
  ASSERT_EQ(tree.numberOfGroups(), 14u);
  std::vector<std::size_t> sizes(14, 0);
  for (const pcl::index_t patch : patches->groups())
    ++sizes[static_cast<std::size_t>(patch)];
  EXPECT_EQ(tree.groupSizes(), sizes);
  const std::vector<int> cut = tree.cutAtParts(2);
  std::set<int> parts_of_box[2];
  for (std::size_t i = 0; i < 500; ++i)
    parts_of_box[i % 2].insert(cut[static_cast<std::size_t>(patches->groups()[i])]);
  EXPECT_EQ(parts_of_box[0].size(), 1u);
  EXPECT_NE(parts_of_box[0], parts_of_box[1]);
  EXPECT_THROW(mergeGroups(*patches, 1), CIDException);
}

} // namespace
} // namespace pcl_cid::test
