/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CIDLabelPropagation: three ways to label, and what seeds must be.
 */

#include "clouds.h"
#include "oracle.h"

#include <pcl_cid/cid_label_propagation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using Propagation = CIDLabelPropagation<pcl::PointXYZ>;

Propagation
propagationFor(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud)
{
  Propagation propagation;
  propagation.setInputCloud(cloud);
  propagation.setNumberOfSeeds(8);
  propagation.setNumberOfSamples(30);
  return propagation;
}

std::vector<std::uint32_t>
labelled(Propagation& propagation)
{
  std::vector<std::uint32_t> labels;
  propagation.segment(labels);
  return labels;
}

TEST(CIDLabelPropagation, OneClickOnEachOfTwoObjectsLabelsBoth)
{
  const Points points = twoBoxes(500, 91);
  Propagation propagation = propagationFor(toCloud(points));
  propagation.setSeeds({0, 1}, {7, 9});
  const std::vector<std::uint32_t> labels = labelled(propagation);
  const Oracle oracle(points, 30);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double to_first = oracle.pointCID(points[i], points[0]);
    const double to_second = oracle.pointCID(points[i], points[1]);
    if (std::abs(to_first - to_second) > agreementTolerance(points)) {
      EXPECT_EQ(labels[i], to_first < to_second ? 7u : 9u);
    }
  }
}

TEST(CIDLabelPropagation, WithoutLabelsTheLabelIsTheGroupNumberPlusOne)
{
  Propagation propagation = propagationFor(toCloud(twoBoxes(300, 92)));
  const std::vector<std::uint32_t> labels = labelled(propagation);
  const SeedProposal& proposal = propagation.getProposal();
  ASSERT_EQ(proposal.seeds.size(), 8u);
  for (std::size_t i = 0; i < labels.size(); ++i)
    EXPECT_EQ(labels[i], static_cast<std::uint32_t>(proposal.group[i] + 1));
}

TEST(CIDLabelPropagation, AnnotatorIsAskedOnceForEachSeed)
{
  Propagation propagation = propagationFor(toCloud(twoBoxes(300, 93)));
  pcl::Indices asked;
  propagation.setAnnotator([&](pcl::index_t seed) {
    asked.push_back(seed);
    return static_cast<std::uint32_t>(seed % 2 + 10);
  });
  const std::vector<std::uint32_t> labels = labelled(propagation);
  EXPECT_EQ(asked, propagation.getProposal().seeds);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const auto group = static_cast<std::size_t>(propagation.getProposal().group[i]);
    EXPECT_EQ(labels[i], static_cast<std::uint32_t>(asked[group] % 2 + 10));
  }
}

TEST(CIDLabelPropagation, LabelZeroIsALabelThatMeansNone)
{
  Propagation propagation = propagationFor(toCloud(twoBoxes(200, 94)));
  propagation.setSeeds({0, 1}, {0, 3});
  const std::vector<std::uint32_t> labels = labelled(propagation);
  EXPECT_EQ(labels[0], 0u);
  EXPECT_EQ(labels[1], 3u);
}

TEST(CIDLabelPropagation, CloudOutHasTheShapeOfTheCloudIn)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  auto cloud = toCloud(twoBoxes(120, 95));
  (*cloud)[5].x = nan;
  (*cloud)[77].z = nan;
  cloud->width = 12;
  cloud->height = 10;
  cloud->is_dense = false;
  cloud->header.frame_id = "map";
  cloud->sensor_origin_ = Eigen::Vector4f(1, 2, 3, 0);
  Propagation propagation = propagationFor(cloud);
  pcl::PointCloud<pcl::PointXYZL> out;
  propagation.segment(out);
  EXPECT_EQ(out.width, 12u);
  EXPECT_EQ(out.height, 10u);
  EXPECT_EQ(out.header.frame_id, "map");
  EXPECT_EQ(out.sensor_origin_, cloud->sensor_origin_);
  EXPECT_FALSE(out.is_dense);
  ASSERT_EQ(out.size(), cloud->size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const bool finite = (*cloud)[i].getVector3fMap().allFinite();
    EXPECT_EQ(out[i].label > 0, finite);
    if (finite) {
      EXPECT_EQ(out[i].getVector3fMap(), (*cloud)[i].getVector3fMap());
    }
  }
}

TEST(CIDLabelPropagation, SubsampleHoldsTheGivenSeeds)
{
  Propagation propagation = propagationFor(toCloud(twoBoxes(2000, 96)));
  propagation.setSubsample(100);
  propagation.setSeeds({1998, 3}, {4, 5});
  const std::vector<std::uint32_t> labels = labelled(propagation);
  EXPECT_EQ(labels[1998], 4u);
  EXPECT_EQ(labels[3], 5u);
  for (const std::uint32_t label : labels)
    EXPECT_TRUE(label == 4u || label == 5u);
}

