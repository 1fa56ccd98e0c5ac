/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts chosen by their hulls: what holds for all of them, and what they are for.
 */

#include "clouds.h"
#include "depth_sensor.h"
#include "even_sampler.h"
#include "fitting/cell.h"
#include "hulls.h"
#include "prepared_points.h"
#include "room_scene.h"
#include "sanitizers.h"

#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/hull_cid.h>
#include <pcl_cid/core/hull_fitting.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

HullFittingSettings
fittingOf(std::size_t parts)
{
  HullFittingSettings settings;
  settings.parts = parts;
  // Larger robots need fewer cells, and so less time.
  settings.robot_radius = 0.3;
  return settings;
}

HullFittingSettings
fittingWithin(double max_error, std::size_t parts = 1)
{
  HullFittingSettings settings = fittingOf(parts);
  settings.max_error = max_error;
  return settings;
}

/** Every point has a part; parts are numbered by their first points. */
void
expectNumbered(const HullFitting& fitting, std::size_t points, const std::string& what)
{
  ASSERT_EQ(fitting.part.size(), points) << what;
  int next = 0;
  for (const int part : fitting.part) {
    ASSERT_GE(part, 0) << what;
    ASSERT_LE(part, next) << what;
    next += part == next ? 1 : 0;
  }
  EXPECT_EQ(fitting.parts, static_cast<std::size_t>(next)) << what;
  EXPECT_LE(fitting.refused_places, fitting.free_places) << what;
}

std::vector<std::vector<Eigen::Vector3d>>
pointsOfParts(const PreparedScan& scan, const HullFitting& fitting)
{
  std::vector<std::vector<Eigen::Vector3d>> parts(fitting.parts);
  for (std::size_t i = 0; i < fitting.part.size(); ++i)
    parts[static_cast<std::size_t>(fitting.part[i])].push_back(
        scan.points().points[i].cast<double>());
  return parts;
}

/** The floor, the walls and some furniture, about as a scan has them. */
PreparedScan::ConstPtr
smallRoom(std::size_t points)
{
  RoomOptions room;
  room.seed = 61;
  room.width = {3.0, 3.2};
  room.depth = {2.6, 2.8};
  room.doors = room.windows = 1;
  room.beams = room.columns = room.sofas = room.boards = 0;
  room.bookcases = room.tables = 1;
  room.chairs = 2;
  room.clutter = 3;
  return prepared(sampleRoomEvenly(makeRoom(room), points, 62).points);
}

/** A draw of a cloud: what is hard about it takes few points. */
PreparedScan::ConstPtr
fewOf(const Points& points)
{
  constexpr std::size_t most = 100;
  Points few;
  for (std::size_t k = 0; k < std::min(points.size(), most); ++k)
    few.push_back(points[k * points.size() / std::min(points.size(), most)]);
  return prepared(few);
}

class HullFittingOfClouds : public testing::TestWithParam<NamedPoints> {};

TEST_P(HullFittingOfClouds, EveryPointHasAPart)
{
  const PreparedScan::ConstPtr scan = fewOf(GetParam().points);
  for (const std::size_t parts : {1u, 7u}) {
    const HullFitting fitting = fitHulls(*scan, fittingOf(parts));
    expectNumbered(fitting, scan->points().size(), GetParam().name);
    EXPECT_LE(fitting.parts, std::min(parts, scan->points().size()));
    if (parts == 1) {
      EXPECT_EQ(fitting.parts, 1u);
    }
  }
}

TEST_P(HullFittingOfClouds, AnyRobotAndViewpoint)
{
  const PreparedScan::ConstPtr scan = fewOf(GetParam().points);
  for (const double radius : {0.0, 5000.0}) {
    HullFittingSettings settings = fittingOf(3);
    settings.robot_radius = radius;
    settings.viewpoints = {{0.5, 0.5, 0.5}, {1e7, -1e7, 0.0}};
    expectNumbered(fitHulls(*scan, settings), scan->points().size(), GetParam().name);
  }
}

/** Certified by a search of its own, on the points of each part. */
TEST_P(HullFittingOfClouds, NoHullStraysBeyondTheBound)
{
  const PreparedScan::ConstPtr scan = fewOf(GetParam().points);
  const HullFittingSettings settings = fittingWithin(0.3);
  const HullFitting fitting = fitHulls(*scan, settings);
  expectNumbered(fitting, scan->points().size(), GetParam().name);
  const double tolerance = 0.2 * settings.min_thickness;
  for (const auto& part : pointsOfParts(*scan, fitting))
    ASSERT_LE(hullCID(part, scan->field(), tolerance).high,
              settings.max_error + tolerance);
}

