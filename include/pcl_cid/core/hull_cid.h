/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID of a set: how far its convex hull strays from the surface.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/distance_field.h>
#include <pcl_cid/pcl_cid_export.h>

#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief Certified bounds of a CID_h: low <= CID_h <= high, metres. */
struct HullCID {
  double low = 0.0;  ///< d(x; S) of some place x of the hull
  double high = 0.0; ///< no place of the hull is farther from S
};

/** \brief CID_h(G | S) = max of d(x; S) over all x in the convex hull of G (*ours*):
 * the question of Eq. 1, asked of a set instead of a segment.
 *
 *  Of two points it is Eq. 1. It never falls when G grows, bounds the CID_p of every
 *  pair in G, and moves and scales with the points.
 *  Branch and bound: the hull is divided into tetrahedra; since d is 1-Lipschitz, one
 *  whose center c has d(c; S) plus its radius below the best is out.
 *  \param[in] points G, at least one, metres, in the frame of the surface
 *  \param[in] field the surface S
 *  \param[in] tolerance high - low at most, metres, above 0
 *  \throws CIDException without points, for one that is not finite, or a tolerance that
 *  is not above 0
 *  \note Cost: a hull, and O((extent / tolerance)^3) queries at worst; a few hundred
 *  where the hull strays far at few places. Thread safety: may run concurrently. */
PCL_CID_EXPORT HullCID
hullCID(const std::vector<Eigen::Vector3d>& points,
        const DistanceField& field,
        double tolerance);

} // namespace pcl_cid
