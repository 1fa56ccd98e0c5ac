/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A box along the principal axes of some points.
 */

#pragma once

#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief The principal axes of some points and their extent along each. */
struct PrincipalBox {
  Eigen::Vector3d center;
  Eigen::Matrix3d axes; ///< columns, a right-handed basis
  Eigen::Vector3d extents;

  /** \brief Coordinates along the axes, from the center. */
  Eigen::Vector3d
  toLocal(const Eigen::Vector3d& p) const
  {
    return axes.transpose() * (p - center);
  }

  Eigen::Vector3d
  fromLocal(const Eigen::Vector3d& local) const
  {
    return center + axes * local;
  }
};

/** \brief The box of at least 1 point. */
PrincipalBox
principalBox(const std::vector<Eigen::Vector3d>& points);

} // namespace pcl_cid
