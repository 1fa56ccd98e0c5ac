/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The paper, word for word, in double precision.
 */

#include "oracle.h"

#include "grouping/soft_draw.h"

#include <pcl_cid/core/concavity.h>

#include <algorithm>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace pcl_cid::test {

double
agreementTolerance(const Points& points)
{
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : points)
    box.extend(p);
  return box.isEmpty() ? 0.0 : 1e-5 * static_cast<double>(box.diagonal().norm());
}

Oracle::Oracle(const Points& surface, int samples) : samples_(samples)
{
  for (const Eigen::Vector3f& p : surface)
    surface_.push_back(p.cast<double>());
}

double
Oracle::distance(const Eigen::Vector3d& x) const
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& p : surface_)
    nearest = std::min(nearest, (x - p).squaredNorm());
  return std::sqrt(nearest);
}

double
Oracle::pointCID(const Eigen::Vector3f& p, const Eigen::Vector3f& q) const
{
  const Eigen::Vector3d from = p.cast<double>();
  const Eigen::Vector3d to = q.cast<double>();
  double largest = 0.0;
  for (int l = 0; l < samples_; ++l)
    largest = std::max(
        largest,
        distance(from + (to - from) * (static_cast<double>(l) / (samples_ - 1))));
  return largest;
}

double
Oracle::groupCID(const Points& first, const Points& second) const
{
  double sum = 0.0;
  for (const Eigen::Vector3f& p : first)
    for (const Eigen::Vector3f& q : second)
      sum += pointCID(p, q);
  return sum / static_cast<double>(first.size() * second.size());
}

namespace {

/** A cue by its formula. */
double
difference(Cue::Property property, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  if (property == Cue::Property::color)
    return (a - b).norm();
  // |a|^2 + |b|^2 is the weight, where neither is 0.
  return a.squaredNorm() + b.squaredNorm() - 2.0 * std::abs(a.dot(b));
}

} // namespace

double
Oracle::pointCost(const Points& points,
                  std::size_t p,
                  std::size_t q,
                  const PairCosts* costs) const
{
  double cost = pointCID(points[p], points[q]);
  if (costs && !costs->spacing.empty())
    cost *= 2.0 / (static_cast<double>(costs->spacing[p]) +
                   static_cast<double>(costs->spacing[q]));
  if (costs)
    for (const Cue& cue : costs->cues)
      cost += difference(
          cue.property, cue.values[p].cast<double>(), cue.values[q].cast<double>());
  return cost;
}

namespace {

/** Where rounding may decide between two costs. */
double
toleranceOfCosts(const Points& surface, const PairCosts* costs)
{
  double tolerance = agreementTolerance(surface);
  if (costs && !costs->spacing.empty()) {
    const auto least = std::min_element(costs->spacing.begin(), costs->spacing.end());
    tolerance *= std::max(1.0, 1.0 / static_cast<double>(*least));
  }
  if (costs)
    for (const Cue& cue : costs->cues)
      tolerance += agreementTolerance(cue.values);
  return tolerance;
}

/** D_min of each point, times its factor where the k-th seed is drawn; less than
 *  nothing for isolated points. */
template <typename Number>
std::vector<Number>
chances(const std::vector<Number>& nearest,
        const SeedProposalOptions& options,
        std::size_t k)
{
  std::vector<Number> chance = nearest;
  const SoftDraw draw(options.random_seed, k);
  if (options.rule == SeedingRule::soft)
    for (std::size_t i = 0; i < chance.size(); ++i)
      chance[i] *= static_cast<Number>(draw.factor(i));
  for (const pcl::index_t isolated : options.isolated)
    chance[static_cast<std::size_t>(isolated)] = Number{-1};
  return chance;
}

SeedProposalOptions
withoutDraws(SeedProposalOptions options)
{
  options.rule = SeedingRule::farthest;
  return options;
}

} // namespace

void
expectAgreesWithAlgorithm1(const SeedProposal& proposal,
                           const Points& surface,
                           const Points& points,
                           const SeedProposalOptions& options)
{
  const Oracle oracle(surface, options.samples);
  const double tolerance = toleranceOfCosts(surface, options.costs);
  ASSERT_EQ(proposal.group.size(), points.size());
  ASSERT_EQ(proposal.cid.size(), points.size());
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
  std::vector<double> to_own_seed(points.size(), 0.0);
  for (std::size_t k = 0; k < proposal.seeds.size(); ++k) {
    const auto seed = static_cast<std::size_t>(proposal.seeds[k]);
    if (k > 0) {
      const std::vector<double> chance = chances(nearest, options, k);
      const double largest = *std::max_element(chance.begin(), chance.end());
      EXPECT_GE(chance[seed], largest - tolerance * SoftDraw::largest_factor)
          << "seed " << k;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double cid = oracle.pointCost(points, i, seed, options.costs);
      nearest[i] = std::min(nearest[i], cid);
      if (proposal.group[i] == static_cast<pcl::index_t>(k))
        to_own_seed[i] = cid;
    }
    const std::vector<double> counted = chances(nearest, withoutDraws(options), k);
    EXPECT_NEAR(static_cast<double>(proposal.coverage[k]),
                *std::max_element(counted.begin(), counted.end()),
                tolerance)
        << "coverage " << k;
  }
  for (std::size_t k = 0; k < proposal.seeds.size(); ++k) { // a seed keeps its point
    const auto seed = static_cast<std::size_t>(proposal.seeds[k]);
    EXPECT_EQ(proposal.seeds[static_cast<std::size_t>(proposal.group[seed])],
              proposal.seeds[k]);
    to_own_seed[seed] = nearest[seed];
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LE(to_own_seed[i], nearest[i] + tolerance) << "group of point " << i;
    EXPECT_NEAR(static_cast<double>(proposal.cid[i]), nearest[i], tolerance)
        << "CID of point " << i;
  }
}

