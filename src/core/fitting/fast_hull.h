/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex hulls of few points, to compare hulls by.
 */

#pragma once

#include "hull/hull_mesh.h"

#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief A convex body by its vertices and its faces. */
struct FastHull {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<HalfSpace> faces;
  std::vector<Triangle> triangles; ///< one for each face
  std::vector<Triangle> neighbors; ///< the faces across its sides, in their order
  double volume = 0.0;             ///< cubic metres
};

/** \brief The hull of points that fill space, by quickhull (Barber, Dobkin and
 * Huhdanpaa 1996).
 *
 *  It is for choosing between hulls, of which tens of thousands are made: several times
 *  faster than convexHull(), which makes those that are handed out. A point may be
 *  outside of a face by 1e-9 of the extent.
 *  \return no face when the points are flat */
FastHull
fastHull(const std::vector<Eigen::Vector3d>& points);

} // namespace pcl_cid
