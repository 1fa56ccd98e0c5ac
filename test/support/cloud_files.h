/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Files for tests: a folder of their own, text, clouds with all kinds of fields.
 */

#pragma once

#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/cloud_points.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace pcl_cid::test {

/** \brief A new folder, removed with all that is in it. */
class TemporaryFolder {
public:
  TemporaryFolder();
  ~TemporaryFolder();

  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder&
  operator=(const TemporaryFolder&) = delete;

  /** \brief Path of a file in it. */
  std::string
  file(const std::string& name) const
  {
    return path_ + "/" + name;
  }

  /** \brief Names of what is in it, hidden files too, sorted. */
  std::vector<std::string>
  names() const;

private:
  std::string path_;
};

void
writeText(const std::string& path, const std::string& text);

std::string
readText(const std::string& path);

/** \brief Add a field with one value a point.
 *  \param[in] values one for each point
 *  \param[in,out] cloud without points it takes over their number */
template <typename Value>
void
appendField(const std::string& name,
            const std::vector<Value>& values,
            pcl::PCLPointCloud2& cloud)
{
  pcl::PCLPointCloud2 grown = cloud;
  if (cloud.width == 0) {
    grown.width = static_cast<std::uint32_t>(values.size());
    grown.height = 1;
  }
  pcl::PCLPointField field;
  field.name = name;
  field.offset = cloud.point_step;
  field.datatype = pcl::traits::asEnum_v<Value>;
  field.count = 1;
  grown.fields.push_back(field);
  grown.point_step += static_cast<std::uint32_t>(sizeof(Value));
  grown.row_step = grown.point_step * grown.width;
  grown.data.assign(std::size_t{grown.point_step} * values.size(), 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint8_t* const point = grown.data.data() + i * grown.point_step;
    std::copy_n(cloud.data.data() + i * cloud.point_step, cloud.point_step, point);
    std::memcpy(point + field.offset, &values[i], sizeof(Value));
  }
  cloud = grown;
}

/** \brief What is said of a file when it is read; "none" when nothing is.
 *  \param[in] begin what it begins with, and is left out: the name of the file */
std::string
complaintAbout(const std::string& begin, const std::function<void()>& read);

/** \brief The bytes of a field, point by point; empty when there is no such field. */
std::vector<std::uint8_t>
bytesOf(const pcl::PCLPointCloud2& cloud, const std::string& field);

/** \brief The values of a field; none when there is no such field. */
template <typename Value>
std::vector<Value>
valuesOf(const pcl::PCLPointCloud2& cloud, const std::string& field)
{
  const std::vector<std::uint8_t> bytes = bytesOf(cloud, field);
  std::vector<Value> values(bytes.size() / sizeof(Value));
  if (!values.empty())
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Value));
  return values;
}

/** \brief A cloud as PCL's own readers give it. */
struct LoadedByPCL {
  pcl::PCLPointCloud2 cloud;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
};

/** \brief Load a .pcd or .ply with pcl::PCDReader or pcl::PLYReader. */
LoadedByPCL
loadWithPCL(const std::string& path);

/** \brief A cloud named three.pcd, without labels and colors; its last point is
 *  invalid. */
LabelledCloud
threePoints();

/** \brief A small organized scan of a desk in front of a wall, 40 x 30 points of which
 *  some are invalid; fields x y z rgb, and a pose that is not the identity. */
LabelledCloud
deskScan();

/** \brief Which surface each point of the desk scan lies on: 1 wall, 2 desk, 3 box; 0
 *  for invalid points. */
std::vector<std::uint32_t>
deskLabels();

/** The layouts of the formats that are built in. */
inline const CloudLayout pcd_ascii{"PCD", CloudEncoding::ascii};
inline const CloudLayout pcd_binary{"PCD", CloudEncoding::binary};
inline const CloudLayout pcd_compressed{"PCD", CloudEncoding::compressed};
inline const CloudLayout ply_ascii{"PLY", CloudEncoding::ascii};
inline const CloudLayout ply_binary{"PLY", CloudEncoding::binary};

/** \brief Write a cloud in a layout. */
void
saveCloud(const std::string& path,
          const LabelledCloud& cloud,
          const CloudLayout& layout);

} // namespace pcl_cid::test
