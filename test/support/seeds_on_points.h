/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithms 1 and 2 on bare points: no preparation stands between them and the oracle.
 */

#pragma once

#include "cid/pair_cost.h"
#include "cid/working_points.h"
#include "merging/merge_groups.h"

#include <pcl_cid/core/grouping.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl_cid::test {

/** How points are compared with seeds. */
struct GroupingOptions {
  int samples = setting::samples.initial;
  /** Null means CIDs. */
  const PairCosts* costs = nullptr;
  /** These do not count in the coverage and are not proposed; not all of the points. */
  pcl::Indices isolated;
  bool keep_cid = true;
  /** None: are_surface where the points are those of the field, in the same order, else
   *  anywhere. */
  std::optional<WorkingPoints::Place> place;
  ExecutionOptions execution;
};

/** Algorithm 1, with all that it depends on. */
struct SeedProposalOptions : GroupingOptions {
  std::size_t seeds = 100;
  float coverage = 0.0f;
  /** Empty means all. */
  pcl::Indices candidates;
  SeedingRule rule = SeedingRule::farthest;
  std::uint64_t random_seed = 0;
};

/** Algorithm 2, with all that it depends on. */
struct GroupMergingOptions : pcl_cid::GroupMergingOptions {
  const PairCosts* costs = nullptr;
  std::optional<WorkingPoints::Place> place;
};

/** Algorithm 1 from a start; seeds are indices among the points. */
SeedProposal
proposeSeeds(const DistanceField& field,
             const Points& points,
             pcl::index_t start,
             const SeedProposalOptions& options);

/** Each point goes to the nearest of some seeds, which may repeat. */
SeedProposal
groupBySeeds(const DistanceField& field,
             const Points& points,
             const pcl::Indices& seeds,
             const GroupingOptions& options);

/** Go on from the seeds of a proposal, once every point is decided.
 *  \param[in,out] proposal with at least 1 seed; unchanged when an exception is thrown
 */
void
extendProposal(const DistanceField& field,
               const Points& points,
               const SeedProposalOptions& options,
               SeedProposal& proposal);

/** Given seeds join those of a proposal, once every point is decided.
 *  \param[in,out] proposal unchanged when an exception is thrown */
void
addSeeds(const DistanceField& field,
         const Points& points,
         const pcl::Indices& seeds,
         const GroupingOptions& options,
         SeedProposal& proposal);

/** Algorithm 2 on given groups. */
MergeTree
mergeGroups(const DistanceField& field,
            const Points& points,
            const std::vector<pcl::index_t>& group,
            std::size_t groups,
            const GroupMergingOptions& options);

} // namespace pcl_cid::test
