/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The coordinates of a cloud, for the classes of pcl_cid.
 */

#include "base/sentence.h"
#include "bulk.h"
#include "field_exchange.h"
#include "field_values.h"
#include "point_survey.h"
#include "required_fields.h"

#include <pcl_cid/io/cloud_points.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

/** The type of a coordinate whose values do not all fit into float. */
bool
exceedsFloat(std::uint8_t datatype)
{
  return datatype != pcl::PCLPointField::FLOAT32 && sizeOf(datatype) > 2;
}

/** How far apart two neighboring values of a type are.
 *  \param[in] size of the values */
double
stepOf(std::uint8_t datatype, double size)
{
  if (kindOf(datatype) != 'F')
    return 1.0;
  const int digits = datatype == pcl::PCLPointField::FLOAT32
                         ? std::numeric_limits<float>::digits
                         : std::numeric_limits<double>::digits;
  return size > 0.0 ? std::ldexp(1.0, std::ilogb(size) + 1 - digits) : 0.0;
}

/** The points of a file, and what there is to say about them before they are used. */
class PointReading {
public:
  PointReading(const LabelledCloud& cloud, const PointOptions& options)
  : cloud_(cloud)
  , coordinates_(cloud)
  , datatype_(coordinates_.datatype())
  , survey_(cloud, options)
  , options_(options)
  {
  }

  CloudPoints
  read()
  {
    for (std::size_t i = 0; i < cloud_.size(); ++i)
      survey_.take(coordinates_[i]);
    survey_.decide();
    CloudPoints result;
    result.metres_per_unit = cloud_.scale;
    const bool is_coarse = step(survey_.largest()) > largest_step;
    if (survey_.finite() > 0 && (is_coarse || exceedsFloat(datatype_))) {
      const Eigen::AlignedBox3d bulk = boxOfBulk();
      remarkOnStep(bulk);
      if (exceedsFloat(datatype_))
        result.frame.origin = middleOf(bulk);
    }
    moveInto(result);
    for (int axis = 0; axis < 3; ++axis)
      result.extent[axis] = bulkOfAxis(axis).extent;
    return result;
  }

private:
  static constexpr double largest_step = 1e-3; // of coordinates, metres

  void
  remark(const std::string& sentence) const
  {
    if (options_.remark)
      options_.remark(cloud_.name + ": " + sentence);
  }

  /** As the file has it, or NaN where it is left out. */
  Eigen::Vector3d
  point(std::size_t i) const
  {
    return survey_.kept(coordinates_[i]);
  }

  /** The bounding box without points that are far from all others: one at (0, 0, 0), or
   *  where a position was lost. */
  Eigen::AlignedBox3d
  boxOfBulk() const
  {
    constexpr double far = 100.0; // times the size of the bulk
    Eigen::AlignedBox3d box;
    const Bulk bulk[] = {bulkOfAxis(0), bulkOfAxis(1), bulkOfAxis(2)};
    const Eigen::Vector3d middle(bulk[0].middle, bulk[1].middle, bulk[2].middle);
    const double extent = std::max({bulk[0].extent, bulk[1].extent, bulk[2].extent});
    const double size = extent > 0.0 ? extent : 1.0;
    for (std::size_t i = 0; i < cloud_.size(); ++i)
      if (const Eigen::Vector3d p = point(i);
          p.allFinite() && (p - middle).cwiseAbs().maxCoeff() <= far * size)
        box.extend(p);
    return box;
  }

  Bulk
  bulkOfAxis(int axis) const
  {
    return bulkOf(cloud_.size(), [&](std::size_t i) {
      const Eigen::Vector3d p = point(i);
      return p.allFinite() ? p[axis] : std::numeric_limits<double>::quiet_NaN();
    });
  }

  /** How far apart two neighboring coordinates of some size are. */
  double
  step(double size) const
  {
    return cloud_.scale * stepOf(datatype_, size / cloud_.scale);
  }

  void
  remarkOnStep(const Eigen::AlignedBox3d& bulk) const
  {
    const double largest =
        std::max(bulk.min().cwiseAbs().maxCoeff(), bulk.max().cwiseAbs().maxCoeff());
    const double step = this->step(largest);
    if (step > largest_step)
      remark(sentence("its coordinates come in steps of ",
                      step,
                      " m; what is smaller is lost (write them as double, or nearer to "
                      "the origin)"));
  }

