/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How far places are from hulls.
 */

#pragma once

#include "hull/hull_mesh.h"

#include <pcl_cid/core/convex_part.h>

#include <array>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pcl_cid::benchmarks {

/** \brief A hull as a solid. */
class ConvexBody {
public:
  /** \param[in] hull closed, convex, its triangles outward and none degenerate */
  explicit ConvexBody(const TriangleMesh& hull);

  bool
  contains(const Eigen::Vector3d& x) const;

  /** \brief The distance, 0 inside; \a limit where it is more.
   *  \note Cost: O(triangles), nothing where the bounding box is beyond the limit. */
  double
  distanceUpTo(double limit, const Eigen::Vector3d& x) const;

private:
  struct Face {
    HalfSpace half_space;
    std::array<Eigen::Vector3d, 3> corners;
  };

  Eigen::AlignedBox3d box_;
  /** A height above a plane may be off by this, metres. */
  double rounding_;
  std::vector<Face> faces_;
};

/** \brief Whether one of the bodies contains a place. */
bool
containedIn(const std::vector<ConvexBody>& bodies, const Eigen::Vector3d& x);

/** \brief The distance to the nearest body, 0 inside; \a limit where it is more. */
double
distanceUpTo(double limit,
             const std::vector<ConvexBody>& bodies,
             const Eigen::Vector3d& x);

} // namespace pcl_cid::benchmarks
