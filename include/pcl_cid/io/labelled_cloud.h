/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A cloud as it stands in a file, and its labels and colors.
 */

#pragma once

#include <pcl_cid/core/color.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/cloud_format.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pcl_cid {

struct CloudPoints;

/** \brief Type of a field of labels: unsigned, signed or float, 4 bytes each. Some
 *  programs cannot read the first, which is the default. */
enum class LabelType { U4, I4, F4 };

/** \brief A cloud as it stands in a file. Reading, writing: cloud_formats.h. */
struct LabelledCloud {
  /** The file, for messages. */
  std::string name;
  /** How the file is laid out. */
  CloudLayout layout;
  /** Every field of every point, in the order of the file, without padding; `width` and
   *  `height` as in the file. */
  pcl::PCLPointCloud2 fields;
  /** Metres that a unit of its coordinates stands for, setting::scale. The fields and
   *  the sensor's place are in the unit of the file; pointsOf() gives metres. */
  double scale = setting::scale.initial;
  /** Where the sensor was: x, y, z, and 0. */
  Eigen::Vector4f sensor_origin = Eigen::Vector4f::Zero();
  /** How the sensor was turned. */
  Eigen::Quaternionf sensor_orientation = Eigen::Quaternionf::Identity();
  /** One sentence, without the name, for each thing that was passed over or assumed
   *  when the file was read. */
  std::vector<std::string> remarks;
  /** Where it is a block of a larger one, the number of points before it. */
  std::size_t first_point = 0;

  /** \brief Number of points. */
  std::size_t
  size() const
  {
    return static_cast<std::size_t>(fields.width) * fields.height;
  }
};

/** \brief Whether the cloud has a field of that name. */
PCL_CID_IO_EXPORT bool
hasField(const LabelledCloud& cloud, const std::string& name);

/** \brief Any field as labels, converted by its declared type.
 *  \param[in] cloud has the field
 *  \param[in] field its name
 *  \param[in] points the coordinates of the cloud
 *  \param[in] remark called with one sentence when points have none; may be empty
 *  \return one label for each point; 0 for those that are not finite, and where the
 *  field is -1 or NaN
 *  \throws CIDException when there is no such field (the message lists those there
 *  are), when it has several values for each point, or when the value of a finite point
 *  is another number than these and no whole number from 0 to 4294967295 */
PCL_CID_IO_EXPORT std::vector<std::uint32_t>
labelsOf(const LabelledCloud& cloud,
         const std::string& field,
         const CloudPoints& points,
         const RemarkCallback& remark = {});

/** \brief The colors of a cloud: its field `rgb`, or else `rgba`, packed as PCL packs
 *  them; or else three fields `red`, `green`, `blue`, or `r`, `g`, `b`, in small
 *  letters or not: bytes, or 16 bits, or other numbers from 0 to 1, to 255 where one is
 *  above 1.
 *  \return one for each point
 *  \throws CIDException when it has none of these (the message lists the fields that
 *  there are), when the packed field is not one value of 4 bytes, or when a channel of
 *  a finite point is out of its range */
PCL_CID_IO_EXPORT std::vector<ColorRGB>
colorsOf(const LabelledCloud& cloud);

/** \brief Whether the cloud has fields that colorsOf() takes. */
PCL_CID_IO_EXPORT bool
hasColors(const LabelledCloud& cloud);

/** \brief Refuse labels that do not fit a type: U4 goes to 2^32 - 1, I4 to 2^31 - 1, F4
 *  to 2^24.
 *  \throws CIDException with the first label that does not */
PCL_CID_IO_EXPORT void
requireLabelsFit(const std::vector<std::uint32_t>& labels, LabelType type);

/** \brief Give the cloud a field of labels: in the place of the one of this name, or
 *  after all other fields when there is none.
 *  \param[in] labels one for each point
 *  \param[in] type of the field
 *  \param[in,out] cloud unchanged when an exception is thrown
 *  \param[in] name of the field
 *  \throws CIDException when a label does not fit the type (see requireLabelsFit()) or
 *  there is not one for each point */
PCL_CID_IO_EXPORT void
setLabels(const std::vector<std::uint32_t>& labels,
          LabelType type,
          LabelledCloud& cloud,
          const std::string& name = "label");

} // namespace pcl_cid
