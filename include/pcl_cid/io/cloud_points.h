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

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

namespace pcl_cid {

/** \brief Coordinates of a cloud, in a local frame. */
struct PCL_CID_IO_EXPORT CloudPoints {
  /** One for each point of the cloud, in its order, with its width, height and pose;
   *  those that are not finite, too. */
  pcl::PointCloud<pcl::PointXYZ>::Ptr points;
  /** The local frame. Coordinates of type double (or integers of 4 bytes and more) are
   *  moved near 0, in double, so that float keeps their millimeters at UTM coordinates;
   *  those of type float stay where they are. Single points far from all others have no
   *  say in it. */
  Frame frame;
  /** Points whose coordinates are all finite. */
  std::size_t finite = 0;
  /** Metres that a unit of the coordinates stands for in files that go with the scan,
   *  such as tables of seeds: LabelledCloud::scale. The points are in metres. */
  double metres_per_unit = 1.0;
  /** How long the cloud is along each axis without a twentieth of its points at either
   *  end, from a sample; infinite where no point of that is finite. */
  Eigen::Vector3d extent = Eigen::Vector3d::Zero();
  /** Index in the file of each point, ascending, where these are only some of its
   * points (see VoxelCloud); empty: they are all of them. */
  pcl::Indices source = {};
  /** How many points the file has, where these are only some of them. */
  std::size_t points_in_file = 0;

  /** \brief How many points the file has. */
  std::size_t
  sizeOfFile() const
  {
    return source.empty() ? points->size() : points_in_file;
  }

  /** \brief The index in the file of a point. */
  pcl::index_t
  indexInFile(pcl::index_t point) const
  {
    return source.empty() ? point : source[static_cast<std::size_t>(point)];
  }

  /** \brief The point with an index in the file, -1 when it is none of these. */
  pcl::index_t
  find(std::int64_t index_in_file) const;
};

/** \brief The coordinates of a cloud as they stand in its file, times its scale:
 *  metres. */
class PCL_CID_IO_EXPORT FileCoordinates {
public:
  /** \param[in] cloud must live as long as this, and keep its fields
   *  \throws CIDException when x, y or z is missing or has several values */
  explicit FileCoordinates(const LabelledCloud& cloud);

  /** \brief Of a point, by its index; they may be NaN or infinite. */
  Eigen::Vector3d
  operator[](std::size_t point) const;

  /** \brief The type of the coordinates: one that float cannot hold where there is one
   *  among them. */
  std::uint8_t
  datatype() const;

private:
  const LabelledCloud* cloud_;
  std::array<pcl::PCLPointField, 3> fields_;
};

/** \brief Which points of a cloud count. */
struct PointOptions {
  /** At least 10 points exactly at (0, 0, 0), or exactly at the sensor, are what did
   * not return: they become NaN, unless this is set or there are no others. */
  bool keep_zeros = false;
  /** Called with one sentence, with the name of the cloud, for each thing that a user
   *  should know; may be empty. */
  RemarkCallback remark;
};

/** \brief The coordinates of a cloud.
 *  \throws CIDException when x, y or z is missing, and for a finite coordinate beyond
 *  1e15, with the number of its point */
PCL_CID_IO_EXPORT CloudPoints
pointsOf(const LabelledCloud& cloud, const PointOptions& options = {});

/** \brief Bring the coordinates of a cloud, and the place of its sensor, from the unit
 *  of its file to metres. Its scale is 1 then, and coordinates that are no float become
 *  double.
 *  \throws CIDException when x, y or z is missing */
PCL_CID_IO_EXPORT void
convertToMetres(LabelledCloud& cloud);

/** \brief The finite points of a cloud, as the classes of pcl_cid gather them. */
PCL_CID_IO_EXPORT PointSet
finitePoints(const pcl::PointCloud<pcl::PointXYZ>& cloud);

/** \brief A cloud with the fields x, y and z, and the width, height and pose of these
 *  points. It has no name yet. */
PCL_CID_IO_EXPORT LabelledCloud
toLabelledCloud(const pcl::PointCloud<pcl::PointXYZ>& points);

} // namespace pcl_cid
