/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A simulated scan as a cloud of PCL.
 */

#include "scan_cloud.h"

#include <cstdint>
#include <cstring>

namespace pcl_cid::test {
namespace {

/// One point, as it lies in a file.
struct FilePoint {
  float x;
  float y;
  float z;
  std::uint32_t label;
  std::uint32_t semantic;
};

/// Its last four bytes, where there are colors.
struct ColoredFilePoint {
  FilePoint point;
  std::uint32_t rgb;
};

std::uint32_t
packed(const ColorRGB& color)
{
  return std::uint32_t{color.r} << 16 | std::uint32_t{color.g} << 8 | color.b;
}

pcl::PCLPointField
makeField(const std::string& name, std::uint32_t offset, std::uint8_t datatype)
{
  pcl::PCLPointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = datatype;
  field.count = 1;
  return field;
}

} // namespace

pcl::PCLPointCloud2
cloudOf(const LabelledScan& scan)
{
  using Field = pcl::PCLPointField;
  pcl::PCLPointCloud2 cloud;
  cloud.fields = {makeField("x", offsetof(FilePoint, x), Field::FLOAT32),
                  makeField("y", offsetof(FilePoint, y), Field::FLOAT32),
                  makeField("z", offsetof(FilePoint, z), Field::FLOAT32),
                  makeField("label", offsetof(FilePoint, label), Field::UINT32),
                  makeField("semantic", offsetof(FilePoint, semantic), Field::UINT32)};
  const bool is_colored = !scan.colors.empty();
  if (is_colored)
    cloud.fields.push_back(
        makeField("rgb", offsetof(ColoredFilePoint, rgb), Field::FLOAT32));
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(scan.points.size());
  cloud.point_step = is_colored ? sizeof(ColoredFilePoint) : sizeof(FilePoint);
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.is_dense = 1;
  cloud.data.resize(cloud.row_step);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3f& p = scan.points[i];
    const ColoredFilePoint point{
        {p.x(), p.y(), p.z(), scan.instance[i], scan.semantic[i]},
        is_colored ? packed(scan.colors[i]) : 0};
    std::memcpy(&cloud.data[i * cloud.point_step], &point, cloud.point_step);
  }
  return cloud;
}

} // namespace pcl_cid::test
