/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The points whose labels may change, and to what.
 */

#pragma once

#include "base/parallel_for.h"
#include "cid/working_points.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief A point near a boundary. */
struct BoundaryPoint {
  std::size_t point; ///< index among the points that are worked on
  /** Its own and all others within reach, ascending, none of them 0: at least 2. */
  std::vector<std::uint32_t> labels;
};

/** \brief The points that are within a distance of another label than their own; label
 *  0 is none.
 *  \param[in] labels of the points
 *  \param[in] fixed points that are left out, such as seeds; by point
 *  \param[in] reach metres; the distance itself is within it, both squared in float
 *  \return from block to block, so that neighbors mostly follow each other; the same
 *  for every number of threads
 *  \throws CIDCancelled */
std::vector<BoundaryPoint>
findBoundaryPoints(const WorkingPoints& points,
                   const std::vector<std::uint32_t>& labels,
                   const std::vector<bool>& fixed,
                   float reach,
                   int threads,
                   Progress& progress,
                   ProgressSpan span);

} // namespace pcl_cid
