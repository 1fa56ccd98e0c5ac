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

} // namespace
} // namespace pcl_cid::test
