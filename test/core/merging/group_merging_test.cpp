/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithm 2 against the oracle, and the cuts of its tree.
 */

#include "base/random.h"
#include "clouds.h"
#include "even_sampler.h"
#include "oracle.h"
#include "prepared_points.h"
#include "room_scene.h"

#include <pcl_cid/core/concavity.h>
#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

constexpr int samples = 20;

SeedProposal
groupsOf(const Points& points, std::size_t groups)
{
  SeedProposalOptions options;
  options.seeds = groups;
  options.samples = samples;
  return proposeSeeds(DistanceField(points), points, 0, options);
}

MergeTree
treeOf(const Points& points, const SeedProposal& proposal, GroupMergingOptions options)
{
  options.samples = samples;
  return mergeGroups(
      DistanceField(points), points, proposal.group, proposal.seeds.size(), options);
}

GroupMergingOptions
exact()
{
  GroupMergingOptions options;
  options.group_samples = 1u << 20; // all pairs of all groups
  options.samples = samples;
  return options;
}

int
partsOf(const std::vector<int>& cut)
{
  return cut.empty() ? 0 : 1 + *std::max_element(cut.begin(), cut.end());
}

void
expectSame(const MergeTree& a, const MergeTree& b)
{
  ASSERT_EQ(a.steps().size(), b.steps().size());
  EXPECT_EQ(a.groupSizes(), b.groupSizes());
  for (std::size_t n = 0; n < a.steps().size(); ++n) {
    EXPECT_EQ(a.steps()[n].first, b.steps()[n].first);
    EXPECT_EQ(a.steps()[n].second, b.steps()[n].second);
    EXPECT_EQ(a.steps()[n].height, b.steps()[n].height);
    EXPECT_EQ(a.steps()[n].size, b.steps()[n].size);
  }
}

class MergingOfClouds : public testing::TestWithParam<NamedPoints> {
protected:
  const Points points_{
      GetParam().points.begin(),
      GetParam().points.begin() +
          std::min<std::ptrdiff_t>(
              70, static_cast<std::ptrdiff_t>(GetParam().points.size()))};
  const SeedProposal proposal_ = groupsOf(points_, 7);
};

TEST_P(MergingOfClouds, AgreesWithTheOracleThatComputesEveryGroupCIDAnew)
{
  expectAgreesWithAlgorithm2(
      treeOf(points_, proposal_, exact()), points_, points_, proposal_.group, exact());
}

TEST_P(MergingOfClouds, HeightsNeverFallAndSizesAddUp)
{
  for (const GroupMergingOptions& options : {exact(), GroupMergingOptions()}) {
    const MergeTree tree = treeOf(points_, proposal_, options);
    const double rounding = agreementTolerance(points_);
    for (std::size_t n = 1; n < tree.steps().size(); ++n)
      EXPECT_GE(tree.steps()[n].height, tree.steps()[n - 1].height - rounding);
    if (!tree.steps().empty()) {
      EXPECT_EQ(tree.steps().back().size, points_.size());
    }
  }
}

TEST_P(MergingOfClouds, SameBytesForEveryNumberOfThreads)
{
  GroupMergingOptions options;
  options.execution.threads = 1;
  const MergeTree serial = treeOf(points_, proposal_, options);
  for (const unsigned int threads : {2u, 3u, 8u}) {
    options.execution.threads = threads;
    expectSame(treeOf(points_, proposal_, options), serial);
  }
}

