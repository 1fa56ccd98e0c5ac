/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CIDConvexAbstraction: parts, hulls and cuts.
 */

#include "clouds.h"
#include "hulls.h"
#include "oracle.h"

#include <pcl_cid/cid_convex_abstraction.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using Abstraction = CIDConvexAbstraction<pcl::PointXYZ>;

Abstraction
abstractionFor(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud)
{
  Abstraction abstraction;
  abstraction.setInputCloud(cloud);
  abstraction.setNumberOfSeeds(10);
  abstraction.setNumberOfSamples(30);
  abstraction.setGroupSampleSize(8);
  return abstraction;
}

/** Every selected point in exactly one part; the parts' indices ascend. */
void
expectPartition(const std::vector<pcl::PointIndices>& parts,
                const pcl::Indices& selected)
{
  pcl::Indices all;
  for (const pcl::PointIndices& part : parts) {
    EXPECT_FALSE(part.indices.empty());
    EXPECT_TRUE(std::is_sorted(part.indices.begin(), part.indices.end()));
    all.insert(all.end(), part.indices.begin(), part.indices.end());
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, selected);
}

TEST(CIDConvexAbstraction, TwoBoxesBecomeTwoParts)
{
  const Points points = twoBoxes(600, 101);
  Abstraction abstraction = abstractionFor(toCloud(points));
  abstraction.setNumberOfParts(2);
  std::vector<ConvexPart> parts;
  abstraction.reconstruct(parts);
  ASSERT_EQ(parts.size(), 2u);
  for (const ConvexPart& part : parts) {
    for (const pcl::index_t index : part.indices)
      EXPECT_EQ(index % 2, part.indices.front() % 2);
    EXPECT_NEAR(part.volume, 1.0, 0.1);
    EXPECT_FALSE(part.thickened);
  }
}

TEST(CIDConvexAbstraction, EachCutGivesThatManyPartsAndAPartition)
{
  Points points = twoBoxes(400, 102);
  points[17].x() = std::numeric_limits<float>::quiet_NaN();
  pcl::Indices finite;
  for (pcl::index_t i = 0; i < 400; ++i)
    if (i != 17)
      finite.push_back(i);
  Abstraction abstraction = abstractionFor(toCloud(points));
  std::vector<pcl::PointIndices> parts;
  abstraction.setNumberOfMerges(0);
  abstraction.segment(parts);
  EXPECT_EQ(parts.size(), 10u);
  expectPartition(parts, finite);
  abstraction.setNumberOfMerges(3);
  abstraction.segment(parts);
  EXPECT_EQ(parts.size(), 7u);
  expectPartition(parts, finite);
  const double height = abstraction.getMergeTree().steps()[5].height;
  abstraction.setMergeThreshold(height);
  abstraction.segment(parts);
  EXPECT_EQ(parts.size(), 4u);
  expectPartition(parts, finite);
  abstraction.setNumberOfParts(1);
  abstraction.segment(parts);
  EXPECT_EQ(parts.size(), 1u);
  expectPartition(parts, finite);
}

TEST(CIDConvexAbstraction, ReconstructsTheSamePartsThatItSegments)
{
  Abstraction abstraction = abstractionFor(toCloud(twoBoxes(400, 103)));
  abstraction.setNumberOfParts(5);
  std::vector<pcl::PointIndices> segmented;
  std::vector<ConvexPart> reconstructed;
  abstraction.segment(segmented);
  abstraction.reconstruct(reconstructed);
  ASSERT_EQ(segmented.size(), reconstructed.size());
  for (std::size_t k = 0; k < segmented.size(); ++k)
    EXPECT_EQ(segmented[k].indices, reconstructed[k].indices);
}

TEST(CIDConvexAbstraction, CutsAtTheElbowUnlessToldWhere)
{
  Abstraction abstraction = abstractionFor(toCloud(twoBoxes(600, 105)));
  std::vector<ConvexPart> parts;
  std::vector<ConvexPart> at_elbow;
  abstraction.reconstruct(parts);
  abstraction.reconstruct(abstraction.getMergeTree().cutAtElbow(), at_elbow);
  EXPECT_GE(parts.size(), 2u); // the boxes are apart
  ASSERT_EQ(parts.size(), at_elbow.size());
  for (std::size_t k = 0; k < parts.size(); ++k)
    EXPECT_EQ(parts[k].indices, at_elbow[k].indices);
}

