/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The cost of one pair of points, as far as it matters.
 */

#pragma once

#include "base/infinity.h"
#include "pair_cost.h"
#include "segment_search.h"

#include <cstddef>

namespace pcl_cid {

/** \brief The cost of the pair at the ends of a segment if it is below a limit, else a
 *  value that is at least the limit and at most the cost.
 *  \param[in,out] hint see SegmentSearch */
inline float
searchCost(SegmentSearch& search,
           const Segment& segment,
           const PairCost& cost,
           float limit,
           std::size_t& hint)
{
  const float below = cost.cidBelow(limit);
  const float cid = search.pointCID(segment, below, hint);
  if (cid < below || cost.of(cid) >= limit)
    return cost.of(cid);
  return cost.of(search.pointCID(segment, infinity, hint)); // the bounds cannot tell
}

} // namespace pcl_cid
