/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithm 1: seeds by farthest-first traversal in CID, and the group of each point.
 */

#pragma once

#include "block_groups.h"

#include <pcl_cid/core/grouping.h>

#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief When the traversal stops, and how it goes on. */
struct TraversalOptions {
  std::size_t seeds; ///< K, all in all
  float coverage;    ///< stop when r_k is at most this, metres
  SeedingRule rule;
  std::uint64_t random_seed; ///< of the draws of the soft rule
};

/** \brief Algorithm 1 on groups that may have seeds already. */
class Traversal {
public:
  /** \param[in,out] groups the points and the seeds so far
   *  \param[in] coverage r_k of the seeds so far; ignored without any */
  Traversal(BlockGroups& groups, float coverage, BlockGroups::Work work)
  : groups_(groups), coverage_(coverage), work_(work)
  {
  }

  /** \brief The loop of Algorithm 1.
   *  \param[in] start the first seed; ignored when there are seeds */
  ProposalStop
  run(pcl::index_t start, const TraversalOptions& options);

  /** \brief "D[p, q] <- CID_p(p, q)", "D_min", "S_l <- S_l U {p*}": each point goes to
   *  the seed if that is nearer than all before it.
   *  \param[in] rank of the seed
   *  \param[in] planned seeds in all */
  void
  addSeed(pcl::index_t seed, std::size_t rank, std::size_t planned);

  /** \brief Point grouping: every point is decided. */
  void
  finish(bool exactly);

  /** \brief r_k after each seed that was added, in that order. */
  const std::vector<float>&
  coverages() const
  {
    return coverages_;
  }

private:
  pcl::index_t
  next(const TraversalOptions& options);

  ProgressSpan
  step() const;

  BlockGroups& groups_;
  float coverage_;
  std::vector<float> coverages_;
  BlockGroups::Work work_;
  std::size_t planned_ = 0;
};

} // namespace pcl_cid