TEST(CIDLabelPropagation, SameBytesForEveryNumberOfThreads)
{
  const auto cloud = toCloud(twoBoxes(500, 97));
  Propagation serial = propagationFor(cloud);
  serial.setNumberOfThreads(1);
  const std::vector<std::uint32_t> expected = labelled(serial);
  for (const unsigned int threads : {2u, 3u, 8u}) {
    Propagation parallel = propagationFor(cloud);
    parallel.setNumberOfThreads(threads);
    EXPECT_EQ(labelled(parallel), expected);
  }
}

TEST(CIDLabelPropagation, CleansUpWhenAsked)
{
  Propagation propagation = propagationFor(toCloud(twoBoxes(3000, 98)));
  propagation.setNumberOfSeeds(30);
  propagation.setAnnotator([](pcl::index_t seed) { return seed % 4; });
  EXPECT_FALSE(propagation.getCleanUp());
  const std::vector<std::uint32_t> plain = labelled(propagation);
  const std::vector<pcl::index_t> group = propagation.getProposal().group;
  std::vector<std::uint32_t> seed_labels;
  for (const pcl::index_t seed : propagation.getProposal().seeds)
    seed_labels.push_back(static_cast<std::uint32_t>(seed % 4));

  double told = 0.0;
  propagation.setProgressCallback([&](double fraction) {
    EXPECT_GE(fraction, told);
    told = fraction;
    return true;
  });
  propagation.setCleanUp(true);
  EXPECT_TRUE(propagation.getCleanUp());
  const std::vector<std::uint32_t> clean = labelled(propagation);
  EXPECT_NE(clean, plain);
  EXPECT_EQ(clean, cleanBoundaries(*propagation.getGrouping(), seed_labels));
  EXPECT_EQ(propagation.getProposal().group, group) << "groups stay as they are";
  EXPECT_EQ(told, 1.0);

  propagation.setProgressCallback({});
  propagation.setCleanUp(false);
  EXPECT_EQ(labelled(propagation), plain);
}

TEST(CIDLabelPropagation, CancelledCleaningLeavesNothing)
{
  Propagation propagation = propagationFor(toCloud(twoBoxes(3000, 98)));
  propagation.setCleanUp(true);
  std::vector<std::uint32_t> labels = labelled(propagation);
  propagation.setProgressCallback([](double fraction) { return fraction < 0.6; });
  EXPECT_THROW(propagation.segment(labels), CIDCancelled);
  EXPECT_TRUE(labels.empty());
  EXPECT_TRUE(propagation.getProposal().seeds.empty());
}

TEST(CIDLabelPropagation, RefusesBadSeeds)
{
  auto cloud = toCloud(randomCube(50, 98));
  (*cloud)[9].y = std::numeric_limits<float>::infinity();
  Propagation propagation = propagationFor(cloud);
  EXPECT_THROW(propagation.setSeeds({}, {}), CIDException);
  EXPECT_THROW(propagation.setSeeds({1, 2}, {1}), CIDException);
  EXPECT_THROW(propagation.setSeeds({1, 2, 1}, {1, 2, 3}), CIDException);
  EXPECT_TRUE(propagation.getSeeds().empty());
  propagation.setSeeds({1, 2, 1}, {5, 6, 5}); // twice with one label counts once
  EXPECT_EQ(propagation.getSeeds(), (pcl::Indices{1, 2}));
  EXPECT_EQ(propagation.getSeedLabels(), (std::vector<std::uint32_t>{5, 6}));
  for (const pcl::index_t seed : {-1, 50, 9}) {
    propagation.setSeeds({seed}, {1});
    std::vector<std::uint32_t> labels = {1};
    EXPECT_THROW(propagation.segment(labels), CIDException) << seed;
    EXPECT_TRUE(labels.empty());
  }
  propagation.clearSeeds();
  EXPECT_EQ(labelled(propagation).size(), 50u);
}

TEST(CIDLabelPropagation, AnnotatorExceptionReachesTheCallerAndLeavesNothing)
{
  Propagation propagation = propagationFor(toCloud(randomCube(50, 99)));
  propagation.setAnnotator(
      [](pcl::index_t) -> std::uint32_t { throw std::runtime_error("gone home"); });
  pcl::PointCloud<pcl::PointXYZL> out;
  EXPECT_THROW(propagation.segment(out), std::runtime_error);
  EXPECT_TRUE(out.empty());
  EXPECT_TRUE(propagation.getProposal().seeds.empty());
}

