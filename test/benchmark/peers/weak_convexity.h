/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Weakly convex components of an oriented surface (WCSeg-like).
 */

#pragma once

#include "surface_graph.h"

#include <pcl_cid/core/distance_field.h>

#include <cstddef>
#include <vector>

namespace pcl_cid::benchmarks {

/** \brief Settings of findWeaklyConvexSegments(); the defaults are those of sources
 *  named in doc/peers.md where one is known. */
struct WeakConvexityOptions {
  std::size_t patches = 200;      ///< of the over-segmentation
  std::size_t sight_samples = 10; ///< points of a patch that look at other patches
  double coplanar = 0.01;         ///< see LineOfSight
  double reach = 0.0;             ///< see LineOfSight; above 0
  /** Components grow while this share of the lines between them is free: tried from
   *  `first_visibility` down to `last_visibility` in steps of `visibility_step`. */
  double first_visibility = 0.95;
  double last_visibility = 0.8;
  double visibility_step = 0.05;
  bool merge_by_thickness = true; ///< the last stage
  double concave_share = 0.85;    ///< concave seams for each convex one, at most
  double unlike_share = 0.12;   ///< of the largest distance of shape diameters, at most
  double flat_visibility = 0.4; ///< for a flat component with a concave seam, at least
  std::size_t least_points = 20; ///< smaller components are dropped
};

/** \brief WCSeg-like segmentation: O. van Kaick, N. Fish, Y. Kleiman, S. Asafi, D.
 *  Cohen-Or, "Shape Segmentation by Approximate Convexity Analysis", ACM Transactions
 *  on Graphics 34(1), 2014. Not their program: doc/peers.md says what is as published
 *  and what is approximate.
 *
 *  1. The graph of neighbors, weighted by how the surface bends, is cut into patches.
 *  2. For each two patches: the share of lines between them that are free.
 *  3. Neighboring components are joined, those that see most of each other first, as
 *  long as enough of the lines between them are free: weakly convex components.
 *  4. Neighboring components of like thickness (shape diameter) whose common seam is
 *  mostly convex are joined; flat ones join the neighbor with the most convex seam.
 *
 *  \param[in] surface points with normals to the outside; at least 1
 *  \param[in] field of the points
 *  \param[in] neighbors see nearestNeighbors()
 *  \return number of the segment of each point, from 0 without gaps; -1 for points of
 *  segments that were dropped */
std::vector<int>
findWeaklyConvexSegments(const OrientedPoints& surface,
                         const DistanceField& field,
                         const std::vector<std::vector<int>>& neighbors,
                         const WeakConvexityOptions& options);

} // namespace pcl_cid::benchmarks