  /** An origin for coordinates that are about as small as the cloud: the center of its
   *  box, rounded to steps of about its size; 0 on an axis where the cloud is near 0
   *  anyway. */
  static Eigen::Vector3d
  middleOf(const Eigen::AlignedBox3d& box)
  {
    const double size = box.sizes().maxCoeff();
    const double step = size > 0.0 ? std::exp2(std::ceil(std::log2(size))) : 1.0;
    return box.center().unaryExpr([step](double center) {
      return std::abs(center) < 2.0 * step ? 0.0 : std::round(center / step) * step;
    });
  }

  void
  moveInto(CloudPoints& result) const
  {
    result.points.reset(new pcl::PointCloud<pcl::PointXYZ>);
    result.points->resize(cloud_.size());
    for (std::size_t i = 0; i < cloud_.size(); ++i)
      (*result.points)[i].getVector3fMap() =
          result.frame.toLocal(point(i)).cast<float>();
    result.finite = survey_.finite();
    result.points->width = cloud_.fields.width;
    result.points->height = cloud_.fields.height;
    result.points->is_dense = result.finite == cloud_.size();
    result.points->sensor_origin_.head<3>() =
        result.frame.toLocal(survey_.sensor()).cast<float>();
    result.points->sensor_orientation_ = cloud_.sensor_orientation;
  }

  const LabelledCloud& cloud_;
  const FileCoordinates coordinates_;
  const std::uint8_t datatype_;
  PointSurvey survey_;
  const PointOptions& options_;
};

} // namespace

pcl::index_t
CloudPoints::find(std::int64_t index_in_file) const
{
  if (source.empty()) {
    const bool is_there = index_in_file >= 0 &&
                          static_cast<std::uint64_t>(index_in_file) < points->size();
    return is_there ? static_cast<pcl::index_t>(index_in_file) : -1;
  }
  const auto found = std::lower_bound(source.begin(), source.end(), index_in_file);
  if (found == source.end() || *found != index_in_file)
    return -1;
  return static_cast<pcl::index_t>(found - source.begin());
}

FileCoordinates::FileCoordinates(const LabelledCloud& cloud) : cloud_(&cloud)
{
  requireCoordinates(cloud);
  for (int axis = 0; axis < 3; ++axis)
    fields_[axis] = requireField(cloud, std::string(1, "xyz"[axis]));
}

Eigen::Vector3d
FileCoordinates::operator[](std::size_t point) const
{
  const std::uint8_t* const bytes =
      cloud_->fields.data.data() + point * cloud_->fields.point_step;
  Eigen::Vector3d p;
  for (int axis = 0; axis < 3; ++axis)
    switch (fields_[axis].datatype) { // most clouds have one of the first two
    case pcl::PCLPointField::FLOAT32:
      p[axis] = static_cast<double>(loadValue<float>(bytes + fields_[axis].offset));
      break;
    case pcl::PCLPointField::FLOAT64:
      p[axis] = loadValue<double>(bytes + fields_[axis].offset);
      break;
    default:
      p[axis] = toDouble(bytes + fields_[axis].offset, fields_[axis].datatype);
    }
  return cloud_->scale * p;
}

std::uint8_t
FileCoordinates::datatype() const
{
  for (const pcl::PCLPointField& field : fields_)
    if (exceedsFloat(field.datatype))
      return field.datatype;
  return fields_[0].datatype;
}

CloudPoints
pointsOf(const LabelledCloud& cloud, const PointOptions& options)
{
  return PointReading(cloud, options).read();
}

void
convertToMetres(LabelledCloud& cloud)
{
  const LabelledCloud from = cloud;
  const FileCoordinates metres(from);
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    const bool is_float =
        requireField(from, name).datatype == pcl::PCLPointField::FLOAT32;
    const auto store = [&](std::size_t i, std::uint8_t* target) {
      const double value = metres[i][axis];
      const auto rounded = static_cast<float>(value);
      is_float ? std::memcpy(target, &rounded, sizeof(rounded))
               : std::memcpy(target, &value, sizeof(value));
    };
    exchangeField(name,
                  is_float ? pcl::PCLPointField::FLOAT32 : pcl::PCLPointField::FLOAT64,
                  store,
                  cloud);
  }
  cloud.sensor_origin.head<3>() =
      (from.scale * from.sensor_origin.head<3>().cast<double>()).cast<float>();
  cloud.scale = 1.0;
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
