/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A box along the principal axes of some points.
 */

#include "principal_box.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace pcl_cid {

PrincipalBox
principalBox(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points)
    mean += p;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points)
    covariance += (p - mean) * (p - mean).transpose();

  PrincipalBox box;
  box.center = mean;
  box.axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
  box.axes.col(2) = box.axes.col(0).cross(box.axes.col(1));
  Eigen::AlignedBox3d local;
  for (const Eigen::Vector3d& p : points)
    local.extend(box.toLocal(p));
  box.center = box.fromLocal(local.center());
  box.extents = local.sizes();
  return box;
}

} // namespace pcl_cid
