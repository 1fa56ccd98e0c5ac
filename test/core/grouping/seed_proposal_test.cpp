/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithm 1 against the oracle, and what a traversal must always satisfy.
 */

#include "clouds.h"
#include "oracle.h"

#include <pcl_cid/core/concavity.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

SeedProposalOptions
optionsFor(std::size_t seeds, int samples = 40)
{
  SeedProposalOptions options;
  options.seeds = seeds;
  options.samples = samples;
  return options;
}

class TraversalOfClouds : public testing::TestWithParam<NamedPoints> {
protected:
  const Points& points_ = GetParam().points;
  const DistanceField field_{points_};
};

TEST_P(TraversalOfClouds, AgreesWithTheOracle)
{
  const SeedProposal proposal = proposeSeeds(field_, points_, 0, optionsFor(9));
  expectAgreesWithAlgorithm1(proposal, points_, points_, optionsFor(9));
}

TEST_P(TraversalOfClouds, Invariants)
{
  expectTraversalInvariants(proposeSeeds(field_, points_, 0, optionsFor(12)),
                            points_.size());
}

TEST_P(TraversalOfClouds, IsNested)
{
  const SeedProposal twelve = proposeSeeds(field_, points_, 0, optionsFor(12));
  const SeedProposal five = proposeSeeds(field_, points_, 0, optionsFor(5));
  ASSERT_LE(five.seeds.size(), twelve.seeds.size());
  for (std::size_t k = 0; k < five.seeds.size(); ++k) {
    EXPECT_EQ(five.seeds[k], twelve.seeds[k]);
    EXPECT_EQ(five.coverage[k], twelve.coverage[k]);
  }
}

TEST_P(TraversalOfClouds, ExtensionEqualsOneRun)
{
  SeedProposal extended = proposeSeeds(field_, points_, 0, optionsFor(4));
  extendProposal(field_, points_, optionsFor(11), extended);
  expectSameProposal(extended, proposeSeeds(field_, points_, 0, optionsFor(11)));
}

TEST_P(TraversalOfClouds, GroupingByTheSameSeedsGivesTheSameGroups)
{
  const SeedProposal proposed = proposeSeeds(field_, points_, 0, optionsFor(8));
  expectSameProposal(groupBySeeds(field_, points_, proposed.seeds, optionsFor(9)),
                     proposed);
}

TEST_P(TraversalOfClouds, SameBytesForEveryNumberOfThreads)
{
  SeedProposalOptions options = optionsFor(8);
  options.execution.threads = 1;
  const SeedProposal serial = proposeSeeds(field_, points_, 0, options);
  for (const unsigned int threads : {2u, 3u, 8u}) {
    options.execution.threads = threads;
    expectSameProposal(proposeSeeds(field_, points_, 0, options), serial);
  }
}

