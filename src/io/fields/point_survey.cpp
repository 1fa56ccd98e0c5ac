/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What is looked at once over all points of a file, before any of them is used.
 */

#include "point_survey.h"

#include "base/sentence.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_cid {

Eigen::Vector3d
keptPoint(const Eigen::Vector3d& p, const std::vector<Eigen::Vector3d>& left_out)
{
  for (const Eigen::Vector3d& place : left_out)
    if (p == place)
      return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  return p;
}

PointSurvey::PointSurvey(const LabelledCloud& cloud, const PointOptions& options)
: cloud_(cloud)
, options_(options)
, sensor_(cloud.scale * cloud.sensor_origin.head<3>().cast<double>())
{
}

void
PointSurvey::take(const Eigen::Vector3d& p)
{
  const double size = std::max({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  if (size > largest_coordinate || !(size >= 0.0))
    requireInRange(p);
  ++taken_;
  if (!p.allFinite())
    return;
  ++finite_;
  largest_ = std::max(largest_, size);
  at_zero_ += size == 0.0 ? 1 : 0;
  at_sensor_ += p == sensor_ ? 1 : 0;
}

void
PointSurvey::decide()
{
  if (options_.keep_zeros)
    return;
  dropNoReturns(Eigen::Vector3d::Zero(), at_zero_);
  dropNoReturns(sensor_, at_sensor_);
}

void
PointSurvey::requireInRange(const Eigen::Vector3d& p) const
{
  for (int axis = 0; axis < 3; ++axis)
    if (const double value = p[axis];
        std::isfinite(value) && std::abs(value) > largest_coordinate)
      throw CIDException(sentence(cloud_.name,
                                  ": the ",
                                  "xyz"[axis],
                                  " of point ",
                                  taken_,
                                  " is ",
                                  value,
                                  "; coordinates go to 1e15, and a point that is "
                                  "none has NaN"));
}

/** Drivers write what did not return as a point at the sensor.
 *  \param[in] count of points exactly at the place */
void
PointSurvey::dropNoReturns(const Eigen::Vector3d& place, std::size_t count)
{
  if (count < std::size_t{many} || count == finite_)
    return;
  left_out_.push_back(place);
  finite_ -= count;
  at_sensor_ -= place == sensor_ ? count : 0;
  if (options_.remark)
    options_.remark(sentence(cloud_.name,
                             ": ",
                             count,
                             " points lie exactly at (",
                             place.x(),
                             ", ",
                             place.y(),
                             ", ",
                             place.z(),
                             "), where sensors put what did not return; they are left "
                             "out (keep-zeros keeps them)"));
}

} // namespace pcl_cid