TEST_P(MergingOfClouds, CutsAgreeWithEachOther)
{
  const MergeTree tree = treeOf(points_, proposal_, exact());
  const int groups = static_cast<int>(tree.numberOfGroups());
  for (int merges = 0; merges < groups; ++merges) {
    const std::vector<int> cut = tree.cutAfterMerges(static_cast<std::size_t>(merges));
    EXPECT_EQ(partsOf(cut), groups - merges);
    EXPECT_EQ(cut, tree.cutAtParts(static_cast<std::size_t>(groups - merges)));
    EXPECT_EQ(cut, tree.cut({MergeCut::Rule::merges, std::size_t(merges), 0.0}));
    int seen = -1; // numbered by the lowest group
    for (const int part : cut) {
      EXPECT_LE(part, seen + 1);
      seen = std::max(seen, part);
    }
  }
  for (const MergeStep& step : tree.steps()) {
    const std::vector<int> cut = tree.cutAtHeight(step.height);
    EXPECT_EQ(cut[static_cast<std::size_t>(step.first)],
              cut[static_cast<std::size_t>(step.second)]);
  }
  EXPECT_EQ(tree.cutAfterMerges(1000), tree.cutAtParts(1));
  EXPECT_EQ(partsOf(tree.cutAtParts(1000)), groups);
  EXPECT_EQ(tree.cutAtHeight(1e9), tree.cutAtParts(1));
}

/** Average linkage on a full matrix, without bounds: Algorithm 2 with Lance-Williams.
 */
std::vector<MergeStep>
mergeByFullMatrix(const DistanceField& field,
                  const Points& points,
                  const SeedProposal& proposal)
{
  const std::size_t groups = proposal.seeds.size();
  std::vector<Points> members(groups);
  for (std::size_t i = 0; i < points.size(); ++i)
    members[static_cast<std::size_t>(proposal.group[i])].push_back(points[i]);
  std::vector<std::vector<double>> matrix(groups,
                                          std::vector<double>(groups, INFINITY));
  for (std::size_t i = 0; i < groups; ++i)
    for (std::size_t j = i + 1; j < groups; ++j)
      matrix[i][j] = groupCID(field, members[i], members[j], samples);
  std::vector<std::size_t> sizes;
  for (const Points& of_group : members)
    sizes.push_back(of_group.size());
  std::vector<MergeStep> steps;
  while (steps.size() + 1 < groups) {
    std::size_t i = 0, j = 1;
    for (std::size_t k = 0; k < groups; ++k)
      for (std::size_t l = k + 1; l < groups; ++l)
        if (matrix[k][l] < matrix[i][j]) {
          i = k;
          j = l;
        }
    const double height = matrix[i][j];
    const auto w = static_cast<double>(sizes[i]);
    const auto v = static_cast<double>(sizes[j]);
    for (std::size_t k = 0; k < groups; ++k) {
      double& to_i = matrix[std::min(i, k)][std::max(i, k)];
      double& to_j = matrix[std::min(j, k)][std::max(j, k)];
      if (k != i && k != j)
        to_i = (w * to_i + v * to_j) / (w + v);
      to_j = INFINITY;
    }
    sizes[i] += sizes[j];
    steps.push_back({static_cast<int>(i), static_cast<int>(j), height, sizes[i]});
  }
  return steps;
}

TEST_P(MergingOfClouds, EqualsTheFullMatrixToTheBit)
{
  const MergeTree tree = treeOf(points_, proposal_, exact());
  const std::vector<MergeStep> expected =
      mergeByFullMatrix(DistanceField(points_), points_, proposal_);
  expectSame(tree, MergeTree(tree.groupSizes(), expected));
}

TEST_P(MergingOfClouds, TreeThatStopsEarlyIsTheBeginningOfTheWhole)
{
  const MergeTree whole = treeOf(points_, proposal_, GroupMergingOptions());
  const std::size_t groups = whole.numberOfGroups();
  const auto expectBeginning = [&](const MergeCut& cut) {
    GroupMergingOptions options;
    options.stopAt(cut, groups);
    const MergeTree part = treeOf(points_, proposal_, options);
    EXPECT_EQ(part.cut(cut), whole.cut(cut));
    std::vector<MergeStep> beginning = whole.steps();
    beginning.resize(part.steps().size());
    if (part.steps().size() + 1 < groups) {
      EXPECT_THROW(part.cutAtParts(1), CIDException);
      EXPECT_THROW(part.cutAfterMerges(groups), CIDException);
      EXPECT_THROW(part.cutAtHeight(1e9), CIDException);
    }
    expectSame(part, MergeTree(whole.groupSizes(), beginning));
  };
  for (std::size_t count = 1; count <= groups; ++count) {
    expectBeginning({MergeCut::Rule::parts, count, 0.0});
    expectBeginning({MergeCut::Rule::merges, count - 1, 0.0});
  }
  for (const MergeStep& step : whole.steps())
    expectBeginning({MergeCut::Rule::threshold, 0, step.height});
}