TEST_P(TraversalOfClouds, CoverageStopsAsSoonAsItHolds)
{
  const SeedProposal all = proposeSeeds(field_, points_, 0, optionsFor(15));
  for (const float coverage : all.coverage) {
    SeedProposalOptions options = optionsFor(15);
    options.coverage = coverage;
    const SeedProposal stopped = proposeSeeds(field_, points_, 0, options);
    EXPECT_LE(stopped.coverage.back(), coverage);
    if (stopped.coverage.size() > 1) {
      EXPECT_GT(stopped.coverage[stopped.coverage.size() - 2], coverage);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Clouds,
                         TraversalOfClouds,
                         testing::ValuesIn(allClouds()),
                         [](const auto& info) { return info.param.name; });

TEST(SeedProposal, AgreesWithTheOracleOnCropsOfRealScans)
{
  for (const char* name : {"office1.pcd", "room_scan1.pcd", "mosd_learn41.pcd"}) {
    const auto scan = loadSharedScan(name);
    if (!scan)
      GTEST_SKIP() << "../shared/data/" << name << " is absent";
    const Points points = crop(*scan, 500, 37);
    const SeedProposal proposal =
        proposeSeeds(DistanceField(points), points, 0, optionsFor(8, 50));
    expectAgreesWithAlgorithm1(proposal, points, points, optionsFor(1, 50));
    expectTraversalInvariants(proposal, points.size());
  }
}

TEST(SeedProposal, EqualsAllPairsToTheBitOnLargerClouds)
{
  std::vector<NamedPoints> clouds = {{"two_boxes", twoBoxes(4000, 38)},
                                     {"cube", randomCube(1500, 39)}};
  for (const char* name :
       {"office1.pcd", "room_scan1.pcd", "milk_cartoon_all_small_clorox.pcd"})
    if (const auto scan = loadSharedScan(name))
      clouds.push_back({name, crop(*scan, 4000, 11)});
  for (const NamedPoints& cloud : clouds) {
    const DistanceField field(cloud.points);
    SeedProposalOptions options = optionsFor(30, 100);
    const SeedProposal expected = proposeByAllPairs(field, cloud.points, 0, options);
    expectSameProposal(proposeSeeds(field, cloud.points, 0, options), expected);
    options.keep_cid = false;
    const SeedProposal groups_only = proposeSeeds(field, cloud.points, 0, options);
    EXPECT_EQ(groups_only.group, expected.group) << cloud.name;
    EXPECT_EQ(groups_only.seeds, expected.seeds) << cloud.name;
    EXPECT_TRUE(groups_only.cid.empty());
  }
}

TEST(SeedProposal, EqualsAllPairsToTheBitWithManySeeds)
{
  for (const NamedPoints& cloud : {NamedPoints{"two_boxes", twoBoxes(1500, 41)},
                                   NamedPoints{"cube", randomCube(1000, 42)}}) {
    const DistanceField field(cloud.points);
    SeedProposalOptions options = optionsFor(200, 30);
    const SeedProposal expected = proposeByAllPairs(field, cloud.points, 0, options);
    expectSameProposal(proposeSeeds(field, cloud.points, 0, options), expected);
    options.keep_cid = false;
    EXPECT_EQ(proposeSeeds(field, cloud.points, 0, options).group, expected.group)
        << cloud.name;
  }
}

TEST(SeedProposal, CorrectiveSeedsJoinAsIfTheyHadBeenThere)
{
  const Points points = twoBoxes(800, 40);
  const DistanceField field(points);
  SeedProposal corrected = proposeSeeds(field, points, 0, optionsFor(8));
  pcl::Indices all = corrected.seeds;
  all.insert(all.end(), {17, 402, 17});
  addSeeds(field, points, {17, 402, 17}, optionsFor(9), corrected);
  expectSameProposal(corrected, groupBySeeds(field, points, all, optionsFor(9)));
}

TEST(SeedProposal, DuplicatesNeverBecomeSeeds)
{
  Points points = randomCube(5, 31);
  for (int copies = 0; copies < 3; ++copies)
    points.insert(points.end(), points.begin(), points.begin() + 5);
  const SeedProposal proposal =
      proposeSeeds(DistanceField(points), points, 2, optionsFor(20));
  EXPECT_EQ(proposal.seeds.size(), 5u);
  EXPECT_EQ(proposal.coverage.back(), 0.0f);
  for (const pcl::index_t seed : proposal.seeds)
    EXPECT_LT(seed, 5) << "of equal points the one of lowest index is farthest";
}

TEST(SeedProposal, TiesGoToTheLowestIndexAndTheEarlierSeed)
{
  // Four corners of a square: from corner 0 both neighbors are equally far in CID.
  const Points square = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const SeedProposal proposal =
      proposeSeeds(DistanceField(square), square, 0, optionsFor(2, 101));
  EXPECT_EQ(proposal.seeds, (pcl::Indices{0, 3}));
  EXPECT_EQ(proposal.group, (std::vector<pcl::index_t>{0, 0, 0, 1}));
}

TEST(SeedProposal, PointsOffTheSurfaceBecomeSeedsOnlyWhenThatHelps)
{
  // Points that hover over the surface have a CID to themselves; none may be picked
  // twice.
  const Points surface = twoBoxes(300, 32);
  Points points = surface;
  for (Eigen::Vector3f& p : points)
    p.z() += 0.2f;
  const SeedProposal proposal =
      proposeSeeds(DistanceField(surface), points, 0, optionsFor(points.size(), 10));
  expectAgreesWithAlgorithm1(
      proposeSeeds(DistanceField(surface), points, 0, optionsFor(8, 10)),
      surface,
      points,
      optionsFor(8, 10));
  const std::set<pcl::index_t> distinct(proposal.seeds.begin(), proposal.seeds.end());
  EXPECT_EQ(distinct.size(), proposal.seeds.size());
  EXPECT_GT(proposal.coverage.back(), 0.0f);
}

TEST(SeedProposal, OnlyCandidatesBecomeSeeds)
{
  const Points points = twoBoxes(200, 33);
  SeedProposalOptions options = optionsFor(10);
  for (pcl::index_t i = 0; i < 200; i += 3)
    options.candidates.push_back(i);
  const SeedProposal proposal = proposeSeeds(DistanceField(points), points, 0, options);
  EXPECT_EQ(proposal.seeds.size(), 10u);
  for (const pcl::index_t seed : proposal.seeds)
    EXPECT_EQ(seed % 3, 0);
}

TEST(SeedProposal, GivenSeedsMayRepeatAndTheEarlierKeepsThePoints)
{
  const Points points = randomCube(100, 34);
  const SeedProposal proposal =
      groupBySeeds(DistanceField(points), points, {7, 7, 30}, optionsFor(9));
  EXPECT_EQ(proposal.seeds, (pcl::Indices{7, 7, 30}));
  for (const pcl::index_t group : proposal.group)
    EXPECT_NE(group, 1);
}

TEST(SeedProposal, ProgressRisesAndCancelLeavesNothingBehind)
{
  const Points points = twoBoxes(3000, 35);
  const DistanceField field(points);
  SeedProposalOptions options = optionsFor(30);
  double last = 0.0;
  options.execution.progress = [&](double fraction) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1.0);
    last = fraction;
    return true;
  };
  SeedProposal proposal = proposeSeeds(field, points, 0, options);
  EXPECT_GT(last, 0.0);
  options.execution.progress = [](double) { return false; };
  EXPECT_THROW(proposeSeeds(field, points, 0, options), CIDCancelled);
  const SeedProposal before = proposal;
  options.seeds = 40;
  EXPECT_THROW(extendProposal(field, points, options, proposal), CIDCancelled);
  expectSameProposal(before, proposal);
}

