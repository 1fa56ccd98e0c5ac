/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithms 1 and 2 on pairs that cost more or less than their CID, with isolated
 * points and drawn seeds.
 */

#include "base/random.h"
#include "clouds.h"
#include "grouping/soft_draw.h"
#include "oracle.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** Numbers between two others, each order of magnitude as often. */
struct LogUniform {
  RandomGenerator generator;

  float
  operator()(float least, float most)
  {
    const float share = static_cast<float>(drawBelow(generator, 1u << 20)) / (1u << 20);
    return least * std::pow(most / least, share);
  }
};

TEST(PairCost, NoCIDBelowTheInverseReachesTheLimit)
{
  LogUniform draw{RandomGenerator(5)};
  for (int n = 0; n < 20000; ++n) {
    const PairCost cost{draw(0.01f, 100.0f), n % 3 == 0 ? 0.0f : draw(1e-6f, 10.0f)};
    const float limit = n % 2 == 0 ? cost.of(draw(1e-6f, 10.0f)) : draw(1e-6f, 10.0f);
    const float cid = cost.cidBelow(limit);
    if (cid > 0.0f) {
      EXPECT_LT(cost.of(std::nextafter(cid, 0.0f)), limit);
    }
    // And it is not far below: bounds would be of no use.
    EXPECT_GE(cost.of(cid * 1.00001f) + 1e-5f * (limit + cost.cue), limit);
  }
  EXPECT_EQ(PairCost().cidBelow(INFINITY), INFINITY);
  EXPECT_EQ((PairCost{2.0f, 0.5f}.cidBelow(0.25f)), 0.0f);
}

TEST(PairCost, NoCIDOfACostExceedsTheInverse)
{
  LogUniform draw{RandomGenerator(6)};
  for (int n = 0; n < 20000; ++n) {
    const PairCost cost{draw(0.01f, 100.0f), n % 3 == 0 ? 0.0f : draw(1e-6f, 10.0f)};
    const float cid = n % 7 == 0 ? 0.0f : draw(1e-6f, 10.0f);
    const float within = cost.cidWithin(cost.of(cid));
    EXPECT_GE(within, cid);
    EXPECT_LE(cost.of(within), cost.of(cid) + 1e-5f * (cost.of(cid) + cost.cue));
  }
}

TEST(PairCosts, AreTheFormula)
{
  PairCosts costs;
  EXPECT_EQ(costs.between(3, 4).of(0.25f), 0.25f); // the paper
  costs.spacing = {0.5f, 1.5f};
  EXPECT_EQ(costs.between(0, 1).of(0.25f), 0.25f); // 2 / (0.5 + 1.5)
  EXPECT_EQ(costs.between(0, 0).of(0.25f), 0.5f);
  costs.cues = {{Cue::Property::color, {{0.0f, 0.0f, 0.0f}, {0.3f, 0.0f, -0.4f}}}};
  EXPECT_FLOAT_EQ(costs.between(0, 1).of(0.25f), 0.75f);
  EXPECT_EQ(costs.between(0, 1).of(0.3f), costs.between(1, 0).of(0.3f));
  // A right angle at a weight of 0.5.
  costs.cues.push_back(
      {Cue::Property::normal, {{0.5f, 0.0f, 0.0f}, {0.0f, 0.5f, 0.0f}}});
  EXPECT_FLOAT_EQ(costs.between(0, 1).of(0.25f), 1.25f);
}

TEST(Cue, AnAngleIsTheFormulaWhateverTheSigns)
{
  RandomGenerator generator(4);
  const auto direction = [&] {
    Eigen::Vector3d v;
    for (int axis = 0; axis < 3; ++axis)
      v[axis] = static_cast<double>(drawBelow(generator, 2001)) - 1000.0;
    return v.squaredNorm() > 0.0 ? v.normalized().eval()
                                 : Eigen::Vector3d::UnitX().eval();
  };
  constexpr double weight = 0.03;
  for (int n = 0; n < 1000; ++n) {
    const Eigen::Vector3d a = direction();
    const Eigen::Vector3d b = direction();
    const double scale = std::sqrt(weight / 2.0);
    const double expected = weight * (1.0 - std::abs(a.dot(b)));
    for (const double sign : {1.0, -1.0}) {
      const Cue cue{Cue::Property::normal,
                    {(scale * a).cast<float>(), (sign * scale * b).cast<float>()}};
      EXPECT_NEAR(cue.between(0, 1), expected, 1e-6 * weight);
      EXPECT_EQ(cue.between(0, 1), cue.between(1, 0));
      EXPECT_EQ(cue.between(0, 0), 0.0f);
    }
  }
}

