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
#include "lidar_scan.h"
#include "oracle.h"

#include <pcl_cid/cid_convex_abstraction.h>
#include <pcl_cid/cid_label_propagation.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>

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

/** Two parts: those of twoBoxes(), whose points take turns. */
void
expectTheTwoBoxes(const std::vector<ConvexPart>& parts)
{
  ASSERT_EQ(parts.size(), 2u);
  for (const ConvexPart& part : parts) {
    for (const pcl::index_t index : part.indices)
      EXPECT_EQ(index % 2, part.indices.front() % 2);
    EXPECT_NEAR(part.volume, 1.0, 0.1);
    EXPECT_FALSE(part.thickened);
  }
}

TEST(CIDConvexAbstraction, MergesByHull)
{
  const Points points = twoBoxes(600, 101);
  Abstraction abstraction = abstractionFor(toCloud(points));
  abstraction.setMergingRule(MergingRule::hull);
  std::vector<ConvexPart> parts;
  EXPECT_THROW(abstraction.reconstruct(parts), CIDException); // how many?
  abstraction.setNumberOfParts(2);
  abstraction.setRobotRadius(0.05);
  abstraction.reconstruct(parts);
  expectTheTwoBoxes(parts);
  EXPECT_EQ(abstraction.getHullFitting().parts, 2u);
  EXPECT_TRUE(abstraction.getProposal().seeds.empty()); // no group was needed

  abstraction.setMergeThreshold(0.1);
  EXPECT_THROW(abstraction.reconstruct(parts), CIDException);
}

TEST(CIDConvexAbstraction, ABoundOnTheErrorAsksForMoreHulls)
{
  Abstraction abstraction = abstractionFor(toCloud(twoBoxes(600, 102)));
  abstraction.setMergingRule(MergingRule::hull);
  abstraction.setMaxError(0.6);
  std::vector<ConvexPart> few;
  abstraction.reconstruct(few);
  abstraction.setMaxError(0.2);
  std::vector<ConvexPart> many;
  abstraction.reconstruct(many);
  EXPECT_GT(many.size(), few.size());
  EXPECT_THROW(abstraction.setMaxError(0.0), CIDException);
  EXPECT_THROW(abstraction.setRobotRadius(-0.1), CIDException);
  EXPECT_THROW(abstraction.setViewpoints({Eigen::Vector3d::Constant(std::nan(""))}),
               CIDException);
  EXPECT_EQ(abstraction.getMaxError(), 0.2);
}

