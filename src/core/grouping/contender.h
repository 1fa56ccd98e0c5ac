/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which of two seeds a point belongs to.
 */

#pragma once

#include "base/infinity.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pcl_cid {

/** \brief A seed that a point may belong to. */
struct Contender {
  std::int32_t id; ///< see BlockGroups
  std::size_t rank;
  float low;               ///< at most the cost of the point and this seed
  bool is_exact = false;   ///< it is the cost
  std::size_t hint = 0;    ///< the sample to look at first
  std::int32_t rival = -1; ///< its place among the rivals of the block

  /** \brief The smaller cost wins; at equal cost the earlier seed. */
  bool
  operator<(const Contender& other) const
  {
    return low < other.low || (low == other.low && rank < other.rank);
  }

  /** \brief The cost at which this seed loses to the other one. At equal cost the
   *  earlier seed wins, hence the next float up for it. */
  float
  limitAgainst(const Contender& other) const
  {
    return rank < other.rank ? std::nextafter(other.low, infinity) : other.low;
  }
};

} // namespace pcl_cid