TEST(CIDConvexAbstraction, DropsSmallPartsAndSaysHowManyPoints)
{
  Points points = twoBoxes(600, 106);
  points.push_back({50.0f, 0.0f, 0.0f}); // a speck of two
  points.push_back({50.0f, 0.001f, 0.0f});
  Abstraction abstraction = abstractionFor(toCloud(points));
  abstraction.setIsolatedNeighbors(0); // the speck shall have a seed
  abstraction.setNumberOfParts(3);
  std::vector<ConvexPart> all;
  abstraction.reconstruct(all);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(abstraction.getNumberOfDroppedPoints(), 0u);
  abstraction.setMinPoints(3);
  std::vector<ConvexPart> kept;
  abstraction.reconstruct(kept);
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(abstraction.getNumberOfDroppedPoints(), 2u);
  all.erase(
      std::remove_if(all.begin(),
                     all.end(),
                     [](const ConvexPart& part) { return part.indices.size() < 3; }),
      all.end());
  ASSERT_EQ(all.size(), 2u);
  for (std::size_t k = 0; k < kept.size(); ++k)
    EXPECT_EQ(kept[k].indices, all[k].indices);
  std::vector<pcl::PointIndices> segmented;
  abstraction.segment(segmented);
  EXPECT_EQ(segmented.size(), 2u);
  abstraction.setMinPoints(1000);
  EXPECT_THROW(abstraction.reconstruct(kept), CIDException);
  EXPECT_THROW(abstraction.setMinPoints(0), CIDException);
}

TEST(CIDConvexAbstraction, OneTreeServesEveryCut)
{
  Abstraction abstraction = abstractionFor(toCloud(twoBoxes(400, 104)));
  std::vector<ConvexPart> parts;
  abstraction.reconstruct(parts);
  const MergeTree tree = abstraction.getMergeTree();
  for (int count = 1; count <= 10; ++count) {
    abstraction.reconstruct(tree.cutAtParts(static_cast<std::size_t>(count)), parts);
    Abstraction direct = abstractionFor(toCloud(twoBoxes(400, 104)));
    direct.setNumberOfParts(count);
    std::vector<ConvexPart> expected;
    direct.reconstruct(expected);
    ASSERT_EQ(parts.size(), expected.size());
    for (std::size_t k = 0; k < parts.size(); ++k) {
      EXPECT_EQ(parts[k].indices, expected[k].indices);
      EXPECT_EQ(parts[k].hull.vertices, expected[k].hull.vertices);
    }
  }
}

TEST(CIDConvexAbstraction, StoppingAtTheCutGivesTheSameParts)
{
  Abstraction whole = abstractionFor(toCloud(twoBoxes(400, 110)));
  Abstraction stopped = abstractionFor(toCloud(twoBoxes(400, 110)));
  stopped.setStopAtCut(true);
  for (const int count : {1, 4, 10}) {
    std::vector<pcl::PointIndices> expected, parts;
    whole.setNumberOfParts(count);
    whole.segment(expected);
    stopped.setNumberOfParts(count);
    stopped.segment(parts);
    ASSERT_EQ(parts.size(), expected.size());
    for (std::size_t k = 0; k < parts.size(); ++k)
      EXPECT_EQ(parts[k].indices, expected[k].indices);
    EXPECT_EQ(stopped.getMergeTree().steps().size(), 10u - parts.size());
  }
}

TEST(CIDConvexAbstraction, TreeAgreesWithTheOracle)
{
  const Points points = twoBoxes(90, 105);
  Abstraction abstraction = abstractionFor(toCloud(points));
  abstraction.setNumberOfSeeds(6);
  abstraction.setGroupSampleSize(1 << 20);
  std::vector<pcl::PointIndices> parts;
  abstraction.segment(parts);
  GroupMergingOptions options;
  options.samples = abstraction.getNumberOfSamples();
  expectAgreesWithAlgorithm2(abstraction.getMergeTree(),
                             points,
                             points,
                             abstraction.getProposal().group,
                             options);
}

TEST(CIDConvexAbstraction, SubsampleStillPutsEveryPointIntoAPart)
{
  Abstraction abstraction = abstractionFor(toCloud(twoBoxes(2000, 106)));
  abstraction.setSubsample(200);
  abstraction.setNumberOfParts(2);
  std::vector<pcl::PointIndices> parts;
  abstraction.segment(parts);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].indices.size() + parts[1].indices.size(), 2000u);
  EXPECT_EQ(abstraction.getMergeTree().steps().back().size, 200u);
}

TEST(CIDConvexAbstraction, DegenerateCloudsGiveValidHulls)
{
  for (const NamedPoints& cloud : degenerateClouds()) {
    Abstraction abstraction = abstractionFor(toCloud(cloud.points));
    abstraction.setNumberOfParts(3);
    std::vector<ConvexPart> parts;
    abstraction.reconstruct(parts);
    EXPECT_LE(parts.size(), 3u);
    std::size_t points = 0;
    for (const ConvexPart& part : parts) {
      EXPECT_GT(part.volume, 0.0) << cloud.name;
      points += part.indices.size();
    }
    EXPECT_EQ(points, cloud.points.size()) << cloud.name;
  }
}

