/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Costs of pairs that are asked for again and again.
 */

#pragma once

#include "cid/segment_search.h"
#include "cid/working_points.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <unordered_map>

namespace pcl_cid {

/** \brief Costs of pairs, each searched for once: from click to click, most borders of
 *  groups stay where they are. When too many are known, some are forgotten; that costs
 *  time and changes no result.
 *  \note Thread safety: all may be called concurrently.
 *  \note Memory: at most about 50 bytes for each of the points. */
class KnownCosts {
public:
  /** \param[in] points must outlive this
   *  \param[in] samples M */
  KnownCosts(const WorkingPoints& points, int samples);

  /** \brief A search for a thread of its own. */
  SegmentSearch
  search() const
  {
    return SegmentSearch(points_.field(), order_);
  }

  /** \brief The cost of a pair if it is below a limit, else a value that is at least
   *  the limit and at most the cost. */
  float
  cost(std::size_t p, std::size_t q, float limit, SegmentSearch& search);

private:
  struct Known {
    float low = 0.0f; ///< at most the cost
    bool is_exact = false;

    bool
    tells(float limit) const
    {
      return is_exact || low >= limit;
    }
  };

  /** Threads seldom meet in the same share. */
  struct Share {
    std::mutex mutex;
    std::unordered_map<std::uint64_t, Known> costs;
  };

  Share&
  shareOf(std::uint64_t pair)
  {
    return shares_[pair % shares_.size()];
  }

  Known
  known(std::uint64_t pair);

  void
  keep(std::uint64_t pair, const Known& known);

  const WorkingPoints& points_;
  const SampleOrder order_;
  std::array<Share, 61> shares_;
};

} // namespace pcl_cid
