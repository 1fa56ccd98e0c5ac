/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a scan is made ready with, and what it refuses.
 */

#include "cid/working_points.h"
#include "clouds.h"
#include "lidar_scan.h"
#include "prepared_points.h"
#include "scan/working_set.h"

#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

PreparedScan::ConstPtr
prepare(RawScan scan, const PreparationSettings& settings)
{
  return std::make_shared<const PreparedScan>(std::move(scan), settings);
}

void
expectRefused(const RawScan& scan,
              const PreparationSettings& settings,
              const std::string& says)
{
  try {
    const PreparedScan made(scan, settings);
    ADD_FAILURE() << "not refused: " << says;
  }
  catch (const CIDException& error) {
    EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
  }
}

/** Two boxes, and two points far from them and from each other. */
Points
withStrays()
{
  Points points = twoBoxes(200, 81);
  points.emplace_back(40.0f, 0.0f, 0.0f);
  points.emplace_back(0.0f, 60.0f, 0.0f);
  return points;
}

TEST(PreparedScan, PlainScanIsItsPoints)
{
  const Points points = twoBoxes(100, 82);
  const PreparedScan::ConstPtr scan = prepared(points);
  EXPECT_EQ(scan->cloudSize(), 100u);
  EXPECT_EQ(scan->points().points, points);
  EXPECT_EQ(scan->field().size(), 100u);
  EXPECT_TRUE(scan->pointsAreSurface());
  EXPECT_TRUE(scan->working().areOnSurface());
  EXPECT_EQ(scan->working().points(), points);
  EXPECT_EQ(scan->start(), 0);
  EXPECT_TRUE(scan->candidates().empty());
  EXPECT_TRUE(scan->isolated().empty());
  EXPECT_FALSE(scan->density().weighted);
  EXPECT_FALSE(scan->blindSpot());
  EXPECT_EQ(scan->workingIndex(17, "seed"), 17);
}

TEST(PreparedScan, KnowsWhereItsPointsLie)
{
  RawScan scan = rawScan(twoBoxes(100, 83));
  PreparationSettings half = plainSettings();
  half.subsample = 50;
  const PreparedScan::ConstPtr drawn = prepare(scan, half);
  EXPECT_FALSE(drawn->pointsAreSurface());
  EXPECT_TRUE(drawn->working().areOnSurface());
  EXPECT_EQ(drawn->field().size(), 50u);
  scan.surface = scan.points.points;
  const PreparedScan::ConstPtr elsewhere = prepare(scan, plainSettings());
  EXPECT_FALSE(elsewhere->pointsAreSurface());
  EXPECT_FALSE(elsewhere->working().areOnSurface());
}

TEST(PreparedScan, FilledBlindSpotIsSurfaceButNotGrouped)
{
  LidarOptions options;
  options.blind = 55.0f;
  RawScan scan = rawScan(lidarScan(options));
  scan.sensor = SensorPose();
  const PreparedScan::ConstPtr filled = prepare(scan, plainSettings());
  ASSERT_TRUE(filled->blindSpot());
  EXPECT_GT(filled->blindSpot()->points, 0u);
  EXPECT_EQ(filled->field().size(), scan.points.size() + filled->blindSpot()->points);
  EXPECT_EQ(filled->working().size(), scan.points.size());
  EXPECT_FALSE(filled->pointsAreSurface());
  EXPECT_TRUE(filled->working().areOnSurface());
  PreparationSettings off = plainSettings();
  off.blind_spot = false;
  EXPECT_FALSE(prepare(scan, off)->blindSpot());
  scan.surface = scan.points.points;
  EXPECT_FALSE(prepare(scan, plainSettings())->blindSpot()) << "S is given";
}

TEST(PreparedScan, IsolatedPointsAreNeverAllCandidates)
{
  const Points points = withStrays();
  PreparationSettings settings = plainSettings();
  settings.isolated_neighbors = 4;
  EXPECT_EQ(prepared(points, settings)->isolated(), (pcl::Indices{200, 201}));
  settings.seed_candidates = pcl::make_shared<pcl::Indices>(pcl::Indices{200, 201});
  const PreparedScan::ConstPtr strays_alone = prepared(points, settings);
  EXPECT_EQ(strays_alone->candidates(), (pcl::Indices{200, 201}));
  EXPECT_TRUE(strays_alone->isolated().empty());
  settings.seed_candidates = pcl::make_shared<pcl::Indices>(pcl::Indices{3, 201});
  EXPECT_EQ(prepared(points, settings)->isolated(), (pcl::Indices{200, 201}));
  // All points are isolated: one has no neighbors.
  settings.seed_candidates = nullptr;
  EXPECT_TRUE(prepared({{1, 2, 3}}, settings)->isolated().empty());
  for (std::uint64_t random_seed = 0; random_seed < 50; ++random_seed) {
    settings.start_index.reset();
    settings.random_seed = random_seed;
    EXPECT_LT(prepared(points, settings)->start(), 200) << "a start that is drawn";
  }
}

