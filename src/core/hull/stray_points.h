/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Stray points: those that do not belong to the part they are in.
 */

#pragma once

#include <pcl_cid/core/point_set.h>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief The points of a part, split; both in the order given. */
struct TrimmedPart {
  pcl::Indices kept;
  pcl::Indices trimmed;
};

/** \brief Trim the stray points of a part.
 *
 *  Points are linked when they are at most \a distance apart; links make clusters. A
 *  cluster is stray when the largest one has more than 100 times its points. So the
 *  largest is never trimmed, a part of up to 100 points loses nothing, and a part that
 *  falls into comparable pieces keeps them all.
 *  \param[in] points of the cloud
 *  \param[in] members positions in \a points of the part's points; at least 1
 *  \param[in] distance metres; 0 trims nothing
 *  \note Cost: O(n log n) as a rule, whatever the distance: points in one cell of a
 *  grid are all linked, so that cells are compared, and only those of different
 *  clusters. */
TrimmedPart
trimStrayPoints(const Points& points, const pcl::Indices& members, double distance);

} // namespace pcl_cid