TEST(Cue, BoundsOfABoxHoldForAllInIt)
{
  RandomGenerator generator(8);
  const auto value = [&] {
    Eigen::Vector3f v;
    for (int axis = 0; axis < 3; ++axis)
      v[axis] = static_cast<float>(drawBelow(generator, 2001)) * 1e-3f - 1.0f;
    return v;
  };
  for (const auto property : {Cue::Property::color, Cue::Property::normal})
    for (int n = 0; n < 500; ++n) {
      Cue cue{property, {value()}};
      const Eigen::Vector3f middle = value();
      PointBox box{padded(middle), padded(middle)};
      for (int k = 0; k < 8; ++k) {
        cue.values.push_back(middle + 0.3f * value());
        box = {box.low.min(padded(cue.values.back())),
               box.high.max(padded(cue.values.back()))};
      }
      for (std::size_t k = 1; k < cue.values.size(); ++k) {
        EXPECT_LE(cue.least(box, 0), cue.between(0, k));
        EXPECT_GE(cue.most(box, 0), cue.between(0, k));
      }
    }
}

TEST(SoftDraw, FactorsAreBoundedAndDifferFromDrawToDraw)
{
  const SoftDraw first(7, 1);
  const SoftDraw second(7, 2);
  int equal = 0;
  for (std::size_t i = 0; i < 100000; ++i) {
    EXPECT_GT(first.factor(i), 0.5f);
    EXPECT_LE(first.factor(i), SoftDraw::largest_factor);
    equal += first.factor(i) == second.factor(i) ? 1 : 0;
  }
  EXPECT_LT(equal, 10);
  // The hash is 32 bits: this is the largest factor there can be.
  const double largest = std::pow(-std::log1p(-0.5 / 4294967296.0), -1.0 / 16.0);
  EXPECT_LE(largest, static_cast<double>(SoftDraw::largest_factor));
}

TEST(SoftDraw, DrawsInProportionToTheSixteenthPower)
{
  const std::array<double, 3> cost = {1.0, 0.95, 0.9};
  double total = 0.0;
  for (const double c : cost)
    total += std::pow(c, 16.0);
  std::array<int, 3> drawn = {};
  constexpr int draws = 40000;
  for (int n = 0; n < draws; ++n) {
    const SoftDraw draw(11, static_cast<std::uint64_t>(n));
    std::size_t best = 0;
    for (std::size_t i = 1; i < cost.size(); ++i)
      if (cost[i] * static_cast<double>(draw.factor(i)) >
          cost[best] * static_cast<double>(draw.factor(best)))
        best = i;
    ++drawn[best];
  }
  for (std::size_t i = 0; i < cost.size(); ++i) {
    const double share = std::pow(cost[i], 16.0) / total;
    const double deviation = std::sqrt(share * (1.0 - share) / draws);
    EXPECT_NEAR(drawn[i] / static_cast<double>(draws), share, 5.0 * deviation) << i;
  }
}

/** What is switched on. */
struct Variant {
  std::string name;
  bool spacing;
  bool color;
  bool normals;
  bool isolated;
  SeedingRule rule;
};

/** Costs and settings for a cloud: spacing that varies over it and from point to point,
 *  colors and normals of a few patches with noise. */
