/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The coordinates of a cloud, for the classes of pcl_cid.
 */

#include "field_values.h"
#include "required_fields.h"

#include <pcl_cid/io/cloud_points.h>

#include <cmath>
#include <numeric>
#include <utility>

namespace pcl_cid {
namespace {

/** Coordinates as they stand in the file, in fields that are all float or double. */
class CoordinateReading {
public:
  explicit CoordinateReading(const LabelledCloud& cloud)
  : cloud_(cloud)
  , fields_{
        requireField(cloud, "x"), requireField(cloud, "y"), requireField(cloud, "z")}
  {
  }

  Eigen::Vector3d
  point(std::size_t i) const
  {
    const std::uint8_t* const bytes =
        cloud_.fields.data.data() + i * cloud_.fields.point_step;
    Eigen::Vector3d p;
    for (int axis = 0; axis < 3; ++axis) {
      const pcl::PCLPointField& field = fields_[axis];
      p[axis] = field.datatype == pcl::PCLPointField::FLOAT32
                    ? static_cast<double>(loadValue<float>(bytes + field.offset))
                    : loadValue<double>(bytes + field.offset);
    }
    return p;
  }

  bool
  areDouble() const
  {
    for (const pcl::PCLPointField& field : fields_)
      if (field.datatype == pcl::PCLPointField::FLOAT64)
        return true;
    return false;
  }

  /** An origin for coordinates that are about as small as the cloud: the center of its
   *  bounding box, rounded to steps of about its size; 0 on an axis where the cloud is
   *  near 0 anyway. */
  Eigen::Vector3d
  middle() const
  {
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < cloud_.size(); ++i)
      if (const Eigen::Vector3d p = point(i); p.allFinite())
        box.extend(p);
    if (box.isEmpty())
      return Eigen::Vector3d::Zero();
    const double size = box.sizes().maxCoeff();
    const double step = size > 0.0 ? std::exp2(std::ceil(std::log2(size))) : 1.0;
    return box.center().unaryExpr([step](double center) {
      return std::abs(center) < 2.0 * step ? 0.0 : std::round(center / step) * step;
    });
  }

private:
  const LabelledCloud& cloud_;
  const pcl::PCLPointField fields_[3];
};

} // namespace

CloudPoints
pointsOf(const LabelledCloud& cloud)
{
  requireCoordinates(cloud);
  const CoordinateReading coordinates(cloud);
  CloudPoints result;
  if (coordinates.areDouble())
    result.frame.origin = coordinates.middle();
  result.points.reset(new pcl::PointCloud<pcl::PointXYZ>);
  result.points->reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f p = result.frame.toLocal(coordinates.point(i)).cast<float>();
    result.points->emplace_back(p.x(), p.y(), p.z());
    result.finite += p.allFinite() ? 1 : 0;
  }
  result.points->width = cloud.fields.width;
  result.points->height = cloud.fields.height;
  result.points->is_dense = result.finite == cloud.size();
  result.points->sensor_origin_.head<3>() =
      result.frame.toLocal(cloud.sensor_origin.head<3>().cast<double>()).cast<float>();
  result.points->sensor_orientation_ = cloud.sensor_orientation;
  return result;
}

PointSet
finitePoints(const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  Points points;
  points.reserve(cloud.size());
  for (const pcl::PointXYZ& point : cloud)
    points.emplace_back(point.x, point.y, point.z);
  pcl::Indices source(cloud.size());
  std::iota(source.begin(), source.end(), 0);
  return PointSet(std::move(points), std::move(source));
}

LabelledCloud
toLabelledCloud(const pcl::PointCloud<pcl::PointXYZ>& points)
{
  LabelledCloud cloud;
  for (const char* const axis : {"x", "y", "z"})
    addField(axis, pcl::PCLPointField::FLOAT32, 1, cloud.fields);
  cloud.fields.width = points.width;
  cloud.fields.height = points.height;
  cloud.fields.row_step = cloud.fields.point_step * points.width;
  cloud.fields.data.resize(points.size() * cloud.fields.point_step);
  std::uint8_t* bytes = cloud.fields.data.data();
  for (const pcl::PointXYZ& point : points) {
    std::memcpy(bytes, point.data, cloud.fields.point_step);
    bytes += cloud.fields.point_step;
  }
  cloud.sensor_origin = points.sensor_origin_;
  cloud.sensor_orientation = points.sensor_orientation_;
  return cloud;
}

} // namespace pcl_cid