INSTANTIATE_TEST_SUITE_P(Clouds,
                         MergingOfClouds,
                         testing::ValuesIn(allClouds()),
                         [](const auto& info) { return info.param.name; });

TEST(GroupMerging, AgreesWithTheOracleOnCropsOfRealScans)
{
  for (const char* name : {"office1.pcd", "milk_cartoon_all_small_clorox.pcd"}) {
    const auto scan = loadSharedScan(name);
    if (!scan)
      GTEST_SKIP() << "../shared/data/" << name << " is absent";
    const Points points = crop(*scan, 100, 211);
    const SeedProposal proposal = groupsOf(points, 8);
    expectAgreesWithAlgorithm2(
        treeOf(points, proposal, exact()), points, points, proposal.group, exact());
  }
}

/** A tree that joins group after group to the first one, at these heights. */
MergeTree
chainOf(const std::vector<double>& heights)
{
  std::vector<MergeStep> steps;
  for (std::size_t n = 0; n < heights.size(); ++n)
    steps.push_back({0, static_cast<int>(n) + 1, heights[n], n + 2});
  return MergeTree(std::vector<std::size_t>(heights.size() + 1, 1), steps);
}

TEST(GroupMerging, ElbowIsAfterTheCheapMerges)
{
  const std::vector<double> heights = {1.0, 1.1, 1.1, 1.2, 1.3, 4.0, 7.0, 9.0};
  EXPECT_EQ(partsOf(chainOf(heights).cutAtElbow()), 4); // five merges of 9 groups
  EXPECT_EQ(partsOf(chainOf(heights).cut(MergeCut())), 4);
  std::vector<double> in_millimetres = heights;
  for (double& height : in_millimetres)
    height *= 1000.0;
  EXPECT_EQ(partsOf(chainOf(in_millimetres).cutAtElbow()), 4);
}

TEST(GroupMerging, ElbowOfFewOrEqualMerges)
{
  EXPECT_EQ(partsOf(chainOf({}).cutAtElbow()), 1);
  EXPECT_EQ(partsOf(chainOf({0.1}).cutAtElbow()), 2);
  EXPECT_EQ(partsOf(chainOf({0.1, 5.0}).cutAtElbow()), 3);
  EXPECT_EQ(partsOf(chainOf({0.1, 0.1, 0.1, 0.1}).cutAtElbow()), 1);
  EXPECT_TRUE(MergeTree().cutAtElbow().empty());
  const std::vector<MergeStep> first_of_three = {{0, 1, 0.1, 2}};
  const MergeTree stopped({1, 1, 1, 1}, first_of_three, 0.2);
  EXPECT_THROW(stopped.cutAtElbow(), CIDException);
}

TEST(GroupMerging, TwoObjectsAreTheLastToMerge)
{
  const Points points = twoBoxes(400, 41);
  const SeedProposal proposal = groupsOf(points, 14);
  const MergeTree tree = treeOf(points, proposal, GroupMergingOptions());
  const std::vector<int> cut = tree.cutAtParts(2);
  std::set<int> parts_of_box[2];
  for (std::size_t i = 0; i < points.size(); ++i)
    parts_of_box[i % 2].insert(cut[static_cast<std::size_t>(proposal.group[i])]);
  EXPECT_EQ(parts_of_box[0].size(), 1u);
  EXPECT_EQ(parts_of_box[1].size(), 1u);
  EXPECT_NE(parts_of_box[0], parts_of_box[1]);
}

