/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Normals of the surface, without orientation, and how curved it is.
 */

#pragma once

#include "nearest_neighbors.h"

#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief The direction in which each point and its neighbors spread least (PCA), a
 * unit vector whose component of largest size is positive: a normal whose sign means
 *  nothing. 0 where points do not span a plane.
 *
 *  Points with equal coordinates get equal normals.
 *  \param[in] points of the neighbors
 *  \param[in] neighbors all of them count, and the point itself
 *  \param[in] execution threads and progress; never change a result
 *  \param[in] wanted for each point whether its normal is, 0 for the others; empty: all
 *  \throws CIDCancelled */
std::vector<Eigen::Vector3f>
surfaceNormals(const Points& points,
               const NearestNeighbors& neighbors,
               const ExecutionOptions& execution,
               const std::vector<bool>& wanted = {});

/** \brief What the surface is like at each point. */
struct SurfaceShape {
  std::vector<Eigen::Vector3f> normals; ///< see surfaceNormals()
  /** The share of the spread of a point and its neighbors that is along the normal, 0
   *  to 1/3, as PCL has it; 1 where there is no normal. */
  std::vector<float> curvatures;
};

/** \brief Normals as above, and the curvatures beside them. */
SurfaceShape
surfaceShape(const Points& points,
             const NearestNeighbors& neighbors,
             const ExecutionOptions& execution);

} // namespace pcl_cid