INSTANTIATE_TEST_SUITE_P(Clouds,
                         HullFittingOfClouds,
                         testing::ValuesIn(allClouds()),
                         [](const auto& info) { return info.param.name; });

TEST(HullFitting, FewPoints)
{
  for (std::size_t count = 1; count <= 5; ++count)
    for (const std::size_t parts : {1u, 9u})
      for (const double scale : {1e-4, 1.0}) {
        Points points = randomCube(count, 64);
        for (Eigen::Vector3f& p : points)
          p *= static_cast<float>(scale);
        const std::string what = std::to_string(count) + " at " + std::to_string(scale);
        const HullFitting fitting = fitHulls(*prepared(points), fittingOf(parts));
        expectNumbered(fitting, count, what);
        EXPECT_LE(fitting.parts, std::min(parts, count)) << what;
      }
}

/** Places that the hulls of given parts refuse, counted as fitHulls() does. */
std::size_t
refusedByParts(const PreparedScan& scan,
               const std::vector<int>& part,
               const HullFittingSettings& settings)
{
  const Points& points = scan.points().points;
  Progress progress({});
  const double clearance =
      std::max(settings.robot_radius, setting::free_distance.initial);
  const FreeSpace space(
      points, scan.field(), clearance, settings.viewpoints, 1, progress);
  const FittingScene scene{points,
                           scan.field(),
                           space,
                           nullptr,
                           settings.robot_radius,
                           settings.max_error,
                           settings.min_thickness,
                           1};
  std::vector<pcl::Indices> members(
      static_cast<std::size_t>(*std::max_element(part.begin(), part.end()) + 1));
  for (std::size_t i = 0; i < part.size(); ++i)
    members[static_cast<std::size_t>(part[i])].push_back(static_cast<pcl::index_t>(i));
  std::vector<Cell> cells;
  for (pcl::Indices& of_part : members)
    cells.push_back(makeCell(std::move(of_part), scene));
  return placesTaken(cells, space);
}

TEST(HullFitting, RefusesFewerPlacesThanMergingByCID)
{
  const PreparedScan::ConstPtr scan = smallRoom(1500);
  Grouping grouping(scan);
  grouping.propose(100);
  const std::vector<pcl::index_t> group = grouping.groups();
  const HullFittingSettings settings = fittingOf(20);
  const std::vector<int> part_of_group =
      pcl_cid::mergeGroups(grouping).cutAtParts(settings.parts);
  std::vector<int> merged;
  for (const pcl::index_t g : group)
    merged.push_back(part_of_group[static_cast<std::size_t>(g)]);
  const HullFitting fitting = fitHulls(*scan, settings);
  EXPECT_LE(fitting.refused_places, refusedByParts(*scan, merged, settings));
  EXPECT_EQ(refusedByParts(*scan, fitting.part, settings), fitting.refused_places);
}

TEST(HullFitting, PlacesThatNobodySawDoNotCount)
{
  RoomOptions room;
  room.seed = 65;
  SensorOptions sensor;
  sensor.seed = 66;
  sensor.points = 400;
  sensor.positions = 2;
  const LabelledScan seen = scanRoom(makeRoom(room), sensor);
  const PreparedScan::ConstPtr scan = prepared(seen.points);
  HullFittingSettings settings = fittingOf(10);
  const HullFitting all = fitHulls(*scan, settings);
  settings.viewpoints = seen.sensor_positions;
  const HullFitting fitting = fitHulls(*scan, settings);
  expectNumbered(fitting, seen.points.size(), "seen");
  EXPECT_GT(fitting.free_places, 0u);
  EXPECT_LT(fitting.free_places, all.free_places);
}

TEST(HullFitting, FewerPartsForALargerBound)
{
  const PreparedScan::ConstPtr scan = smallRoom(250);
  std::size_t parts = scan->points().size() + 1;
  for (const double max_error : {0.5, 0.9}) {
    const HullFitting fitting = fitHulls(*scan, fittingWithin(max_error));
    EXPECT_LT(fitting.parts, parts);
    parts = fitting.parts;
    for (const auto& part : pointsOfParts(*scan, fitting))
      ASSERT_LE(hullCID(part, scan->field(), 0.001).high, max_error);
  }
}

/** What the numbers of threads must agree on. */
struct NamedFitting {
  std::string name;
  HullFittingSettings settings;
};