TEST(GroupMerging, EqualHeightsMergeTheLowestPairFirst)
{
  // Four single points at the corners of a square: all sides are equal.
  const Points square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  GroupMergingOptions options;
  options.samples = 101;
  const MergeTree tree =
      mergeGroups(DistanceField(square), square, {0, 1, 2, 3}, 4, options);
  EXPECT_EQ(tree.steps()[0].first, 0);
  EXPECT_EQ(tree.steps()[0].second, 1);
  EXPECT_EQ(tree.steps()[1].first, 2);
  EXPECT_EQ(tree.steps()[1].second, 3);
}

TEST(GroupMerging, UngroupedPointsStayOut)
{
  const Points points = randomCube(30, 42);
  std::vector<pcl::index_t> group(30, -1);
  for (std::size_t i = 0; i < 20; ++i)
    group[i] = static_cast<pcl::index_t>(i % 2);
  const MergeTree tree =
      mergeGroups(DistanceField(points), points, group, 2, GroupMergingOptions());
  EXPECT_EQ(tree.groupSizes(), (std::vector<std::size_t>{10, 10}));
  EXPECT_EQ(tree.steps().back().size, 20u);
}

TEST(GroupMerging, SampledGroupCIDIsNearTheExactOne)
{
  const Points points = twoBoxes(600, 43);
  const SeedProposal proposal = groupsOf(points, 6);
  const MergeTree sampled = treeOf(points, proposal, GroupMergingOptions());
  const MergeTree whole = treeOf(points, proposal, exact());
  EXPECT_NEAR(sampled.steps().back().height,
              whole.steps().back().height,
              0.1 * whole.steps().back().height);
}

/** CID_g of two of the groups, as mergeGroups() estimates it. */
double
estimateOf(const DistanceField& field,
           const Points& points,
           const SeedProposal& proposal,
           const std::array<pcl::index_t, 2>& pair,
           const GroupMergingOptions& options)
{
  std::vector<pcl::index_t> group(points.size(), -1);
  for (std::size_t i = 0; i < group.size(); ++i)
    for (pcl::index_t side : {0, 1})
      if (proposal.group[i] == pair[static_cast<std::size_t>(side)])
        group[i] = side;
  return mergeGroups(field, points, group, 2, options).steps().front().height;
}

/** The same from all pairs of some points of each, as the paper does it. */
double
estimateOfAllPairs(const DistanceField& field,
                   const Points& points,
                   const SeedProposal& proposal,
                   const std::array<pcl::index_t, 2>& pair,
                   std::size_t count,
                   RandomGenerator& generator)
{
  std::array<Points, 2> drawn;
  for (const std::size_t side : {0u, 1u}) {
    Points members;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (proposal.group[i] == pair[side])
        members.push_back(points[i]);
    while (!members.empty() && drawn[side].size() < count) {
      std::swap(members[drawBelow(generator, members.size())], members.back());
      drawn[side].push_back(members.back());
      members.pop_back();
    }
  }
  return groupCID(field, drawn[0], drawn[1], samples);
}

TEST(GroupMerging, EstimateIsNearerThanThatOfAllPairsOfSixteenPoints)
{
  RoomOptions room;
  room.seed = 5;
  const Points points = sampleRoomEvenly(makeRoom(room), 800, 5).points;
  const DistanceField field(points);
  const SeedProposal proposal = groupsOf(points, 10);
  const auto groups = static_cast<pcl::index_t>(proposal.seeds.size());
  RandomGenerator generator(6);
  double ours = 0.0, all_pairs = 0.0;
  for (pcl::index_t i = 0; i < groups; ++i)
    for (pcl::index_t j = i + 1; j < groups; ++j) {
      const std::array<pcl::index_t, 2> pair = {i, j};
      GroupMergingOptions options; // 32 pairs
      options.samples = samples;
      const double truth = estimateOf(field, points, proposal, pair, exact());
      const double estimate = estimateOf(field, points, proposal, pair, options);
      const double of_256 =
          estimateOfAllPairs(field, points, proposal, pair, 16, generator);
      ours += (estimate - truth) * (estimate - truth);
      all_pairs += (of_256 - truth) * (of_256 - truth);
    }
  EXPECT_LT(ours, all_pairs);
}

