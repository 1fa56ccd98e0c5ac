/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What scanners have seen to be free.
 */

#pragma once

#include <pcl_cid/core/point_set.h>

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief Which places were crossed by a ray from a viewpoint to a point that it sees.
 *
 *  Each viewpoint has a cube of ranges around it: the farthest point that it sees in
 *  each cell of directions. Where several scanners took a scan, one sees a point when
 *  no point in the same direction is much nearer. */
class SeenSpace {
public:
  /** \param[in] margin how far before its point a ray counts, metres */
  SeenSpace(const Points& points,
            const std::vector<Eigen::Vector3d>& viewpoints,
            double margin);

  /** \brief Always true without viewpoints. */
  bool
  isSeen(const Eigen::Vector3d& place) const;

private:
  struct RangeCube {
    Eigen::Vector3d center;
    std::vector<float> farthest; ///< of each cell; 0: nothing seen
  };

  static RangeCube
  cubeOf(const Points& points,
         const Eigen::Vector3d& viewpoint,
         bool is_only_one,
         double margin);

  std::vector<RangeCube> cubes_;
  double margin_;
};

} // namespace pcl_cid