class Settings {
public:
  Settings(const Variant& variant, const Points& points)
  {
    RandomGenerator generator(points.size());
    const auto noise = [&] {
      return static_cast<float>(drawBelow(generator, 1000)) / 1000.0f;
    };
    Cue color{Cue::Property::color, {}};
    Cue normals{Cue::Property::normal, {}};
    for (const Eigen::Vector3f& p : points) {
      if (variant.spacing)
        costs_.spacing.push_back(0.2f + std::fabs(std::sin(3.0f * p.x())) + noise());
      color.values.emplace_back(p.y() > 0.5f ? 0.1f : 0.0f, 0.02f * noise(), 0.0f);
      const Eigen::Vector3f direction(p.z() > 0.5f ? 1.0f : 0.1f, noise(), noise());
      normals.values.push_back(0.1f * direction.normalized());
    }
    if (variant.color)
      costs_.cues.push_back(color);
    if (variant.normals)
      costs_.cues.push_back(normals);
    if (variant.isolated)
      for (std::size_t i = 3; i < points.size(); i += 7)
        options_.isolated.push_back(static_cast<pcl::index_t>(i));
    options_.costs = &costs_;
    options_.rule = variant.rule;
    options_.random_seed = 9;
  }
  Settings(const Settings&) = delete;
  Settings&
  operator=(const Settings&) = delete;

  SeedProposalOptions
  options(std::size_t seeds, int samples = 40) const
  {
    SeedProposalOptions options = options_;
    options.seeds = seeds;
    options.samples = samples;
    return options;
  }

private:
  PairCosts costs_;
  SeedProposalOptions options_;
};

class TraversalWithCosts : public testing::TestWithParam<Variant> {};

TEST_P(TraversalWithCosts, AgreesWithTheOracle)
{
  for (const NamedPoints& cloud : allClouds()) {
    SCOPED_TRACE(cloud.name);
    const Settings settings(GetParam(), cloud.points);
    const SeedProposalOptions options = settings.options(9);
    const DistanceField field(cloud.points);
    expectAgreesWithAlgorithm1(proposeSeeds(field, cloud.points, 0, options),
                               cloud.points,
                               cloud.points,
                               options);
  }
}

TEST_P(TraversalWithCosts, EqualsAllPairsToTheBit)
{
  std::vector<NamedPoints> clouds = {{"two_boxes", twoBoxes(1200, 38)},
                                     {"cube", randomCube(500, 39)}};
  for (const char* name : {"office1.pcd", "room_scan1.pcd"})
    if (const auto scan = loadSharedScan(name))
      clouds.push_back({name, crop(*scan, 800, 11)});
  for (const NamedPoints& cloud : clouds) {
    SCOPED_TRACE(cloud.name);
    const Settings settings(GetParam(), cloud.points);
    const DistanceField field(cloud.points);
    SeedProposalOptions options = settings.options(20, 60);
    const SeedProposal expected = proposeByAllPairs(field, cloud.points, 0, options);
    expectSameProposal(proposeSeeds(field, cloud.points, 0, options), expected);
    options.keep_cid = false;
    EXPECT_EQ(proposeSeeds(field, cloud.points, 0, options).group, expected.group);
  }
}

TEST_P(TraversalWithCosts, SameHoweverManyThreadsAndSteps)
{
  for (const NamedPoints& cloud : allClouds()) {
    SCOPED_TRACE(cloud.name);
    const Settings settings(GetParam(), cloud.points);
    const DistanceField field(cloud.points);
    SeedProposalOptions options = settings.options(8);
    options.execution.threads = 1;
    const SeedProposal serial = proposeSeeds(field, cloud.points, 0, options);
    for (const unsigned int threads : {2u, 3u, 8u}) {
      options.execution.threads = threads;
      expectSameProposal(proposeSeeds(field, cloud.points, 0, options), serial);
    }
    SeedProposal extended = proposeSeeds(field, cloud.points, 0, settings.options(3));
    extendProposal(field, cloud.points, options, extended);
    expectSameProposal(extended, serial);
    expectSameProposal(groupBySeeds(field, cloud.points, serial.seeds, options),
                       serial);
  }
}

TEST_P(TraversalWithCosts, IsolatedPointsGetAGroupButAreNoSeeds)
{
  const Points points = twoBoxes(600, 41);
  const Settings settings(GetParam(), points);
  const SeedProposalOptions options = settings.options(40);
  const SeedProposal proposal = proposeSeeds(DistanceField(points), points, 0, options);
  for (const pcl::index_t isolated : options.isolated) {
    EXPECT_EQ(std::count(proposal.seeds.begin(), proposal.seeds.end(), isolated), 0);
    EXPECT_GE(proposal.group[static_cast<std::size_t>(isolated)], 0);
  }
}

