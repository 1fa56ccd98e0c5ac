/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID_g of every pair of groups: bounds first, exact values on demand.
 */

#pragma once

#include "base/parallel_for.h"
#include "cid/segment_samples.h"
#include "group_draw.h"

#include "cid/working_points.h"
#include "merge_groups.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief CID_g of the groups that Algorithm 2 begins with: rough lower bounds for all
 *  pairs, then better ones and finally exact values for the pairs that are asked for.
 */
class GroupCIDs {
public:
  struct Pair {
    std::size_t i;
    std::size_t j; ///< above i
  };

  /** \param[in] points all points
   *  \param[in] drawn some of each group, indices */
  GroupCIDs(const WorkingPoints& points,
            std::vector<pcl::Indices> drawn,
            const GroupMergingOptions& options,
            Progress& progress);

  bool
  isExact(Pair pair) const
  {
    return tried_[place(pair)] == exact;
  }

  /** \brief CID_g or, while it is not exact, a lower bound of it. */
  double
  value(Pair pair) const
  {
    return values_[place(pair)];
  }

  /** \brief Get closer to "D[G_i, G_j] <- CID_g(G_i, G_j | S)" of Algorithm 2, for some
   *  pairs: a better bound, or the exact value after that. */
  void
  tighten(const std::vector<Pair>& pairs);

private:
  std::size_t
  place(Pair pair) const
  {
    return pair.i * drawn_.size() + pair.j;
  }

  void
  tighten(Pair pair);

  void
  evaluate(Pair pair);

  template <typename CostOfTwo>
  double
  meanOf(Pair pair, CostOfTwo costOfTwo) const;

  struct Effort;
  static const std::array<Effort, 3> efforts; ///< one after the other
  static constexpr std::uint8_t exact = 255;  ///< in the place of their number

  double
  lowerBound(Pair pair, const Effort& effort) const;

  float
  lowerBound(const SegmentSamples& segment, const Effort& effort) const;

  PairCost
  costOf(pcl::index_t p, pcl::index_t q) const
  {
    return points_.costs().between(static_cast<std::size_t>(p),
                                   static_cast<std::size_t>(q));
  }

  const Eigen::Vector3f&
  position(pcl::index_t p) const
  {
    return points_.points()[static_cast<std::size_t>(p)];
  }

  ProgressSpan
  share() const;

  const WorkingPoints& points_;
  std::vector<pcl::Indices> drawn_;
  PairLattice lattice_;
  SampleOrder order_;
  int threads_;
  Progress& progress_;
  std::vector<double> values_;
  std::vector<std::uint8_t> tried_; ///< how many were made for a pair
  std::size_t tightened_ = 0;
};

} // namespace pcl_cid