TEST(CIDLabelPropagation, NothingCanBeCorrectedAfterTheAnnotatorFailed)
{
  Propagation propagation = propagationFor(toCloud(randomCube(50, 100)));
  pcl::Indices asked;
  propagation.setAnnotator([&](pcl::index_t seed) -> std::uint32_t {
    asked.push_back(seed);
    if (asked.size() == 3)
      throw std::runtime_error("gone home");
    return 1;
  });
  std::vector<std::uint32_t> labels;
  EXPECT_THROW(propagation.segment(labels), std::runtime_error);
  EXPECT_THROW(propagation.setLabel(asked[0], 2), CIDException);
  EXPECT_THROW(propagation.removeSeeds({asked[0]}), CIDException);
  EXPECT_THROW(propagation.addSeeds({asked[0] == 1 ? 2 : 1}, {2}), CIDException);
  EXPECT_EQ(labelled(propagation).size(), 50u) << "the annotator is back";
}

/** What a new object gives with the seeds and labels of another. */
std::vector<std::uint32_t>
labelledAnew(const Propagation& propagation)
{
  Propagation anew = propagationFor(propagation.getInputCloud());
  anew.setSubsample(propagation.getSubsample());
  anew.setSeeds(propagation.getSeeds(), propagation.getSeedLabels());
  return labelled(anew);
}

TEST(CIDLabelPropagation, CorrectedEqualsANewObjectWithTheSameSeeds)
{
  const auto cloud = toCloud(twoBoxes(500, 101));
  for (const int subsample : {0, 150}) {
    SCOPED_TRACE(subsample);
    Propagation propagation = propagationFor(cloud);
    propagation.setSubsample(subsample);
    const std::vector<std::uint32_t> first = labelled(propagation);
    const pcl::Indices proposed = propagation.getProposal().seeds;
    pcl::Indices others;
    for (pcl::index_t i = 0; others.size() < 3; i += 7)
      if (std::count(proposed.begin(), proposed.end(), i) == 0)
        others.push_back(i);

    propagation.addSeeds(others, {40, 41, 42});
    pcl::Indices all = proposed;
    all.insert(all.end(), others.begin(), others.end());
    EXPECT_EQ(propagation.getSeeds(), all);
    EXPECT_EQ(propagation.getProposal().seeds, all);
    EXPECT_EQ(propagation.getSeedLabels(),
              (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 7, 8, 40, 41, 42}));
    const std::vector<std::uint32_t> added = labelled(propagation);
    EXPECT_NE(added, first);
    EXPECT_EQ(added, labelledAnew(propagation));
    EXPECT_EQ(added[static_cast<std::size_t>(others[1])], 41u);

    propagation.removeSeeds({others[0], proposed[2], proposed[0]});
    EXPECT_EQ(propagation.getSeedLabels(),
              (std::vector<std::uint32_t>{2, 4, 5, 6, 7, 8, 41, 42}));
    EXPECT_EQ(labelled(propagation), labelledAnew(propagation));

    const std::vector<pcl::index_t> groups = propagation.getProposal().group;
    propagation.setLabel(others[2], 99);
    const std::vector<std::uint32_t> relabelled = labelled(propagation);
    EXPECT_EQ(relabelled, labelledAnew(propagation));
    EXPECT_EQ(relabelled[static_cast<std::size_t>(others[2])], 99u);
    EXPECT_EQ(propagation.getProposal().group, groups);

    propagation.clearSeeds(); // as if nothing had been corrected
    EXPECT_EQ(labelled(propagation), first);
  }
}

TEST(CIDLabelPropagation, CorrectionsCompareNewSeedsOnly)
{
  Propagation propagation = propagationFor(toCloud(twoBoxes(500, 102)));
  labelled(propagation);
  const pcl::Indices proposed = propagation.getProposal().seeds;
  const pcl::index_t other =
      std::count(proposed.begin(), proposed.end(), 5) == 0 ? 5 : 6;
  propagation.addSeeds({other}, {9});
  propagation.removeSeeds({proposed[1]});
  labelled(propagation);
  EXPECT_EQ(propagation.getGrouping()->comparisons(), 9u);
}

