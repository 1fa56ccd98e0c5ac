/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Regions of a surface where normals are alike, by region growing.
 */

#pragma once

#include "base/progress.h"
#include "scan/surface_graph.h"
#include "scan/surface_normals.h"

#include <cstddef>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief Regions of a surface: each point is in one of them, or in none. */
struct SmoothRegions {
  std::vector<pcl::index_t> of_points; ///< the number of the region of each, or -1
  std::vector<std::size_t> sizes;      ///< in points, by number
};

/** \brief Region growing (*ours*, after Rabbani et al. 2006 and pcl::RegionGrowing):
 *  the flattest point that is in no region yet begins one; whatever edges of the graph
 *  join with it, and is in none, joins when its normal is within 8 degrees of that of
 *  the first point.
 *
 *  At equal curvature the point of lowest index is first. A point without normal is
 *  like others without, so that points on a straight line are a region, too.
 *  \param[in] shape of the points of the graph
 *  \return regions that have all points
 *  \throws CIDCancelled
 *  \note Cost: O(N log N). */
SmoothRegions
growRegions(const SurfaceGraph& graph, const SurfaceShape& shape, Progress& progress);

/** \brief The largest regions, larger ones first, at equal size the one that was first.
 *  \param[in] most how many to keep */
SmoothRegions
largestRegions(const SmoothRegions& regions, std::size_t most);

} // namespace pcl_cid
