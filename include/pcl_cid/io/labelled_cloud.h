/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds from and to files: all fields, the order and the pose kept.
 */

#pragma once

#include <pcl_cid/core/color.h>
#include <pcl_cid/core/point_set.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include <pcl/PCLPointCloud2.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pcl_cid {

/** \brief How a cloud is laid out in a file. */
enum class CloudFormat {
  pcd_ascii,
  pcd_binary,
  pcd_binary_compressed,
  ply_ascii,
  ply_binary
};

/** \brief Type of a `label` field: unsigned, signed or float, 4 bytes each. Some
 *  programs cannot read the first, which is the default. */
enum class LabelType { U4, I4, F4 };

/** \brief A cloud as it stands in a file. */
struct LabelledCloud {
  /** The file, for messages. */
  std::string name;
  CloudFormat format = CloudFormat::pcd_binary_compressed;
  /** Every field of every point, in the order of the file, without padding; `width` and
   *  `height` as in the file. */
  pcl::PCLPointCloud2 fields;
  Eigen::Vector4f sensor_origin = Eigen::Vector4f::Zero();
  Eigen::Quaternionf sensor_orientation = Eigen::Quaternionf::Identity();

  std::size_t
  size() const
  {
    return static_cast<std::size_t>(fields.width) * fields.height;
  }
};

/** \brief Coordinates of a cloud. */
struct CloudPoints {
  /** One for each point, relative to the offset; those that are not finite, too. */
  pcl::PointCloud<pcl::PointXYZ>::Ptr points;
  /** What was subtracted, in double, from coordinates of type double, so that float
   *  keeps their millimetres at UTM coordinates; 0 for coordinates of type float. */
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  /** Points whose coordinates are all finite. */
  std::size_t finite = 0;
};

/** \brief Read a PCD (ascii, binary, compressed) or PLY (ascii, binary) file; which of
 *  them it is, its content says.
 *
 *  Stricter than PCL's readers, and silent: whatever does not fit the header is an
 *  error. Fields get the names that PCL gives them: red, green and blue of a PLY become
 *  `rgb` (`rgba` with alpha), nx, ny and nz become `normal_x`, `normal_y` and
 *  `normal_z`. The pose and the width and height of a PLY are those of its `camera`
 *  element, where PCL writes them. Faces of a PLY are passed over, and so is padding
 *  (fields named `_`) of a PCD.
 *  \throws CIDException when the file cannot be opened, is empty, truncated, damaged or
 *  of another format, holds no point, or has no single x, y and z */
PCL_CID_IO_EXPORT LabelledCloud
readCloud(const std::string& path);

/** \brief The coordinates of a cloud.
 *  \throws CIDException when x, y or z is missing or neither float nor double */
PCL_CID_IO_EXPORT CloudPoints
pointsOf(const LabelledCloud& cloud);

/** \brief Whether the cloud has a field of that name. */
PCL_CID_IO_EXPORT bool
hasField(const LabelledCloud& cloud, const std::string& name);

/** \brief The finite points of a cloud, as the classes of pcl_cid gather them. */
PCL_CID_IO_EXPORT PointSet
finitePoints(const pcl::PointCloud<pcl::PointXYZ>& cloud);

/** \brief Any field as labels, converted by its declared type; 0 where \a points are
 *  not finite.
 *  \param[in] field its name
 *  \param[in] points the coordinates of the cloud
 *  \throws CIDException when there is no such field (the message lists those there
 *  are), when it has several values a point, or when the value of a finite point is not
 *  a whole number from 0 to 4294967295 */
PCL_CID_IO_EXPORT std::vector<std::uint32_t>
labelsOf(const LabelledCloud& cloud,
         const std::string& field,
         const CloudPoints& points);

/** \brief The colours of a cloud: its field `rgb`, or else `rgba`, packed as PCL packs
 *  them.
 *  \return one for each point
 *  \throws CIDException when it has neither (the message lists the fields that there
 *  are), or when the field is not one value of 4 bytes */
PCL_CID_IO_EXPORT std::vector<ColorRGB>
colorsOf(const LabelledCloud& cloud);

/** \brief Give the cloud a field of labels, in the place of one that it has, else after
 *  all other fields.
 *  \param[in] labels one for each point
 *  \param[in] type of the field
 *  \param[in,out] cloud unchanged when an exception is thrown
 *  \param[in] name of the field
 *  \throws CIDException when a label does not fit the type (F4 holds whole numbers up
 *  to 2^24) or there is not one for each point */
PCL_CID_IO_EXPORT void
setLabels(const std::vector<std::uint32_t>& labels,
          LabelType type,
          LabelledCloud& cloud,
          const std::string& name = "label");

/** \brief The format that a cloud is written in, by the name of the file: ascii stays
 *  ascii, binary PCD stays binary, all else becomes binary compressed for `.pcd` and
 *  binary for `.ply`.
 *  \param[in] path ends in .pcd or .ply, in any case
 *  \throws CIDException when it does not */
PCL_CID_IO_EXPORT CloudFormat
formatFor(const std::string& path, CloudFormat source);

/** \brief Write a cloud; a test of the stream's state afterwards says whether it
 *  worked.
 *
 *  PCD keeps every bit of every field. In ascii, `rgb` of type F is written as type U,
 *  as PCL does. PLY has the names that readCloud() reads, one property for each value
 *  of a field with several, 8 bits for each colour (so `rgb` loses its unused fourth
 *  byte), and the pose as axes.
 *  \throws CIDException for 8-byte integers in PLY, which has no type for them */
PCL_CID_IO_EXPORT void
writeCloud(std::ostream& stream, const LabelledCloud& cloud, CloudFormat format);

} // namespace pcl_cid
