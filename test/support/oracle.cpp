/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The paper, word for word, in double precision.
 */

#include "oracle.h"

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

void
expectAgreesWithAlgorithm1(const SeedProposal& proposal,
                           const Points& surface,
                           const Points& points,
                           int samples)
{
  const Oracle oracle(surface, samples);
  const double tolerance = agreementTolerance(surface);
  ASSERT_EQ(proposal.group.size(), points.size());
  ASSERT_EQ(proposal.cid.size(), points.size());
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
  std::vector<double> to_own_seed(points.size(), 0.0);
  for (std::size_t k = 0; k < proposal.seeds.size(); ++k) {
    const auto seed = static_cast<std::size_t>(proposal.seeds[k]);
    if (k > 0) {
      const double farthest = *std::max_element(nearest.begin(), nearest.end());
      EXPECT_GE(nearest[seed], farthest - tolerance) << "seed " << k;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double cid = oracle.pointCID(points[i], points[seed]);
      nearest[i] = std::min(nearest[i], cid);
      if (proposal.group[i] == static_cast<pcl::index_t>(k))
        to_own_seed[i] = cid;
    }
    EXPECT_NEAR(static_cast<double>(proposal.coverage[k]),
                *std::max_element(nearest.begin(), nearest.end()),
                tolerance)
        << "coverage " << k;
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
                           int samples)
{
  const Oracle oracle(surface, samples);
  const double tolerance = agreementTolerance(surface);
  std::vector<Points> groups(tree.numberOfGroups());
  for (std::size_t i = 0; i < points.size(); ++i)
    groups[static_cast<std::size_t>(group[i])].push_back(points[i]);
  ASSERT_EQ(tree.steps().size(), groups.size() - 1);
  for (const MergeStep& step : tree.steps()) {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < groups.size(); ++i)
      for (std::size_t j = i + 1; j < groups.size(); ++j)
        if (!groups[i].empty() && !groups[j].empty())
          smallest = std::min(smallest, oracle.groupCID(groups[i], groups[j]));
    ASSERT_LT(step.first, step.second);
    Points& into = groups[static_cast<std::size_t>(step.first)];
    Points& from = groups[static_cast<std::size_t>(step.second)];
    ASSERT_FALSE(into.empty());
    ASSERT_FALSE(from.empty());
    const double height = oracle.groupCID(into, from);
    EXPECT_LE(height, smallest + tolerance);
    EXPECT_NEAR(step.height, height, tolerance);
    into.insert(into.end(), from.begin(), from.end());
    from.clear();
    EXPECT_EQ(step.size, into.size());
  }
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
