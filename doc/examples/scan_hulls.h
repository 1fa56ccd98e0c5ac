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

/** \brief Hulls that contain all points of a scan. */
std::vector<pcl_cid::ConvexPart>
hullsOf(const Cloud::ConstPtr& scan, int number_of_parts);

/** \brief How far a point of the scan may stand out of its hull, metres. */
double
toleranceOf(const std::vector<pcl_cid::ConvexPart>& parts);

/** \brief The box around a scan. */
Eigen::AlignedBox3d
boxOf(const Cloud& scan);

} // namespace planning
