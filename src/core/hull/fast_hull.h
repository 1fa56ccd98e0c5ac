/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex hulls of few points, to compare hulls by, and which points they need.
 */

#pragma once

#include "hull_mesh.h"

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief The hull of some points, with what comparing hulls asks for. */
struct FastHull : TriangleMesh {
  std::vector<HalfSpace> faces;    ///< one for each triangle
  std::vector<Triangle> neighbors; ///< the triangles across the sides of each, in order
  double volume = 0.0;             ///< cubic metres
  /** Which of the points each vertex is; none where rounding has spoiled the hull and
   *  vertices are no points. */
  std::vector<std::uint32_t> corners;
};

/** \brief The hull of points that fill space, by quickhull (Barber, Dobkin and
 * Huhdanpaa 1996).
 *
 *  It is for choosing between hulls, of which tens of thousands are made: several times
 *  faster than convexHull(), which makes those that are handed out. No point is outside
 *  of a face by more than 1e-8 of the extent. Where rounding spoils that, it is
 *  convexHull() after all, with its tolerance, or else the box of the points.
 *  \return no face when the points are flat */
FastHull
fastHull(const std::vector<Eigen::Vector3d>& points);

/** \brief The volume of fastHull(), cubic metres, unchecked: for choosing only. */
double
hullVolume(const std::vector<Eigen::Vector3d>& points);

} // namespace pcl_cid