void
expectAgreesWithAlgorithm2(const MergeTree& tree,
                           const Points& surface,
                           const Points& points,
                           const std::vector<pcl::index_t>& group,
                           const GroupMergingOptions& options)
{
  const Oracle oracle(surface, options.samples);
  const double tolerance = toleranceOfCosts(surface, options.costs);
  const auto costOf = [&](const auto& first, const auto& second) {
    double sum = 0.0;
    for (const std::size_t p : first)
      for (const std::size_t q : second)
        sum += oracle.pointCost(points, p, q, options.costs);
    return sum / static_cast<double>(first.size() * second.size());
  };
  std::vector<std::vector<std::size_t>> groups(tree.numberOfGroups());
  for (std::size_t i = 0; i < points.size(); ++i)
    groups[static_cast<std::size_t>(group[i])].push_back(i);
  ASSERT_EQ(tree.steps().size(), groups.size() - 1);
  for (const MergeStep& step : tree.steps()) {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < groups.size(); ++i)
      for (std::size_t j = i + 1; j < groups.size(); ++j)
        if (!groups[i].empty() && !groups[j].empty())
          smallest = std::min(smallest, costOf(groups[i], groups[j]));
    ASSERT_LT(step.first, step.second);
    std::vector<std::size_t>& into = groups[static_cast<std::size_t>(step.first)];
    std::vector<std::size_t>& from = groups[static_cast<std::size_t>(step.second)];
    ASSERT_FALSE(into.empty());
    ASSERT_FALSE(from.empty());
    const double height = costOf(into, from);
    EXPECT_LE(height, smallest + tolerance);
    EXPECT_NEAR(step.height, height, tolerance);
    into.insert(into.end(), from.begin(), from.end());
    from.clear();
    EXPECT_EQ(step.size, into.size());
  }
}

SeedProposal
proposeByAllPairs(const DistanceField& field,
                  const Points& points,
                  pcl::index_t start,
                  const SeedProposalOptions& options)
{
  SeedProposal proposal;
  proposal.group.assign(points.size(), -1);
  proposal.cid.assign(points.size(), std::numeric_limits<float>::infinity());
  auto next = static_cast<std::size_t>(start);
  for (;;) {
    const auto number = static_cast<pcl::index_t>(proposal.seeds.size());
    proposal.seeds.push_back(static_cast<pcl::index_t>(next));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const PairCost cost =
          options.costs ? options.costs->between(next, i) : PairCost();
      const float cid =
          cost.of(pointCID(field, points[i], points[next], options.samples));
      if (cid < proposal.cid[i]) {
        proposal.cid[i] = cid;
        proposal.group[i] = number;
      }
    }
    const auto counted = chances(proposal.cid, withoutDraws(options), 0);
    proposal.coverage.push_back(*std::max_element(counted.begin(), counted.end()));
    if (proposal.seeds.size() == options.seeds || proposal.coverage.back() <= 0.0f)
      break;
    const auto chance = chances(proposal.cid, options, proposal.seeds.size());
    next = static_cast<std::size_t>(std::max_element(chance.begin(), chance.end()) -
                                    chance.begin());
  }
  for (std::size_t k = 0; k < proposal.seeds.size(); ++k) // a seed keeps its point
    proposal.group[static_cast<std::size_t>(proposal.seeds[k])] =
        static_cast<pcl::index_t>(k);
  return proposal;
}

void
expectSameProposal(const SeedProposal& a, const SeedProposal& b)
{
  EXPECT_EQ(a.seeds, b.seeds);
  EXPECT_EQ(a.group, b.group);
  EXPECT_EQ(a.cid, b.cid);
  EXPECT_EQ(a.coverage, b.coverage);
}

void
expectTraversalInvariants(const SeedProposal& proposal, std::size_t points)
{
  ASSERT_FALSE(proposal.seeds.empty());
  ASSERT_EQ(proposal.coverage.size(), proposal.seeds.size());
  ASSERT_EQ(proposal.group.size(), points);
  ASSERT_EQ(proposal.cid.size(), points);
  const std::set<pcl::index_t> distinct(proposal.seeds.begin(), proposal.seeds.end());
  EXPECT_EQ(distinct.size(), proposal.seeds.size()) << "a seed is repeated";
  for (std::size_t k = 1; k < proposal.coverage.size(); ++k)
    EXPECT_LE(proposal.coverage[k], proposal.coverage[k - 1]);
  for (std::size_t k = 0; k < proposal.seeds.size(); ++k)
    EXPECT_EQ(proposal.group[static_cast<std::size_t>(proposal.seeds[k])],
              static_cast<pcl::index_t>(k));
  for (std::size_t i = 0; i < points; ++i) {
    ASSERT_GE(proposal.group[i], 0);
    ASSERT_LT(static_cast<std::size_t>(proposal.group[i]), proposal.seeds.size());
    EXPECT_GE(proposal.cid[i], 0.0f);
    EXPECT_LE(proposal.cid[i], proposal.coverage.back());
  }
}

} // namespace pcl_cid::test
