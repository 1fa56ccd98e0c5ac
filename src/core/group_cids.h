/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID_g of every pair of groups: bounds first, exact values on demand.
 */

#pragma once

#include "parallel_for.h"
#include "segment_samples.h"

#include <pcl_cid/core/group_merging.h>

#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief CID_g of the groups that Algorithm 2 begins with: certified lower bounds for
 * all pairs, exact values for those that are asked for. */
class GroupCIDs {
public:
  struct Pair {
    std::size_t i;
    std::size_t j; ///< above i
  };

  /** \param[in] drawn points of each group */
  GroupCIDs(const DistanceField& field,
            std::vector<Points> drawn,
            const GroupMergingOptions& options,
            Progress& progress);

  bool
  isExact(Pair pair) const
  {
    return exact_[place(pair)] != 0;
  }

  /** \brief CID_g or, while it is not exact, a lower bound of it. */
  double
  value(Pair pair) const
  {
    return values_[place(pair)];
  }

  /** \brief "D[G_i, G_j] <- CID_g(G_i, G_j | S)" of Algorithm 2, for some pairs. */
  void
  makeExact(const std::vector<Pair>& pairs);

private:
  std::size_t
  place(Pair pair) const
  {
    return pair.i * drawn_.size() + pair.j;
  }

  double
  lowerBound(Pair pair) const;

  ProgressSpan
  share() const;

  const DistanceField& field_;
  std::vector<Points> drawn_;
  SampleOrder order_;
  int threads_;
  Progress& progress_;
  std::vector<double> values_;
  std::vector<std::uint8_t> exact_;
  std::size_t made_exact_ = 0;
};

} // namespace pcl_cid
