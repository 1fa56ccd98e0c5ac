/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scores, sampling and the choice of the best, by hand-worked examples.
 */

#include "comparison.h"
#include "depth_sensor.h"
#include "euclidean_sampling.h"
#include "room_scene.h"

#include "cid_curve.h"

#include <pcl_cid/cid_sampler.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace pcl_cid::benchmarks {
namespace {

/** A small furnished room as a sensor sees it. */
PeerScan
smallRoom(std::size_t points)
{
  test::SensorOptions sensor;
  sensor.points = points;
  const test::LabelledScan scan =
      test::scanRoom(test::makeRoom(test::RoomOptions()), sensor);
  PeerScan peer;
  peer.cloud = pcl::make_shared<Cloud>();
  for (const Eigen::Vector3f& p : scan.points)
    peer.cloud->push_back(pcl::PointXYZ(p.x(), p.y(), p.z()));
  peer.source.resize(scan.points.size());
  std::iota(peer.source.begin(), peer.source.end(), 0);
  peer.truth.label = scan.instance;
  peer.truth.semantic.assign(scan.semantic.begin(), scan.semantic.end());
  for (const Eigen::Vector3d& p : scan.sensor_positions)
    peer.viewpoints.emplace_back(p.cast<float>());
  return peer;
}

TEST(PeerScores, PurityByHand)
{
  PeerScan scan;
  scan.truth.label = {5, 5, 6, 6, 6, 0, 6};
  scan.truth.semantic.assign(7, 1);
  // Group 1 has 2 of 3 points in instance 5, group 2 both in 6; the last point is in no
  // group, and the one before it has no truth.
  EXPECT_DOUBLE_EQ(purityOf({1, 1, 1, 2, 2, 2, 0}, scan), 4.0 / 6.0);
  EXPECT_EQ(countLabels({0, 4, 4, 9}), 2u);
}

TEST(PeerScores, SeedsNameTheirGroups)
{
  // Seeds are points 3 and 0; the truth of point 0 is 8, that of point 3 none.
  EXPECT_EQ(labelsOfSeeds({2, 1, 0, 1}, {3, 0}, {8, 8, 9, 0}),
            (std::vector<std::uint32_t>{8, 0, 0, 0}));
}

TEST(PeerScores, AveragePrecisionByHand)
{
  // Class 1 has the instances 1 and 2, class 2 the instance 3. Of 1, 3 of 4 points are
  // found and 1 is wrong: IoU 3/5. Of 2, 1 of 2 is found and 1 is wrong: 1/3. Nothing
  // is found of 3.
  PeerScan scan;
  scan.truth.label = {1, 1, 1, 1, 2, 2, 3, 3};
  scan.truth.semantic = {1, 1, 1, 1, 1, 1, 2, 2};
  const EvaluationFigures mean = scoreLabels({1, 1, 1, 2, 2, 1, 0, 0}, scan).mean;
  EXPECT_DOUBLE_EQ(mean.ap25, (1.0 + 0.0) / 2);
  // R = 1/2, P = 1/2: 1/2 * 3/2 / 2.
  EXPECT_DOUBLE_EQ(mean.ap50, (0.375 + 0.0) / 2);
  EXPECT_DOUBLE_EQ(mean.ap75, 0.0);
}

TEST(EuclideanSampling, SeedsAreFarthestPointsAndGroupsNearestSeeds)
{
  const PeerScan scan = smallRoom(500);
  const Points points = finitePoints(*scan.cloud).points;
  const EuclideanSample sample = sampleFarthestFirst(points, 17, 20);
  ASSERT_EQ(sample.seeds.size(), 20u);
  EXPECT_EQ(sample.seeds.front(), 17);
  const auto nearest = [&](std::size_t i, std::size_t seeds) {
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t k = 0; k < seeds; ++k)
      least = std::min(least,
                       (points[i] - points[static_cast<std::size_t>(sample.seeds[k])])
                           .squaredNorm());
    return least;
  };
  for (std::size_t k = 1; k < sample.seeds.size(); ++k)
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_LE(nearest(i, k), nearest(static_cast<std::size_t>(sample.seeds[k]), k));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto seed = static_cast<std::size_t>(
        sample.seeds[static_cast<std::size_t>(sample.group[i])]);
    EXPECT_EQ((points[i] - points[seed]).squaredNorm(), nearest(i, 20));
  }
}

TEST(EuclideanSampling, DuplicatesNeverBecomeSeeds)
{
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  const EuclideanSample sample = sampleFarthestFirst(points, 2, 10);
  EXPECT_EQ(sample.seeds, (pcl::Indices{2, 1}));
  EXPECT_EQ(sample.group, (std::vector<pcl::index_t>{0, 1, 0, 1}));
}

TEST(PeerMethods, PointsWithoutALabelTakeTheNearestOne)
{
  Cloud cloud;
  for (const float x : {0.0f, 1.0f, 4.0f, 9.0f, 10.0f})
    cloud.push_back(pcl::PointXYZ(x, 0, 0));
  std::vector<std::uint32_t> labels = {3, 0, 0, 0, 5};
  labelTheRest(cloud, labels);
  EXPECT_EQ(labels, (std::vector<std::uint32_t>{3, 3, 3, 5, 5}));
  std::vector<std::uint32_t> none(5, 0);
  labelTheRest(cloud, none);
  EXPECT_EQ(none, std::vector<std::uint32_t>(5, 0));
  EXPECT_DOUBLE_EQ(pointSpacing(cloud), 1.0);
}