TEST(GroupMerging, CancelAndBadValues)
{
  const Points points = twoBoxes(200, 44);
  const SeedProposal proposal = groupsOf(points, 10);
  GroupMergingOptions options;
  options.execution.progress = [](double) { return false; };
  EXPECT_THROW(treeOf(points, proposal, options), CIDCancelled);

  const DistanceField field(points);
  options = {};
  EXPECT_THROW(mergeGroups(field, points, proposal.group, 11, options), CIDException)
      << "group 10 is empty";
  EXPECT_THROW(mergeGroups(field, points, proposal.group, 9, options), CIDException)
      << "group 9 is out of range";
  options.samples = 1;
  EXPECT_THROW(mergeGroups(field, points, proposal.group, 10, options), CIDException);

  const MergeTree tree = treeOf(points, proposal, {});
  for (const std::size_t samples : {std::size_t{0},
                                    std::size_t{setting::group_samples.most} + 1,
                                    std::numeric_limits<std::size_t>::max()}) {
    GroupMergingOptions wrong;
    wrong.group_samples = samples;
    EXPECT_THROW(mergeGroups(field, points, proposal.group, 10, wrong), CIDException)
        << samples;
  }
  EXPECT_THROW(tree.cutAtParts(0), CIDException);
  EXPECT_THROW(tree.cutAtHeight(-0.1), CIDException);
  EXPECT_THROW(tree.cutAtHeight(NAN), CIDException);
}

TEST(GroupMerging, OfAGroupingIsThatOfItsGroups)
{
  PreparationSettings settings = plainSettings();
  settings.density = DensityWeight::on;
  settings.random_seed = 77;
  for (const int subsample : {0, 250}) {
    settings.subsample = subsample;
    Grouping grouping(prepared(twoBoxes(500, 44), settings), {samples});
    EXPECT_THROW(pcl_cid::mergeGroups(grouping), CIDException) << "no seeds";
    grouping.propose(14);
    grouping.removeSeeds({3, 9});
    MergingSettings merging;
    merging.group_samples = 6; // far fewer than there are, so that the draw counts
    pcl_cid::GroupMergingOptions options;
    options.group_samples = 6;
    options.samples = samples;
    options.random_seed = 77;
    const MergeTree expected = pcl_cid::mergeGroups(
        grouping.scan().working(), grouping.groupsOfWorkingPoints(), 12, options);
    expectSame(pcl_cid::mergeGroups(grouping, merging), expected);
    std::size_t points = 0;
    for (const std::size_t size : expected.groupSizes())
      points += size;
    EXPECT_EQ(points, grouping.scan().working().size());
    merging.stop_at_parts = 5;
    EXPECT_EQ(pcl_cid::mergeGroups(grouping, merging).cutAtParts(5),
              expected.cutAtParts(5));
    merging.group_samples = 0;
    EXPECT_THROW(pcl_cid::mergeGroups(grouping, merging), CIDException);
    merging = {};
    merging.stop_at_height = -1.0;
    EXPECT_THROW(pcl_cid::mergeGroups(grouping, merging), CIDException);
    ExecutionOptions execution;
    execution.progress = [](double) { return false; };
    EXPECT_THROW(pcl_cid::mergeGroups(grouping, {}, execution), CIDCancelled);
  }
}

} // namespace
} // namespace pcl_cid::test