TEST(CIDConvexAbstraction, SameBytesForEveryNumberOfThreads)
{
  const auto cloud = toCloud(twoBoxes(500, 107));
  std::vector<ConvexPart> serial;
  for (const unsigned int threads : {1u, 2u, 3u, 8u}) {
    Abstraction abstraction = abstractionFor(cloud);
    abstraction.setNumberOfThreads(threads);
    abstraction.setNumberOfParts(4);
    std::vector<ConvexPart> parts;
    abstraction.reconstruct(parts);
    if (threads == 1)
      serial = parts;
    ASSERT_EQ(parts.size(), serial.size());
    for (std::size_t k = 0; k < parts.size(); ++k) {
      EXPECT_EQ(parts[k].indices, serial[k].indices);
      EXPECT_EQ(parts[k].hull.vertices, serial[k].hull.vertices);
      EXPECT_EQ(parts[k].hull.triangles, serial[k].hull.triangles);
    }
  }
}

TEST(CIDConvexAbstraction, ProgressRisesOverAllSteps)
{
  Abstraction abstraction = abstractionFor(toCloud(twoBoxes(3000, 108)));
  double last = 0.0;
  abstraction.setProgressCallback([&](double fraction) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1.0);
    last = fraction;
    return true;
  });
  std::vector<ConvexPart> parts;
  abstraction.reconstruct(parts);
  EXPECT_GT(last, 0.85);
  abstraction.setProgressCallback([](double fraction) { return fraction < 0.5; });
  EXPECT_THROW(abstraction.reconstruct(parts), CIDCancelled);
  EXPECT_TRUE(parts.empty());
}

TEST(CIDConvexAbstraction, HullsFollowTheirSettings)
{
  Points points = twoBoxes(600, 110);
  points[41] = Eigen::Vector3f(0.5f, 0.5f, 3.0f); // far above the first box
  Abstraction abstraction = abstractionFor(toCloud(points));
  abstraction.setNumberOfSeeds(1);
  abstraction.setMinThickness(0.02);
  abstraction.setMaxVertices(20);
  abstraction.setPadding(0.1);
  abstraction.setTrimDistance(1.9); // the boxes are 1.5 apart
  EXPECT_EQ(abstraction.getMaxVertices(), 20);
  EXPECT_EQ(abstraction.getPadding(), 0.1);
  EXPECT_EQ(abstraction.getTrimDistance(), 1.9);
  std::vector<ConvexPart> parts;
  abstraction.reconstruct(parts);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].trimmed, pcl::Indices{41});
  EXPECT_EQ(parts[0].indices.size(), 599u);
  ConvexPartOptions options;
  options.min_thickness = 0.02;
  options.max_vertices = 20;
  options.padding = 0.1;
  expectGuarantees(parts[0], points, options, "two boxes");
}

TEST(CIDConvexAbstraction, RefusesBadValues)
{
  Abstraction abstraction = abstractionFor(toCloud(randomCube(60, 109)));
  EXPECT_THROW(abstraction.setNumberOfParts(0), CIDException);
  EXPECT_THROW(abstraction.setNumberOfMerges(-1), CIDException);
  for (const double threshold :
       {-1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)})
    EXPECT_THROW(abstraction.setMergeThreshold(threshold), CIDException);
  EXPECT_THROW(abstraction.setGroupSampleSize(0), CIDException);
  for (const double thickness : {0.0, -1.0, static_cast<double>(NAN)})
    EXPECT_THROW(abstraction.setMinThickness(thickness), CIDException);
  for (const int vertices : {-1, 1, 2, 3})
    EXPECT_THROW(abstraction.setMaxVertices(vertices), CIDException);
  for (const double distance :
       {-1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    EXPECT_THROW(abstraction.setPadding(distance), CIDException);
    EXPECT_THROW(abstraction.setTrimDistance(distance), CIDException);
  }
  EXPECT_EQ(abstraction.getMinThickness(), 0.005);
  EXPECT_EQ(abstraction.getMaxVertices(), 0);
  EXPECT_EQ(abstraction.getPadding(), 0.0);
  EXPECT_EQ(abstraction.getTrimDistance(), 0.0);
  std::vector<ConvexPart> parts;
  EXPECT_THROW(abstraction.reconstruct({0, 0, 0}, parts), CIDException)
      << "nothing was computed yet";
  abstraction.reconstruct(parts);
  EXPECT_THROW(abstraction.reconstruct({0, 0, 0}, parts), CIDException);
  EXPECT_TRUE(parts.empty());
}

} // namespace
} // namespace pcl_cid::test
