/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex hulls of points that fill space, by pcl::ConvexHull.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>

#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief The hull as qhull finds it: triangles outward, some of them perhaps
 *  degenerate.
 *
 *  qhull gets the points in float, scaled to a cube about their principal axes: each
 *  vertex is off by at most 6e-8 of the extent along each axis, so that a thin slab
 *  keeps its thickness, and among themselves the vertices are convex to the precision
 *  of double.
 *  \param[in] points at least 1
 *  \return no triangles when the points are flat within 1e-6 of their extents, or when
 *  qhull fails
 *  \throws std::bad_alloc when qhull lacks memory and says so; PCL does not let it at
 *  every moment, and ends the process then
 *  \note Prints nothing: qhull, which explains itself on stderr, never sees flat
 *  points. */
TriangleMesh
quickHull(const std::vector<Eigen::Vector3d>& points);

} // namespace pcl_cid
