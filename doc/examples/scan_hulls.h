/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan from a file, and its convex hulls.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/settings.h>

#include <string>
#include <vector>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

namespace planning {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** \brief The finite points of a PCD file.
 *  \throws std::runtime_error when it cannot be read or has none */
Cloud::Ptr
loadFinitePoints(const std::string& path);

/** \brief Which hulls to make. */
struct HullOptions {
  /** More parts usually leave more of the free space free, and take longer to look at.
   */
  int number_of_parts = 60;
  /** By hull, parts are chosen so that the robot can use as much free space as can be.
   */
  pcl_cid::MergingRule merging = pcl_cid::MergingRule::hull;
  /** Of the robot, metres. */
  double robot_radius = 0.0;
  /** The scan is what one camera saw from the origin: only there is free space. */
  bool has_one_view = false;
};

/** \brief Hulls that contain all points of a scan. */
std::vector<pcl_cid::ConvexPart>
hullsOf(const Cloud::ConstPtr& scan, const HullOptions& options);

/** \brief How far a point of the scan may stand out of its hull, metres. */
double
toleranceOf(const std::vector<pcl_cid::ConvexPart>& parts);

/** \brief The box around a scan. */
Eigen::AlignedBox3d
boxOf(const Cloud& scan);

} // namespace planning