TEST(PreparedScan, SubsampleHoldsWhatIsRequired)
{
  const Points points = twoBoxes(300, 84);
  PreparationSettings settings = plainSettings();
  settings.subsample = 30;
  settings.required = {299, 4, 120};
  for (std::uint64_t random_seed = 0; random_seed < 10; ++random_seed) {
    settings.random_seed = random_seed;
    const PreparedScan::ConstPtr scan = prepared(points, settings);
    EXPECT_EQ(scan->working().size(), 30u);
    for (const pcl::index_t point : settings.required)
      EXPECT_GE(scan->workingIndex(point, "seed"), 0);
    EXPECT_EQ(scan->start(), scan->workingIndex(299, "start"));
  }
}

TEST(PreparedScan, SameForEveryNumberOfThreads)
{
  RawScan scan = rawScan(withStrays());
  scan.colors.resize(scan.points.size(), {10, 200, 30});
  scan.colors[5] = {200, 0, 0};
  PreparationSettings settings;
  settings.density = DensityWeight::on;
  settings.color = 0.01f;
  settings.subsample = 150;
  settings.random_seed = 3;
  ExecutionOptions execution;
  execution.threads = 1;
  const PreparedScan serial(scan, settings, execution);
  for (const unsigned int threads : {2u, 3u, 8u}) {
    execution.threads = threads;
    const PreparedScan parallel(scan, settings, execution);
    EXPECT_EQ(parallel.working().points(), serial.working().points());
    EXPECT_EQ(parallel.start(), serial.start());
    EXPECT_EQ(parallel.isolated(), serial.isolated());
    EXPECT_EQ(parallel.softSeed(), serial.softSeed());
    EXPECT_EQ(parallel.density().spread, serial.density().spread);
    for (std::size_t i = 0; i < 150; ++i) {
      const PairCost one = serial.working().costs().between(0, i);
      const PairCost other = parallel.working().costs().between(0, i);
      EXPECT_EQ(one.weight, other.weight);
      EXPECT_EQ(one.cue, other.cue);
    }
  }
}

TEST(PreparedScan, RefusesSettingsThatAreOutOfRange)
{
  using Change = std::function<void(PreparationSettings&)>;
  const struct {
    Change change;
    std::string says;
  } bad[] = {
      {[](auto& s) { s.subsample = -1; },
       "the subsample is -1; it must be a whole number, 0 or more"},
      {[](auto& s) { s.density_power = 4.5f; },
       "the density power is 4.5; it must be a number, 0 to 4"},
      {[](auto& s) { s.density_power = NAN; }, "the density power is nan"},
      {[](auto& s) { s.isolated_neighbors = 9; },
       "the least number of near neighbors is 9; it must be a whole number, 0 to 8"},
      {[](auto& s) { s.color = -0.5f; },
       "the color weight is -0.5; it must be a number of metres, 0 or more"},
      {[](auto& s) { s.start_index = -2; },
       "the start index is -2; it must be a whole number, 0 or more"},
      {[](auto& s) { s.start_index = 10; },
       "the start index is point 10; it must be a finite, selected point"},
      {[](auto& s) {
         s.seed_candidates = pcl::make_shared<pcl::Indices>(pcl::Indices{10, -1});
       },
       "none of the seed candidates is a finite, selected point"},
      {[](auto& s) {
         s.subsample = 5;
         s.required = {2, 11};
       },
       "the seed is point 11; it must be a finite, selected point"}};
  const RawScan scan = rawScan(randomCube(10, 85));
  for (const auto& each : bad) {
    PreparationSettings settings = plainSettings();
    each.change(settings);
    expectRefused(scan, settings, each.says);
  }
}

TEST(PreparedScan, RefusesScansThatCannotBe)
{
  const RawScan good = rawScan(randomCube(10, 86));
  PreparationSettings settings = plainSettings();
  expectRefused(RawScan(), settings, "there is no finite point");
  RawScan scan = rawScan({{1e30f, 0, 0}, {0, 0, 0}});
  expectRefused(scan, settings, "from the middle of the cloud");
  scan = good;
  scan.surface = {{0, 0, 3e15f}};
  expectRefused(scan, settings, "from the middle of the cloud");
  scan = good;
  scan.points.points[2].y() = NAN;
  expectRefused(scan, settings, "must be finite");
  scan = good;
  scan.points.source.pop_back();
  expectRefused(scan, settings, "10 points and 9 indices");
  scan = good;
  std::swap(scan.points.source[3], scan.points.source[4]);
  expectRefused(scan, settings, "ascend");
  scan = good;
  scan.cloud_size = 9;
  expectRefused(scan, settings, "the index of a point is 9; it must be 0 to 9 - 1");
  settings.color = 0.1f;
  scan = good;
  expectRefused(scan, settings, "there are 0 colors");
  scan.colors.resize(9);
  expectRefused(scan, settings, "there are 9 colors");
}

TEST(PreparedScan, CancelledWhileItIsMade)
{
  ExecutionOptions execution;
  execution.progress = [](double) { return false; };
  EXPECT_THROW(PreparedScan(rawScan(randomCube(500, 87)), plainSettings(), execution),
               CIDCancelled);
}

} // namespace
} // namespace pcl_cid::test