TEST(CIDConvexAbstraction, TwoBoxesBecomeTwoParts)
{
  const Points points = twoBoxes(600, 101);
  Abstraction abstraction = abstractionFor(toCloud(points));
  abstraction.setNumberOfParts(2);
  std::vector<ConvexPart> parts;
  abstraction.reconstruct(parts);
  expectTheTwoBoxes(parts);
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
  abstraction.setPaperSettings();
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

TEST(CIDConvexAbstraction, SimplifiesHullsWithinTheBound)
{
  const Points points = twoBoxes(600, 113);
  Abstraction abstraction = abstractionFor(toCloud(points));
  const auto verticesOf = [](const std::vector<ConvexPart>& parts) {
    std::size_t vertices = 0;
    for (const ConvexPart& part : parts)
      vertices += part.hull.vertices.size();
    return vertices;
  };
  abstraction.setNumberOfParts(2);
  abstraction.setPadding(0.02);
  std::vector<std::size_t> vertices;
  for (const MergingRule rule : {MergingRule::cid, MergingRule::hull}) {
    abstraction.setMergingRule(rule);
    if (rule == MergingRule::hull)
      abstraction.setMaxError(1.0);
    std::vector<ConvexPart> parts;
    abstraction.reconstruct(parts);
    vertices.push_back(verticesOf(parts));
    abstraction.simplify(parts);
    vertices.push_back(verticesOf(parts));
    for (const ConvexPart& part : parts)
      expectGuarantees(part, points, abstraction.getHullOptions(), "two boxes");
  }
  EXPECT_LT(vertices[1], vertices[0]);
  EXPECT_LT(vertices[3], vertices[2]);
  EXPECT_LE(vertices[3], 16u); // two boxes within a metre
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

TEST(CIDConvexAbstraction, CutCanBeSetAndReset)
{
  Abstraction abstraction = abstractionFor(toCloud(twoBoxes(400, 111)));
  std::vector<pcl::PointIndices> at_elbow, parts;
  abstraction.segment(at_elbow);
  const MergeTree tree = abstraction.getMergeTree();
  const double height = tree.steps()[4].height;
  using Set = std::function<void()>;
  const struct {
    Set set;
    MergeCut cut;
  } cuts[] = {
      {[&] { abstraction.setNumberOfParts(6); }, {MergeCut::Rule::parts, 6, 0.0}},
      {[&] { abstraction.setMergeThreshold(height); },
       {MergeCut::Rule::threshold, 0, height}},
      {[&] { abstraction.setNumberOfMerges(3); }, {MergeCut::Rule::merges, 3, 0.0}}};
  const auto partsAt = [&](const MergeCut& cut) {
    const std::vector<int> numbers = tree.cut(cut);
    return static_cast<std::size_t>(1 +
                                    *std::max_element(numbers.begin(), numbers.end()));
  };
  for (const auto& each : cuts) {
    each.set();
    EXPECT_EQ(abstraction.getMergeCut().rule, each.cut.rule);
    EXPECT_EQ(abstraction.getMergeCut().count, each.cut.count);
    EXPECT_EQ(abstraction.getMergeCut().height, each.cut.height);
    abstraction.segment(parts);
    EXPECT_EQ(parts.size(), partsAt(each.cut));
    EXPECT_NE(parts.size(), at_elbow.size()) << "or the reset below shows nothing";
    abstraction.resetMergeCut();
    EXPECT_EQ(abstraction.getMergeCut().rule, MergeCut::Rule::elbow);
    abstraction.segment(parts);
    ASSERT_EQ(parts.size(), at_elbow.size());
    for (std::size_t k = 0; k < parts.size(); ++k)
      EXPECT_EQ(parts[k].indices, at_elbow[k].indices);
  }
  for (const auto& first : cuts) // the last one that was set counts
    for (const auto& last : cuts) {
      first.set();
      last.set();
      abstraction.segment(parts);
      EXPECT_EQ(parts.size(), partsAt(last.cut));
    }
}

TEST(CIDConvexAbstraction, GivenGroupsAreThoseThatItWouldMake)
{
  const auto cloud = toCloud(twoBoxes(500, 112));
  for (const int subsample : {0, 200}) {
    SCOPED_TRACE(subsample);
    Abstraction own = abstractionFor(cloud);
    own.setSubsample(subsample);
    std::vector<ConvexPart> expected, parts;
    own.reconstruct(expected);
    Abstraction given = abstractionFor(cloud);
    given.setGrouping(own.getGrouping());
    given.reconstruct(parts);
    EXPECT_EQ(given.getGrouping(), own.getGrouping());
    ASSERT_EQ(parts.size(), expected.size());
    for (std::size_t k = 0; k < parts.size(); ++k) {
      EXPECT_EQ(parts[k].indices, expected[k].indices);
      EXPECT_EQ(parts[k].hull.vertices, expected[k].hull.vertices);
    }
    // With other settings, groups are made again.
    given.setNumberOfSamples(17);
    own.setNumberOfSamples(17);
    given.reconstruct(parts);
    own.reconstruct(expected);
    EXPECT_EQ(given.getProposal().group, own.getProposal().group);
    EXPECT_EQ(parts.size(), expected.size());
  }
}

/** Groups need not come from a proposal: what a user has corrected is merged, too. */
TEST(CIDConvexAbstraction, MergesGroupsOfGivenSeeds)
{
  CIDConvexAbstraction<pcl::PointXYZ> proposing =
      abstractionFor(toCloud(twoBoxes(400, 113)));
  std::vector<pcl::PointIndices> parts;
  proposing.segment(parts);
  auto corrected = std::make_shared<Grouping>(*proposing.getGrouping());
  corrected->removeSeeds({2, 5});
  Abstraction abstraction = abstractionFor(proposing.getInputCloud());
  abstraction.setGrouping(corrected);
  abstraction.setNumberOfMerges(0);
  abstraction.segment(parts);
  EXPECT_EQ(parts.size(), 8u);
  EXPECT_EQ(abstraction.getProposal().group, corrected->groups());
  abstraction.setGrouping(std::make_shared<Grouping>(corrected->sharedScan()));
  EXPECT_THROW(abstraction.segment(parts), CIDException) << "no seeds, no groups";
}

/** Patches are the groups of the classes, too: the same tree, and each part is made of
 *  whole patches. */
TEST(CIDConvexAbstraction, MergesPatches)
{
  const auto cloud = toCloud(twoBoxes(600, 101));
  Abstraction abstraction = abstractionFor(cloud);
  abstraction.setGroupRule(GroupRule::patches);
  abstraction.setNumberOfParts(2);
  std::vector<ConvexPart> parts;
  abstraction.reconstruct(parts);
  expectTheTwoBoxes(parts);
  const SmoothPatches::ConstPtr patches = abstraction.getPatches();
  ASSERT_TRUE(patches);
  EXPECT_EQ(patches->numberOfPatches(), 10u);
  EXPECT_TRUE(abstraction.getProposal().seeds.empty());
  MergingSettings settings;
  settings.group_samples = 8;
  const MergeTree expected = mergeGroups(*patches, 30, settings);
  EXPECT_EQ(abstraction.getMergeTree().groupSizes(), expected.groupSizes());
  EXPECT_EQ(abstraction.getMergeTree().cutAtParts(4), expected.cutAtParts(4));
  std::vector<pcl::PointIndices> segments;
  abstraction.segment(segments);
  pcl::Indices all(600);
  std::iota(all.begin(), all.end(), 0);
  expectPartition(segments, all);
  EXPECT_EQ(abstraction.getPatches(), patches) << "found twice";
  abstraction.reconstruct(expected.cutAtParts(5), parts);
  EXPECT_EQ(parts.size(), 5u);
}

TEST(CIDConvexAbstraction, PatchesFollowTheirSettings)
{
  const auto cloud = toCloud(twoBoxes(600, 101));
  Abstraction abstraction = abstractionFor(cloud);
  abstraction.setGroupRule(GroupRule::patches);
  std::vector<pcl::PointIndices> parts;
  abstraction.segment(parts);
  const double height = abstraction.getMergeTree().steps().back().height;
  abstraction.setNumberOfSamples(3);
  abstraction.segment(parts);
  EXPECT_NE(abstraction.getMergeTree().steps().back().height, height);
  abstraction.setNumberOfSeeds(5);
  abstraction.segment(parts);
  EXPECT_EQ(abstraction.getMergeTree().numberOfGroups(), 5u);
  abstraction.setGroupRule(GroupRule::cid);
  abstraction.segment(parts);
  EXPECT_FALSE(abstraction.getPatches());
  EXPECT_EQ(abstraction.getProposal().seeds.size(), 5u);
  abstraction.setGroupRule(GroupRule::patches);
  abstraction.setPaperSettings();
  EXPECT_EQ(abstraction.getGroupRule(), GroupRule::cid);
}

/** Early or late, merging stops at the same cut. */
TEST(CIDConvexAbstraction, PatchesStopAtTheCut)
{
  // There are fewer patches than seeds are asked for.
  Abstraction whole = abstractionFor(toCloud(randomCube(60, 110)));
  whole.setGroupRule(GroupRule::patches);
  whole.setNumberOfSeeds(100);
  Abstraction stopped = whole;
  stopped.setStopAtCut(true);
  std::vector<pcl::PointIndices> parts;
  std::vector<pcl::PointIndices> parts_at_stop;
  whole.segment(parts);
  const auto patches = static_cast<int>(whole.getPatches()->numberOfPatches());
  ASSERT_GT(patches, 2);
  ASSERT_LT(patches, 100);
  for (int merges = 1; merges < patches; ++merges) {
    whole.setNumberOfMerges(merges);
    stopped.setNumberOfMerges(merges);
    whole.segment(parts);
    stopped.segment(parts_at_stop);
    EXPECT_EQ(stopped.getMergeTree().steps().size(), static_cast<std::size_t>(merges));
    ASSERT_EQ(parts.size(), parts_at_stop.size());
    for (std::size_t k = 0; k < parts.size(); ++k)
      EXPECT_EQ(parts[k].indices, parts_at_stop[k].indices);
  }
}

/** Settings of seeds do not matter, nor what the object has done before. */
TEST(CIDConvexAbstraction, PatchesAreThoseOfAFreshObject)
{
  const auto cloud = toCloud(twoBoxes(600, 101));
  const auto another = toCloud(twoBoxes(300, 5));
  Abstraction fresh = abstractionFor(another);
  fresh.setSubsample(150);
  fresh.setGroupRule(GroupRule::patches);
  std::vector<pcl::PointIndices> expected;
  fresh.segment(expected);

  CIDLabelPropagation<pcl::PointXYZ> propagation;
  propagation.setInputCloud(cloud);
  propagation.setSubsample(150);
  propagation.setSeeds({5, 590}, {1, 2});
  std::vector<std::uint32_t> labels;
  propagation.segment(labels);
  Abstraction used = abstractionFor(cloud);
  used.setGrouping(propagation.getGrouping());
  const int samples = fresh.getNumberOfSamples();
  used.setNumberOfSamples(samples + 1); // the groups do not count any more
  used.setGroupRule(GroupRule::patches);
  std::vector<pcl::PointIndices> parts;
  used.segment(parts);
  used.setNumberOfSamples(samples);
  used.setInputCloud(another);
  used.setCoverage(0.5F);
  used.setSeedingRule(SeedingRule::soft);
  used.segment(parts);
  ASSERT_EQ(parts.size(), expected.size());
  for (std::size_t k = 0; k < parts.size(); ++k)
    EXPECT_EQ(parts[k].indices, expected[k].indices);
}

TEST(CIDConvexAbstraction, PatchesOfAnotherInputOrBesideGivenGroupsAreRefused)
{
  const auto cloud = toCloud(twoBoxes(600, 101));
  Abstraction abstraction = abstractionFor(cloud);
  abstraction.setGroupRule(GroupRule::patches);
  std::vector<ConvexPart> parts;
  abstraction.reconstruct(parts);
  const std::vector<int> cut = abstraction.getMergeTree().cutAtParts(2);
  abstraction.setInputCloud(toCloud(twoBoxes(300, 5)));
  EXPECT_THROW(abstraction.reconstruct(cut, parts), CIDException);
  EXPECT_TRUE(parts.empty());
  abstraction.reconstruct(parts);
  EXPECT_FALSE(parts.empty());
  Abstraction of_seeds = abstractionFor(cloud);
  of_seeds.reconstruct(parts);
  abstraction.setInputCloud(cloud);
  abstraction.setGrouping(of_seeds.getGrouping());
  EXPECT_THROW(abstraction.reconstruct(parts), CIDException);
  abstraction.setGroupRule(GroupRule::cid);
  abstraction.reconstruct(parts);
  EXPECT_FALSE(parts.empty());
}

TEST(CIDConvexAbstraction, CutOfAnotherInputIsRefused)
{
  Abstraction abstraction = abstractionFor(toCloud(twoBoxes(400, 114)));
  std::vector<ConvexPart> parts;
  abstraction.reconstruct(parts);
  const std::vector<int> cut = abstraction.getMergeTree().cutAtParts(3);
  abstraction.reconstruct(cut, parts);
  EXPECT_EQ(parts.size(), 3u);
  abstraction.setInputCloud(abstraction.getInputCloud());
  EXPECT_THROW(abstraction.reconstruct(cut, parts), CIDException);
  EXPECT_TRUE(parts.empty());
  abstraction.reconstruct(parts);
  abstraction.setProgressCallback([](double) { return false; });
  abstraction.setNumberOfSeeds(11);
  EXPECT_THROW(abstraction.reconstruct(parts), CIDCancelled);
  abstraction.setProgressCallback({});
  EXPECT_THROW(abstraction.reconstruct(cut, parts), CIDException)
      << "the last verb has no result";
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

/** The share of some points that the part with most of them has. */
float
shareInOnePart(const pcl::Indices& points, const std::vector<pcl::PointIndices>& parts)
{
  std::size_t most = 0;
  for (const pcl::PointIndices& part : parts) {
    pcl::Indices common;
    std::set_intersection(points.begin(),
                          points.end(),
                          part.indices.begin(),
                          part.indices.end(),
                          std::back_inserter(common));
    most = std::max(most, common.size());
  }
  return static_cast<float>(most) / static_cast<float>(points.size());
}

/// A floor around a scanner is one part, at UTM-like offsets, too; without the filling
/// it is a ring.
TEST(CIDConvexAbstraction, TheFloorAroundAScannerIsOnePart)
{
  LidarOptions options;
  options.blind = 55.0f;
  const Eigen::Vector3f offset(4096.0f, -2048.0f, 512.0f);
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud = toCloud(lidarScan(options));
  pcl::Indices floor;
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    if ((*cloud)[i].z < -1.25f && (*cloud)[i].getVector3fMap().head<2>().norm() < 2.4f)
      floor.push_back(static_cast<pcl::index_t>(i));
    (*cloud)[i].getVector3fMap() += offset;
  }
  cloud->sensor_origin_.head<3>() = offset;
  CIDConvexAbstraction<pcl::PointXYZ> abstraction;
  abstraction.setInputCloud(cloud);
  abstraction.setDensityWeight(DensityWeight::off); // heights are metres
  abstraction.setMergeThreshold(0.4);
  std::vector<pcl::PointIndices> parts;
  abstraction.segment(parts);
  ASSERT_TRUE(abstraction.getBlindSpot());
  EXPECT_LE((abstraction.getBlindSpot()->center - offset.cast<double>() -
             Eigen::Vector3d(0, 0, -1.3))
                .norm(),
            0.02);
  EXPECT_GE(shareInOnePart(floor, parts), 0.9f);

  abstraction.setFillBlindSpot(false);
  abstraction.segment(parts);
  EXPECT_FALSE(abstraction.getBlindSpot());
  EXPECT_LE(shareInOnePart(floor, parts), 0.7f);

  cloud->sensor_orientation_.coeffs().setConstant(
      std::numeric_limits<float>::quiet_NaN());
  abstraction.setFillBlindSpot(true);
  abstraction.segment(parts);
  EXPECT_FALSE(abstraction.getBlindSpot()) << "nobody knows where down is";
}

/// The lidar scan of PCL's data stands on its floor: floor, ceiling and walls are parts
/// of their own among 30, with the defaults.
TEST(CIDConvexAbstraction, TheSidesOfALidarScanArePartsOfTheirOwn)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud = loadSharedScan("room_scan1.pcd");
  if (!cloud)
    GTEST_SKIP() << "../shared/data/room_scan1.pcd is absent";
  struct Side {
    const char* name;
    Eigen::Vector4f plane; // n x + d = 0
  };
  const Side sides[] = {{"ceiling", {-0.01f, 0.01f, 1.0f, -1.66f}},
                        {"floor", {-0.02f, 0.0f, 1.0f, 1.27f}},
                        {"wall y = -1.46", {0.0f, 1.0f, 0.02f, 1.46f}},
                        {"wall y = 3.07", {0.01f, 1.0f, -0.03f, -3.07f}},
                        {"wall x = -2.6", {1.0f, -0.026f, 0.024f, 2.608f}}};
  CIDConvexAbstraction<pcl::PointXYZ> abstraction;
  abstraction.setInputCloud(cloud);
  abstraction.setNumberOfParts(30);
  for (const std::uint64_t start : {0u, 1u}) {
    abstraction.setRandomSeed(start);
    std::vector<pcl::PointIndices> parts;
    abstraction.segment(parts);
    std::size_t tiny = 0;
    for (const pcl::PointIndices& part : parts)
      tiny += part.indices.size() < 50;
    EXPECT_LE(tiny, 5u);
    for (const Side& side : sides) {
      pcl::Indices on;
      for (std::size_t i = 0; i < cloud->size(); ++i) {
        const Eigen::Vector3f p = (*cloud)[i].getVector3fMap();
        if (std::abs(side.plane.head<3>().dot(p) + side.plane[3]) < 0.03f)
          on.push_back(static_cast<pcl::index_t>(i));
      }
      EXPECT_GE(shareInOnePart(on, parts), 0.8f) << side.name << ", start " << start;
    }
  }
}

} // namespace
} // namespace pcl_cid::test