TEST(CIDLabelPropagation, RefusedCorrectionsChangeNothing)
{
  auto cloud = toCloud(twoBoxes(300, 103));
  (*cloud)[9].y = std::numeric_limits<float>::infinity();
  for (const int subsample : {0, 100}) {
    SCOPED_TRACE(subsample);
    Propagation propagation = propagationFor(cloud);
    propagation.setSubsample(subsample);
    EXPECT_THROW(propagation.addSeeds({1}, {1}), CIDException) << "nothing to correct";
    EXPECT_THROW(propagation.removeSeeds({1}), CIDException);
    EXPECT_THROW(propagation.setLabel(1, 1), CIDException);
    const std::vector<std::uint32_t> before = labelled(propagation);
    const SeedProposal proposal = propagation.getProposal();
    const Grouping::ConstPtr grouping = propagation.getGrouping();
    const pcl::index_t seed = proposal.seeds[3];
    pcl::index_t other = 20;
    while (std::count(proposal.seeds.begin(), proposal.seeds.end(), other) > 0)
      ++other;
    EXPECT_THROW(propagation.addSeeds({other}, {}), CIDException);
    EXPECT_THROW(propagation.addSeeds({seed}, {5}), CIDException) << "a seed already";
    EXPECT_THROW(propagation.addSeeds({other, other}, {5, 5}), CIDException);
    for (const pcl::index_t bad : {-1, 300, 9})
      EXPECT_THROW(propagation.addSeeds({other, bad}, {5, 6}), CIDException) << bad;
    EXPECT_THROW(propagation.removeSeeds({other}), CIDException) << "no seed";
    EXPECT_THROW(propagation.removeSeeds({seed, seed}), CIDException) << "twice";
    EXPECT_THROW(propagation.removeSeeds(proposal.seeds), CIDException) << "all";
    EXPECT_THROW(propagation.setLabel(other, 5), CIDException);
    propagation.setProgressCallback([](double) { return false; });
    EXPECT_THROW(propagation.addSeeds({other}, {5}), CIDCancelled);
    EXPECT_THROW(propagation.removeSeeds({seed}), CIDCancelled);
    propagation.setProgressCallback({});
    EXPECT_TRUE(propagation.getSeeds().empty());
    EXPECT_EQ(propagation.getGrouping(), grouping);
    expectSameProposal(propagation.getProposal(), proposal);
    propagation.setLabel(seed, 77); // there still is a result to correct
    std::vector<std::uint32_t> expected = before;
    for (std::uint32_t& label : expected)
      label = label == 4 ? 77 : label;
    EXPECT_EQ(labelled(propagation), expected);
  }
}

TEST(CIDLabelPropagation, AnotherInputCannotBeCorrected)
{
  Propagation propagation = propagationFor(toCloud(twoBoxes(300, 104)));
  labelled(propagation);
  const pcl::index_t seed = propagation.getProposal().seeds[0];
  propagation.setInputCloud(toCloud(twoBoxes(300, 105)));
  EXPECT_THROW(propagation.addSeeds({seed + 1}, {1}), CIDException);
  EXPECT_THROW(propagation.removeSeeds({seed}), CIDException);
  EXPECT_THROW(propagation.setLabel(seed, 1), CIDException);
}

TEST(CIDLabelPropagation, KeepsCIDsWhenAsked)
{
  const Points points = twoBoxes(200, 106);
  Propagation propagation = propagationFor(toCloud(points));
  propagation.setPaperSettings();
  EXPECT_FALSE(propagation.getKeepCID());
  labelled(propagation);
  EXPECT_TRUE(propagation.getProposal().cid.empty());
  propagation.setKeepCID(true);
  labelled(propagation);
  SeedProposalOptions options;
  options.samples = 30;
  expectAgreesWithAlgorithm1(propagation.getProposal(), points, points, options);
  EXPECT_EQ(propagation.getGrouping()->comparisons(), 8u);
}

TEST(CIDLabelPropagation, CloudOutKeepsTheOtherFields)
{
  const Points points = twoBoxes(200, 107);
  pcl::PointCloud<pcl::PointXYZRGBNormal>::Ptr cloud(
      new pcl::PointCloud<pcl::PointXYZRGBNormal>);
  for (std::size_t i = 0; i < points.size(); ++i) {
    pcl::PointXYZRGBNormal point;
    point.getVector3fMap() = points[i];
    point.r = static_cast<std::uint8_t>(i);
    point.g = 17;
    point.b = static_cast<std::uint8_t>(255 - i);
    point.normal_x = 1.0f;
    cloud->push_back(point);
  }
  CIDLabelPropagation<pcl::PointXYZRGBNormal> propagation;
  propagation.setInputCloud(cloud);
  propagation.setNumberOfSeeds(8);
  std::vector<std::uint32_t> labels;
  propagation.segment(labels);
  pcl::PointCloud<pcl::PointXYZRGBL> colored;
  propagation.segment(colored);
  pcl::PointCloud<pcl::PointXYZL> plain;
  propagation.segment(plain);
  ASSERT_EQ(colored.size(), 200u);
  ASSERT_EQ(plain.size(), 200u);
  for (std::size_t i = 0; i < 200; ++i) {
    EXPECT_EQ(colored[i].getVector3fMap(), points[i]);
    EXPECT_EQ(colored[i].r, (*cloud)[i].r);
    EXPECT_EQ(colored[i].g, 17);
    EXPECT_EQ(colored[i].b, (*cloud)[i].b);
    EXPECT_EQ(colored[i].label, labels[i]);
    EXPECT_EQ(plain[i].getVector3fMap(), points[i]);
    EXPECT_EQ(plain[i].label, labels[i]);
  }
}

} // namespace
} // namespace pcl_cid::test
