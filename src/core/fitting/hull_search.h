/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID of a set, by branch and bound over its hull.
 */

#pragma once

#include "hull/fast_hull.h"

#include <pcl_cid/core/distance_field.h>
#include <pcl_cid/core/hull_cid.h>

namespace pcl_cid {

/** \brief CID_h of a hull, to within a tolerance; the search ends as soon as it is
 * known to exceed \a enough. */
HullCID
searchHull(const FastHull& hull,
           const DistanceField& field,
           double tolerance,
           double enough);

/** \brief Whether some place of a hull is farther than this from the surface. False is
 *  certain; true may also be said of a hull that comes within 5 % of it. */
bool
straysFarther(const FastHull& hull, const DistanceField& field, double most);

} // namespace pcl_cid
