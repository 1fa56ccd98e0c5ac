/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * From the coordinates of a file to those that are worked on, and back.
 */

#pragma once

#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief Where the local coordinates of a scan have their origin. All work is in float
 *  about a local origin, so that UTM coordinates keep their millimetres. */
struct Frame {
  /** In the coordinates of the file or the input cloud. */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();

  Eigen::Vector3d
  toLocal(const Eigen::Vector3d& p) const
  {
    return p - origin;
  }

  std::vector<Eigen::Vector3d>
  toLocal(std::vector<Eigen::Vector3d> positions) const
  {
    for (Eigen::Vector3d& p : positions)
      p = toLocal(p);
    return positions;
  }

  Eigen::Vector3d
  toFile(const Eigen::Vector3d& local) const
  {
    return local + origin;
  }
};

} // namespace pcl_cid
