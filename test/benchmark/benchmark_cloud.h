/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The clouds that are measured: generated rooms and scans from files.
 */

#pragma once

#include <cstddef>
#include <string>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_cid::benchmarks {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** \brief How a generated room is turned into points. */
enum class RoomScan {
  even,  ///< independent points, uniform by area
  sensor ///< what a depth sensor with noise sees from four positions
};

/** \brief "even" or "sensor".
 *  \throws std::invalid_argument */
RoomScan
roomScanFromName(const std::string& name);

/** \brief A furnished room, always the same one.
 *  \return exactly \a points points, metres, the same on every machine */
Cloud::Ptr
makeRoomCloud(RoomScan scan, std::size_t points);

/** \brief A PCD file.
 *  \throws std::runtime_error when it cannot be read or has no finite point */
Cloud::Ptr
loadCloud(const std::string& path);

} // namespace pcl_cid::benchmarks
