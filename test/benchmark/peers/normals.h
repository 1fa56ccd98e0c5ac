/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Normals, as a user of PCL estimates and orients them.
 */

#pragma once

#include "../benchmark_cloud.h"

#include <vector>

#include <Eigen/Core>

namespace pcl_cid::benchmarks {

/** \brief pcl::NormalEstimation from so many neighbors, with their curvatures. */
pcl::PointCloud<pcl::Normal>::Ptr
estimateNormals(const Cloud::ConstPtr& cloud, int neighbors);

/** \brief Which side of a surface is the outside. */
enum class Orientation {
  viewpoint, ///< that of the sensor which most likely saw the point
  center,    ///< that of the middle of the bounding box, for rooms seen from inside
  tree       ///< a spanning tree of least turns, from the highest point, which looks up
};

/** \brief Turn normals to the outside.
 *
 *  `viewpoint`: a sensor sees a surface in proportion to the cosine of incidence and to
 *  the inverse square of the distance, so the viewpoint where that is largest decides.
 *  `tree`: H. Hoppe et al., "Surface Reconstruction from Unorganized Points", 1992; in
 *  every connected piece of the graph the highest point looks up.
 *  \param[in] points the points
 *  \param[in] graph neighbors of each point, symmetric; for `tree`
 *  \param[in] viewpoints at least one; for `viewpoint`
 *  \param[in,out] normals unit vectors, one for each point */
void
orientNormals(const std::vector<Eigen::Vector3f>& points,
              const std::vector<std::vector<int>>& graph,
              const std::vector<Eigen::Vector3f>& viewpoints,
              Orientation orientation,
              std::vector<Eigen::Vector3f>& normals);

} // namespace pcl_cid::benchmarks
