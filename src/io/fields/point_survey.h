/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What is looked at once over all points of a file, before any of them is used.
 */

#pragma once

#include <pcl_cid/io/cloud_points.h>

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief Farther out, even the coordinates of double are too coarse for hulls. */
constexpr double largest_coordinate = 1e15;

/** \brief A point, or NaN where it is at one of some places. */
Eigen::Vector3d
keptPoint(const Eigen::Vector3d& p, const std::vector<Eigen::Vector3d>& left_out);

/** \brief Counts the points of a cloud that are finite, and those at places where
 * drivers put what did not return. */
class PointSurvey {
public:
  /** So many points exactly at one such place are what did not return. */
  static constexpr int many = 10;

  /** \param[in] cloud its name, scale and sensor are used; it must outlive this */
  PointSurvey(const LabelledCloud& cloud, const PointOptions& options);

  /** \brief The next point.
   *  \throws CIDException for a finite coordinate beyond largest_coordinate */
  void
  take(const Eigen::Vector3d& p);

  /** \brief After the last point: decide which places are left out, with remarks. */
  void
  decide();

  /** \brief Whether a point is where those are that did not return, left out or not. */
  bool
  isWhereNoneReturned(const Eigen::Vector3d& p) const
  {
    return p == sensor_ || p.isZero(0.0);
  }

  /** \brief After decide(): places whose points are left out. */
  const std::vector<Eigen::Vector3d>&
  leftOut() const
  {
    return left_out_;
  }

  /** \brief A point, or NaN where it is left out. */
  Eigen::Vector3d
  kept(const Eigen::Vector3d& p) const
  {
    return keptPoint(p, left_out_);
  }

  /** \brief Finite points; after decide() without those that are left out. */
  std::size_t
  finite() const
  {
    return finite_;
  }

  /** \brief The largest of all finite coordinates. */
  double
  largest() const
  {
    return largest_;
  }

  /** \brief Where the sensor stands, metres. */
  const Eigen::Vector3d&
  sensor() const
  {
    return sensor_;
  }

private:
  void
  requireInRange(const Eigen::Vector3d& p) const;

  void
  dropNoReturns(const Eigen::Vector3d& place, std::size_t count);

  const LabelledCloud& cloud_;
  const PointOptions options_;
  const Eigen::Vector3d sensor_;
  std::vector<Eigen::Vector3d> left_out_;
  std::size_t taken_ = 0;
  std::size_t finite_ = 0;
  std::size_t at_zero_ = 0;
  std::size_t at_sensor_ = 0;
  double largest_ = 0.0;
};

} // namespace pcl_cid
