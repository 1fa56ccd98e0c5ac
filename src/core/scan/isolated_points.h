/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Isolated points: those with too few others near them.
 */

#pragma once

#include "nearest_neighbors.h"

namespace pcl_cid {

/** Points are near when they are within this many local spacings. */
constexpr float isolation_radius = 2.0f;

/** \brief The points that have too few others near them: outliers, which a
 *  farthest-first traversal would pick as seeds first (*ours*).
 *
 *  What is near depends on the neighbors: within `isolation_radius` times the median of
 *  their distances to their own eighth neighbors. So the points of a wall that is far
 *  from the sensor, and sparse, are not isolated among themselves.
 *  (pcl::RadiusOutlierRemoval has one radius for a whole cloud, and
 *  pcl::StatisticalOutlierRemoval one threshold of mean distance: both take such a wall
 *  for outliers before the stray points near the sensor.)
 *  \param[in] points those that the neighbors were found in
 *  \param[in] neighbors of the points
 *  \param[in] least a point with fewer near points than this is isolated; 1 to
 *  NearestNeighbors::most_near, 0 for never
 *  \return ascending; never all of the points, as those with the nearest neighbors are
 *  not isolated; none where there are fewer than nine places with points
 *  \throws CIDException when \a least is out of its range */
pcl::Indices
isolatedPoints(const Points& points, const NearestNeighbors& neighbors, int least);

} // namespace pcl_cid
