/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithm 1: seeds by farthest-first traversal in CID, and the group of each
 * point.
 */

#pragma once

#include <pcl_cid/core/distance_field.h>
#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/pair_cost.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief Seeds, and the seed that each point belongs to.
 *
 *  The seeds are in the order in which they were chosen, and nested: the first k of
 *  them are what k seeds would have been. */
struct SeedProposal {
  /** Index of each seed among the points. */
  pcl::Indices seeds;
  /** Number (0, 1, ...) of the seed with the smallest CID_p (or cost, where pairs have
   *  one) to each point; -1 for a point that was not grouped. At equal CID the earlier
   *  seed keeps the point. */
  std::vector<pcl::index_t> group;
  /** CID_p (or cost) of each point to that seed, metres; NaN for a point that was not
   *  grouped. Empty when it was not asked for. */
  std::vector<float> cid;
  /** r_k for each seed: the largest entry of `cid` once that seed was taken in. Never
   *  grows; the last one is a guarantee: every point that is not isolated is within it
   *  of its seed. */
  std::vector<float> coverage;
};

/** \brief How points are compared with seeds. */
struct GroupingOptions {
  /** M: samples on a segment, min_samples to max_samples. */
  int samples = 100;
  /** What the pairs cost, of as many points as are grouped; null, the default, means
   *  their CIDs. It must outlive the call. */
  const PairCosts* costs = nullptr;
  /** Points that do not count in the coverage and are not proposed as seeds, indices
   *  among the points; not all of them. They get a group like all others. */
  pcl::Indices isolated;
  /** Fill in `cid`, which about doubles the time and which extendProposal() needs. */
  bool keep_cid = true;
  ExecutionOptions execution;
};

/** \brief When the traversal of Algorithm 1 stops, and what it works on. */
struct SeedProposalOptions : GroupingOptions {
  /** K: seeds in all, at least 1. */
  std::size_t seeds = 100;
  /** Stop as soon as r_k is at most this, metres; 0 or more. */
  float coverage = 0.0f;
  /** Points that may become seeds, indices among the points; empty means all. */
  pcl::Indices candidates;
  SeedingRule rule = SeedingRule::farthest;
  /** Seed of the draws of the soft rule; the k-th is the same however many follow. */
  std::uint64_t random_seed = 0;
};

/** \brief Algorithm 1 (seed-point proposal by CID-FPS) with point grouping as its
 *  by-product, from a given start.
 *
 *  Again and again the candidate with the largest CID to its seed becomes the next
 *  seed; at equal CID the one of lowest index. Exactly K seeds, fewer when `coverage`
 *  is reached or when no candidate is left whose CID a seed of its own would lower (a
 *  duplicate of a seed never becomes one). The N x K matrix of the paper is never
 *  stored: O(N) memory.
 *  \param[in] field the surface S
 *  \param[in] points the points to be grouped, in the frame of the surface; not empty
 *  \param[in] start index of the first seed
 *  \param[in] options when to stop
 *  \throws CIDException for a setting out of its range, CIDCancelled
 *  \note Cost: K N CID evaluations, nearly all given up after one or two samples. Same
 *  result for every number of threads. */
PCL_CID_EXPORT SeedProposal
proposeSeeds(const DistanceField& field,
             const Points& points,
             pcl::index_t start,
             const SeedProposalOptions& options);

/** \brief Point grouping by seeds that are given (section IV.A): each point goes to the
 *  seed with the smallest CID_p, at equal CID to the earlier one.
 *  \param[in] field the surface S
 *  \param[in] points the points to be grouped, in the frame of the surface
 *  \param[in] seeds indices among the points, at least 1
 *  \param[in] options how they are compared
 *  \throws CIDException for a setting out of its range, CIDCancelled */
PCL_CID_EXPORT SeedProposal
groupBySeeds(const DistanceField& field,
             const Points& points,
             const pcl::Indices& seeds,
             const GroupingOptions& options);

/** \brief Go on with Algorithm 1 where a proposal ended, at the cost of the new seeds
 *  only: the result is that of one run with all of them. The seeds so far may be given
 *  ones (groupBySeeds) or proposed ones.
 *  \param[in,out] proposal unchanged when an exception is thrown
 *  \param[in] field,points,options as for proposeSeeds; options.seeds counts all
 *  seeds */
PCL_CID_EXPORT void
extendProposal(const DistanceField& field,
               const Points& points,
               const SeedProposalOptions& options,
               SeedProposal& proposal);

/** \brief Let given seeds join a finished proposal, at the cost of these seeds only:
 *  corrective seeds, where a first result was wrong. The result is that of groupBySeeds
 *  with all seeds in that order.
 *  \param[in,out] proposal with its CIDs; unchanged when an exception is thrown
 *  \param[in] field,points,seeds,options as for groupBySeeds; `cid` is kept */
PCL_CID_EXPORT void
addSeeds(const DistanceField& field,
         const Points& points,
         const pcl::Indices& seeds,
         const GroupingOptions& options,
         SeedProposal& proposal);

} // namespace pcl_cid
