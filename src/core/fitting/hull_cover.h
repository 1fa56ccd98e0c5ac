/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The free places that a hull takes from a robot.
 */

#pragma once

#include "free_space.h"
#include "hull/fast_hull.h"

#include <functional>
#include <vector>

namespace pcl_cid {

/** \brief Visit the free places nearer to a hull than \a radius: those where a ball of
 *  this radius would touch it, as ranges that ascend.
 *
 *  A place counts as near when it is within the radius of the plane of every face, and
 *  of the plane that bevels every sharp edge: what lies between that and the exact
 *  distance are slivers at corners.
 *  \param[in] visit returns whether to go on
 *  \return whether all were visited */
bool
visitPlacesNear(const FastHull& hull,
                const FreeSpace& space,
                double radius,
                const std::function<bool(const PlaceRange&)>& visit);

/** \brief The same as a list. */
std::vector<PlaceRange>
placesNear(const FastHull& hull, const FreeSpace& space, double radius);

} // namespace pcl_cid
