/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The least width of a convex polytope, over all directions.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>

#include <limits>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief A direction, and the width of a body along it. */
struct Width {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  double width = std::numeric_limits<double>::infinity();
};

/** \brief The direction in which a closed convex mesh is thinnest: its width is the
 *  smallest distance of two parallel planes that the mesh fits between.
 *
 *  They touch it in a face and a vertex, or in two edges.
 *  \note Cost: for each face, and for few of the edges, a walk over neighboring
 *  vertices. */
Width
leastWidth(const TriangleMesh& hull);

} // namespace pcl_cid
