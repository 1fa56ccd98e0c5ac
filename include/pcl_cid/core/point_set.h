/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The finite points of a cloud about a local origin.
 */

#pragma once

#include <pcl_cid/core/frame.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <vector>

#include <pcl/types.h>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief Coordinates of points, contiguous, in metres (or the cloud's own unit). */
using Points = std::vector<Eigen::Vector3f>;

/** \brief The finite points of a cloud, moved to a local origin, with the way back.
 *
 *  The origin is subtracted in double precision before anything is computed, so a cloud
 *  at UTM coordinates gives the result of the same cloud at the origin, up to the
 *  resolution of its own coordinates. The origin is a multiple of a power of two that
 *  is no smaller than the cloud, and 0 for a cloud near zero: the subtraction is
 *  exact. */
struct PCL_CID_EXPORT PointSet {
  /** What was subtracted. */
  Frame frame;
  /** Finite points, in the frame, in the order of the input. */
  Points points;
  /** Index in the input cloud of each of the points. */
  pcl::Indices source;

  PointSet() = default;

  /** \brief Keep the finite points and choose the origin from their bounding box.
   *  \param[in] coordinates of all the points, finite or not
   *  \param[in] source index in the input cloud of each; same size */
  PointSet(Points coordinates, pcl::Indices source);

  /** \brief Keep the finite points, in a given frame: that of the surface that they are
   *  measured against. */
  PointSet(Points coordinates, pcl::Indices source, const Frame& frame);

  std::size_t
  size() const
  {
    return points.size();
  }
};

} // namespace pcl_cid
