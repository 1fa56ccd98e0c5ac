/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex hulls without degenerate triangles.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>

#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief Least height of a triangle, as a share of the diagonal. */
constexpr double least_triangle_height = 1e-6;

/** \brief The hull of points that fill space, closed, with no triangle lower than
 *  least_triangle_height.
 *
 *  The vertex that makes a triangle lower lies almost on the line through the other
 *  two, and is left out. The hull then misses points by about that height: by no more
 *  than half of hull_tolerance, or none is returned.
 *  \return no triangles when there is no such hull */
TriangleMesh
convexHull(const std::vector<Eigen::Vector3d>& points);

} // namespace pcl_cid