std::vector<NamedFitting>
variedFittings()
{
  const std::vector<Eigen::Vector3d> viewpoints = {{1.0, 1.2, 1.4}, {2.0, 1.0, 1.2}};
  std::vector<NamedFitting> fittings = {{"parts", fittingOf(12)},
                                        {"seen", fittingOf(12)},
                                        {"bound", fittingWithin(0.5)},
                                        {"seen_bound", fittingWithin(0.5)}};
  fittings[1].settings.viewpoints = viewpoints;
  fittings[3].settings.viewpoints = viewpoints;
  return fittings;
}

class HullFittingThreads : public testing::TestWithParam<NamedFitting> {};

TEST_P(HullFittingThreads, SameForAnyNumberOfThreads)
{
  const PreparedScan::ConstPtr scan = smallRoom(60);
  const HullFitting serial = fitHulls(*scan, GetParam().settings, onThreads(1));
  expectNumbered(serial, scan->points().size(), GetParam().name);
  EXPECT_GT(serial.parts, 1u);
  for (const unsigned int threads : is_sanitized ? std::vector<unsigned int>{3}
                                                 : std::vector<unsigned int>{2, 3, 8}) {
    const HullFitting fitting =
        fitHulls(*scan, GetParam().settings, onThreads(threads));
    EXPECT_EQ(fitting.part, serial.part) << threads;
    EXPECT_EQ(fitting.parts, serial.parts) << threads;
    EXPECT_EQ(fitting.free_places, serial.free_places) << threads;
    EXPECT_EQ(fitting.refused_places, serial.refused_places) << threads;
  }
}

INSTANTIATE_TEST_SUITE_P(Settings,
                         HullFittingThreads,
                         testing::ValuesIn(variedFittings()),
                         [](const auto& info) { return info.param.name; });

TEST(HullFittingThreadProgress, NeverFallsAndEndsAtOne)
{
  const PreparedScan::ConstPtr scan = smallRoom(100);
  for (const unsigned int threads : {1u, 2u}) {
    ExecutionOptions execution = onThreads(threads);
    double last = 0.0;
    int calls_below_three_quarters = 0;
    execution.progress = [&](double fraction) {
      EXPECT_GE(fraction, last);
      EXPECT_LE(fraction, 1.0);
      last = fraction;
      calls_below_three_quarters += fraction < 0.75 ? 1 : 0;
      return true;
    };
    fitHulls(*scan, fittingOf(20), execution);
    EXPECT_EQ(last, 1.0);
    EXPECT_GT(calls_below_three_quarters, 2);
  }
}

TEST(HullFittingThreadProgress, CancelsAtAnyTime)
{
  const PreparedScan::ConstPtr scan = smallRoom(100);
  for (const unsigned int threads : {1u, 2u})
    for (const HullFittingSettings& settings : {fittingOf(20), fittingWithin(0.5)})
      for (const int calls : {0, 1}) {
        ExecutionOptions execution = onThreads(threads);
        int called = 0;
        execution.progress = [&](double) { return called++ < calls; };
        EXPECT_THROW(fitHulls(*scan, settings, execution), CIDCancelled) << calls;
        EXPECT_EQ(called, calls + 1);
      }
}

TEST(HullFitting, RefusesSettingsOutOfTheirRange)
{
  const PreparedScan::ConstPtr scan = prepared(twoBoxes(50, 67));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(fitHulls(*scan, fittingOf(0)), CIDException);
  for (const double bad : {0.0, nan, -0.1, -infinity})
    EXPECT_THROW(fitHulls(*scan, fittingWithin(bad)), CIDException) << bad;
  for (const double bad : {nan, -0.1, infinity}) {
    HullFittingSettings settings = fittingOf(3);
    settings.robot_radius = bad;
    EXPECT_THROW(fitHulls(*scan, settings), CIDException) << bad;
  }
  for (const double bad : {nan, 0.0, -0.1, infinity}) {
    HullFittingSettings settings = fittingOf(3);
    settings.min_thickness = bad;
    EXPECT_THROW(fitHulls(*scan, settings), CIDException) << bad;
  }
  for (const double bad : {nan, infinity}) {
    HullFittingSettings settings = fittingOf(3);
    settings.viewpoints = {{0, 0, 0}, {0, bad, 0}};
    EXPECT_THROW(fitHulls(*scan, settings), CIDException) << bad;
  }
  HullFittingSettings settings = fittingWithin(0.01);
  for (const double bad : {0.01, 0.02}) {
    settings.min_thickness = bad;
    EXPECT_THROW(fitHulls(*scan, settings), CIDException) << bad;
  }
}

} // namespace
} // namespace pcl_cid::test
