/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The CID of one segment: whether it reaches a limit, bounds of it, its value.
 */

#pragma once

#include "segment_samples.h"

#include <pcl_cid/core/distance_field.h>

#include <cstddef>
#include <optional>

namespace pcl_cid {

/** \brief A segment whose CID is asked for. */
struct Segment {
  const Eigen::Vector3f& p;
  const Eigen::Vector3f& q;
  bool between_surface_points; ///< d is known to be 0 at both ends
};

/** \brief Whether the CID of a segment reaches a limit, which is cheaper than the CID.
 *  \param[in,out] hint the sample to look at first, since one that is far from the
 *  surface decides; on return the one that did, which is a good hint for the next
 *  segment close to this one
 *  \return at least \a limit and at most the CID; nothing when the CID is less */
std::optional<float>
findCIDAtLeast(const DistanceField& field,
               const Segment& segment,
               const SampleOrder& order,
               float limit,
               std::size_t& hint);

/** \brief How small an upper bound shall be. */
enum class Tightness {
  looks, ///< exact distances only where they decide whether it is below a limit
  exact, ///< the CID itself
};

/** \brief An upper bound of the CID of a segment; \a limit when the CID is not below
 *  that.
 *  \param[in,out] hint as for findCIDAtLeast() */
float
boundPointCID(const DistanceField& field,
              const Segment& segment,
              const SampleOrder& order,
              float limit,
              Tightness tightness,
              std::size_t& hint);

/** \brief pointCID() with the order of the samples at hand, and a hint. */
float
pointCID(const DistanceField& field,
         const Segment& segment,
         const SampleOrder& order,
         float limit,
         std::size_t& hint);

} // namespace pcl_cid
