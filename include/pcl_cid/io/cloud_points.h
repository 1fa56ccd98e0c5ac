/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The coordinates of a cloud, for the classes of pcl_cid.
 */

#pragma once

#include <pcl_cid/core/frame.h>
#include <pcl_cid/core/point_set.h>
#include <pcl_cid/io/labelled_cloud.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <cstddef>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_cid {

/** \brief Coordinates of a cloud, in a local frame. */
struct CloudPoints {
  /** One for each point of the cloud, in its order, with its width, height and pose;
   *  those that are not finite, too. */
  pcl::PointCloud<pcl::PointXYZ>::Ptr points;
  /** The local frame. Coordinates of type double are moved near 0, in double, so that
   *  float keeps their millimeters at UTM coordinates; those of type float stay where
   *  they are. */
  Frame frame;
  /** Points whose coordinates are all finite. */
  std::size_t finite = 0;
};

/** \brief The coordinates of a cloud.
 *  \throws CIDException when x, y or z is missing or neither float nor double */
PCL_CID_IO_EXPORT CloudPoints
pointsOf(const LabelledCloud& cloud);

/** \brief The finite points of a cloud, as the classes of pcl_cid gather them. */
PCL_CID_IO_EXPORT PointSet
finitePoints(const pcl::PointCloud<pcl::PointXYZ>& cloud);

/** \brief A cloud with the fields x, y and z, and the width, height and pose of these
 *  points. It has no name yet. */
PCL_CID_IO_EXPORT LabelledCloud
toLabelledCloud(const pcl::PointCloud<pcl::PointXYZ>& points);

} // namespace pcl_cid