TEST(PeerMethods, EachLabelsEveryPointTheSameTwice)
{
  const PeerScan scan = smallRoom(3000);
  SeedSettings seeds;
  seeds.seeds = 20;
  std::vector<PeerRun> runs = {cidRuns(scan, seeds, 0).front(),
                               cidRuns(scan, seeds, 1000).front(),
                               euclideanRuns(scan, seeds).front(),
                               lccpRuns(scan, pointSpacing(*scan.cloud)).front(),
                               regionGrowingRuns(scan).front(),
                               wcsegRuns(scan).front()};
  for (const PeerRun& run : runs) {
    const PeerRow first = measureAndScore(scan, run);
    const PeerRow second = measureAndScore(scan, run);
    const std::string what = run.method + " " + settingsAsText(run);
    ASSERT_EQ(first.labels.size(), scan.cloud->size()) << what;
    EXPECT_EQ(first.labels, second.labels) << what;
    EXPECT_EQ(std::count(first.labels.begin(), first.labels.end(), 0u), 0) << what;
    EXPECT_GT(first.parts, 1u) << what;
    EXPECT_LT(first.parts, scan.cloud->size()) << what;
    EXPECT_GT(first.purity, 0.0) << what;
    const bool seeded =
        run.method == "cid" || run.method == "cid20k" || run.method == "euclidean";
    EXPECT_EQ(first.hasSeeds(), seeded) << what;
  }
}

TEST(CIDCurve, IsThatOfTheClasses)
{
  const PeerScan scan = smallRoom(2000);
  SeedSettings settings;
  settings.seeds = 10;
  const std::map<std::size_t, double> purity =
      purityOfCID(scan, settings, {1, 5, 10, 15});
  ASSERT_EQ(purity.size(), 4u);

  std::map<std::uint32_t, std::size_t> sizes;
  for (const std::uint32_t instance : scan.truth.label)
    ++sizes[instance];
  std::size_t largest = 0;
  for (const auto& [instance, size] : sizes)
    largest = std::max(largest, size);
  EXPECT_DOUBLE_EQ(purity.at(1),
                   static_cast<double>(largest) /
                       static_cast<double>(scan.cloud->size()));
  for (const int seeds : {10, 15}) {
    SeedSettings as_many = settings;
    as_many.seeds = seeds;
    const Measurement cid = cidRuns(scan, as_many, 0).front().work();
    EXPECT_DOUBLE_EQ(purity.at(static_cast<std::size_t>(seeds)),
                     purityOf(cid.labels, scan));
  }
}

TEST(CIDCurve, TheTreeMayHaveAnotherNumberOfGroupsThanMethodsHaveSeeds)
{
  const PeerScan scan = smallRoom(2000);
  SeedSettings settings;
  settings.seeds = 10;
  settings.tree_seeds = 15;
  SeedSettings as_many;
  as_many.seeds = 15;
  EXPECT_EQ(purityOfCID(scan, settings, {5, 12, 20}),
            purityOfCID(scan, as_many, {5, 12, 20}));
}

TEST(Comparison, TheBestOfAPeerIsTheOneFarthestAheadOfCIDAmongComparableOnes)
{
  const PeerScan scan = smallRoom(2000);
  SeedSettings settings;
  settings.seeds = 10;
  const ComparableParts comparable = comparableParts(scan);
  const auto row = [](std::size_t parts, double purity) {
    PeerRow made;
    made.run.method = "peer";
    made.parts = parts;
    made.purity = purity;
    return made;
  };
  std::vector<PeerRow> rows = {row(comparable.least - 1, 1.0),
                               row(comparable.least, 0.5),
                               row(comparable.least, 0.75),
                               row(comparable.most, 0.75),
                               row(comparable.most + 1, 1.0)};
  compareWithCID(scan, settings, rows);
  // CID is purer with more parts, so the same purity is worth more with fewer.
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k].is_best, k == 2);
    EXPECT_EQ(rows[k].cid_purity.has_value(), comparable.contains(rows[k].parts));
  }
}

TEST(Comparison, ARunThatFailsSaysSoAndHasNoFigures)
{
  const PeerScan scan = smallRoom(2000);
  const PeerRow row = measureAndScore(scan, {"peer", {}, []() -> Measurement {
                                               throw std::runtime_error("on purpose");
                                             }});
  EXPECT_FALSE(row.failure.empty());
  std::vector<PeerRow> rows = {row};
  compareWithCID(scan, {}, rows);
  EXPECT_FALSE(rows[0].cid_purity.has_value());
  EXPECT_FALSE(rows[0].is_best);
}

TEST(Comparison, TheCurveHasEveryComparableNumberOfParts)
{
  const PeerScan scan = smallRoom(2000);
  SeedSettings settings;
  settings.seeds = 10;
  const ComparableParts comparable = comparableParts(scan);
  const std::map<std::size_t, double> curve = cidCurve(scan, settings);
  ASSERT_EQ(curve.size(), comparable.most - comparable.least + 1);
  EXPECT_EQ(curve.begin()->first, comparable.least);
  const std::set<std::size_t> ends = {comparable.least, comparable.most};
  for (const auto& [parts, purity] : purityOfCID(scan, settings, ends))
    EXPECT_DOUBLE_EQ(curve.at(parts), purity);
}

TEST(ChildProcess, SendsSeedsAndLabels)
{
  const Measurement received = measureInChild([] {
    Measurement sent;
    sent.seconds = 1.5;
    sent.seeds = {3, 1, 4};
    sent.labels.assign(100000, 7); // more than a pipe holds at once
    return sent;
  });
  EXPECT_EQ(received.seconds, 1.5);
  EXPECT_EQ(received.seeds, (pcl::Indices{3, 1, 4}));
  EXPECT_EQ(received.labels, std::vector<std::uint32_t>(100000, 7));
  EXPECT_THROW(
      measureInChild([]() -> Measurement { throw std::runtime_error("on purpose"); }),
      std::runtime_error);
}

} // namespace
} // namespace pcl_cid::benchmarks