TEST(SeedProposal, CallbackExceptionReachesTheCaller)
{
  const Points points = randomCube(500, 36);
  SeedProposalOptions options = optionsFor(5);
  options.execution.progress = [](double) -> bool { throw std::runtime_error("mine"); };
  EXPECT_THROW(proposeSeeds(DistanceField(points), points, 0, options),
               std::runtime_error);
}

/** Points of a block in the places that they may be said to have. */
TEST(SeedProposal, SameWhereverTheyAreKnownToLie)
{
  for (const NamedPoints& cloud : allClouds()) {
    SCOPED_TRACE(cloud.name);
    const DistanceField field(cloud.points);
    SeedProposalOptions options = optionsFor(12);
    options.place = WorkingPoints::Place::are_surface;
    const SeedProposal expected = proposeSeeds(field, cloud.points, 0, options);
    options.place = WorkingPoints::Place::anywhere;
    expectSameProposal(proposeSeeds(field, cloud.points, 0, options), expected);
    options.place = WorkingPoints::Place::on_surface;
    expectSameProposal(proposeSeeds(field, cloud.points, 0, options), expected);
    Points larger = cloud.points; // a surface with points that are not grouped
    larger.push_back(2.0f * cloud.points.back());
    const DistanceField larger_field(larger);
    const SeedProposal on = proposeSeeds(larger_field, cloud.points, 0, options);
    options.place = WorkingPoints::Place::anywhere;
    expectSameProposal(on, proposeSeeds(larger_field, cloud.points, 0, options));
  }
}

} // namespace
} // namespace pcl_cid::test
