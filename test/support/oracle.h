/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The paper, word for word, in double precision: what the library must agree with.
 */

#pragma once

#include <cstddef>
#include <vector>

#include "seeds_on_points.h"

#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/point_set.h>

#include <Eigen/Core>

namespace pcl_cid::test {

/** Where rounding may decide between two candidates: 1e-5 of the cloud's diagonal. */
double
agreementTolerance(const Points& points);

/** Literal definitions by brute force on a surface. No bound, no tree, no shortcut. */
class Oracle {
public:
  Oracle(const Points& surface, int samples);

  /** d(x; S). */
  double
  distance(const Eigen::Vector3d& x) const;

  /** Eq. 2. */
  double
  pointCID(const Eigen::Vector3f& p, const Eigen::Vector3f& q) const;

  /** Eq. 3 over all pairs. */
  double
  groupCID(const Points& first, const Points& second) const;

  /** What the CID of two of the points costs. */
  double
  pointCost(const Points& points,
            std::size_t p,
            std::size_t q,
            const PairCosts* costs) const;

private:
  std::vector<Eigen::Vector3d> surface_;
  int samples_;
};

/** Follow a proposal seed by seed with the oracle and fail (gtest, non-fatally) where a
 *  seed is not a farthest point, a point is not with a nearest seed, or a CID or a
 *  coverage is off, each by more than the tolerance. */
void
expectAgreesWithAlgorithm1(const SeedProposal& proposal,
                           const Points& surface,
                           const Points& points,
                           const SeedProposalOptions& options);

/** The same for Algorithm 2 with every CID_g over all pairs, computed anew after each
 *  merge. */
void
expectAgreesWithAlgorithm2(const MergeTree& tree,
                           const Points& surface,
                           const Points& points,
                           const std::vector<pcl::index_t>& group,
                           const GroupMergingOptions& options);

/** Algorithm 1 with the library's own pointCID() for every pair: no block, no bound.
 * The result of proposeSeeds() to the last bit. */
SeedProposal
proposeByAllPairs(const DistanceField& field,
                  const Points& points,
                  pcl::index_t start,
                  const SeedProposalOptions& options);

void
expectSameProposal(const SeedProposal& a, const SeedProposal& b);

/** What must hold for every proposal, whatever the cloud: sizes, groups in range, seeds
 *  distinct and with themselves, coverage never growing and above every CID. */
void
expectTraversalInvariants(const SeedProposal& proposal, std::size_t points);

} // namespace pcl_cid::test
