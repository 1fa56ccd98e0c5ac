/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * --verify: the bound on the error of hulls, checked on what is in the files.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/io/cloud_points.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid::tools {

/** \brief Looks for places of hulls that are too far from the points of a scan.
 *
 *  None of the code that fits hulls is used: a hull is cut into boxes, PCL's
 *  KdTreeFLANN says how far their centers are from the scan, and a place was seen when
 *  no point within half a degree of it is nearer to a viewpoint. */
class ErrorVerification {
public:
  /** \param[in] points of the scan; kept
   *  \param[in] max_error T, metres
   *  \param[in] viewpoints in the frame of \a points; none: all places count */
  ErrorVerification(const CloudPoints& points,
                    double max_error,
                    const std::vector<Eigen::Vector3d>& viewpoints);
  ~ErrorVerification();

  /** \brief A sentence about a place that is farther than T, or, where viewpoints are
   *  given, farther than 4/3 T, as the places that were seen are known to so much.
   *  \param[in] hull in the frame of \a points */
  std::optional<std::string>
  findTooFar(const TriangleMesh& hull) const;

private:
  struct Tree;

  /** The range of the nearest point in each direction; 0 for none. */
  struct View {
    Eigen::Vector3d from;
    std::vector<float> nearest;
  };

  double
  distance(const Eigen::Vector3d& place) const;

  bool
  isSeen(const Eigen::Vector3d& place) const;

  const CloudPoints& points_;
  double allowed_;
  std::vector<View> views_;
  std::unique_ptr<Tree> tree_;
};

} // namespace pcl_cid::tools