TEST_P(TraversalWithCosts, MergingAgreesWithTheOracle)
{
  for (const NamedPoints& cloud : allClouds()) {
    SCOPED_TRACE(cloud.name);
    const Points points(cloud.points.begin(),
                        cloud.points.begin() +
                            std::min<std::ptrdiff_t>(
                                60, static_cast<std::ptrdiff_t>(cloud.points.size())));
    const Settings settings(GetParam(), points);
    const DistanceField field(points);
    const SeedProposal proposal =
        proposeSeeds(field, points, 0, settings.options(7, 20));
    GroupMergingOptions options;
    options.samples = 20;
    options.group_samples = 1u << 20; // all pairs
    options.costs = settings.options(1).costs;
    const MergeTree whole =
        mergeGroups(field, points, proposal.group, proposal.seeds.size(), options);
    expectAgreesWithAlgorithm2(whole, points, points, proposal.group, options);
    // With bounds, which the whole tree does without.
    options.stop_at_parts = 2;
    const MergeTree stopped =
        mergeGroups(field, points, proposal.group, proposal.seeds.size(), options);
    for (std::size_t n = 0; n < stopped.steps().size(); ++n) {
      EXPECT_EQ(stopped.steps()[n].first, whole.steps()[n].first);
      EXPECT_EQ(stopped.steps()[n].second, whole.steps()[n].second);
      EXPECT_EQ(stopped.steps()[n].height, whole.steps()[n].height);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Variants,
    TraversalWithCosts,
    testing::Values(
        Variant{"spacing", true, false, false, false, SeedingRule::farthest},
        Variant{"color", false, true, false, false, SeedingRule::farthest},
        Variant{"normals", false, false, true, false, SeedingRule::farthest},
        Variant{"isolated", false, false, false, true, SeedingRule::farthest},
        Variant{"soft", false, false, false, false, SeedingRule::soft},
        Variant{"all", true, true, true, true, SeedingRule::soft}),
    [](const auto& info) { return info.param.name; });

TEST(TraversalWithCosts, MovesSeedsToWhereTheyCostMore)
{
  // Two like halves; the left one is said to be sparse.
  const Points points = twoBoxes(800, 43);
  PairCosts costs;
  for (const Eigen::Vector3f& p : points)
    costs.spacing.push_back(p.x() < points.front().x() ? 8.0f : 0.5f);
  const auto left = [&](const SeedProposal& proposal) {
    return std::count_if(
        proposal.seeds.begin(), proposal.seeds.end(), [&](pcl::index_t seed) {
          return costs.spacing[static_cast<std::size_t>(seed)] > 1.0f;
        });
  };
  SeedProposalOptions options;
  options.seeds = 30;
  const DistanceField field(points);
  const auto before = left(proposeSeeds(field, points, 0, options));
  options.costs = &costs;
  EXPECT_LT(left(proposeSeeds(field, points, 0, options)), before);
}

TEST(TraversalWithCosts, RefusesBadValues)
{
  const Points points = randomCube(10, 3);
  const DistanceField field(points);
  const auto refuses = [&](const PairCosts& costs) {
    SeedProposalOptions options;
    options.costs = &costs;
    for (const auto place :
         {WorkingPoints::Place::are_surface, WorkingPoints::Place::anywhere}) {
      options.place = place;
      EXPECT_THROW(proposeSeeds(field, points, 0, options), CIDException);
      EXPECT_THROW(groupBySeeds(field, points, {0}, options), CIDException);
    }
  };
  PairCosts costs;
  costs.spacing.assign(9, 1.0f);
  refuses(costs); // too few
  for (const float bad : {0.0f, -1.0f, NAN, INFINITY}) {
    costs.spacing.assign(10, 1.0f);
    costs.spacing[4] = bad;
    refuses(costs);
  }
  costs.spacing.clear();
  costs.cues = {{Cue::Property::color, Points(10, Eigen::Vector3f(0.0f, NAN, 0.0f))}};
  refuses(costs);
  costs.cues = {{Cue::Property::normal, Points(9, Eigen::Vector3f::Zero())}};
  refuses(costs);
  GroupMergingOptions merging;
  costs.spacing.assign(9, 1.0f);
  merging.costs = &costs;
  EXPECT_THROW(mergeGroups(field, points, std::vector<pcl::index_t>(10, 0), 1, merging),
               CIDException);
}

} // namespace
} // namespace pcl_cid::test
