/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which points of a surface see each other through the inside of the shape.
 */

#pragma once

#include "surface_graph.h"

#include <pcl_cid/core/distance_field.h>

#include <vector>

#include <Eigen/Core>

namespace pcl_cid::benchmarks {

/** \brief Lines of sight between points of an oriented surface.
 *
 *  Two points see each other when the segment between them leaves both to the inside
 *  and crosses no other surface, or when it is in the tangent plane of both. */
class LineOfSight {
public:
  /** \param[in] surface not copied
   *  \param[in] field of its points, not copied
   *  \param[in] coplanar a segment is in a tangent plane up to this sine of the angle
   *  \param[in] reach radius of the disc that each point stands for, above 0; also how
   *  far behind a disc the ends must be for it to count as crossed */
  LineOfSight(const OrientedPoints& surface,
              const DistanceField& field,
              float coplanar,
              float reach)
  : surface_(surface), field_(field), coplanar_(coplanar), reach_(reach)
  {
  }

  /** \brief Whether two points, given by index, see each other. */
  bool
  isFree(std::size_t first, std::size_t second) const;

private:
  /** Whether the segment crosses a disc, given by index, near a place on its way. */
  bool
  separates(std::size_t disc,
            const Eigen::Vector3f& here,
            const Eigen::Vector3f& from,
            const Eigen::Vector3f& to) const;

  bool
  crossesSurface(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const;

  const OrientedPoints& surface_;
  const DistanceField& field_;
  float coplanar_;
  float reach_;
};

/** \brief The share of pairs, one point from each of two patches, that see each other;
 *  symmetric, 1 for a patch and itself. 0 for patches of different pieces: they can
 *  never be joined, and their lines are many.
 *  \param[in] patch number of the patch of each point, from 0 without gaps
 *  \param[in] piece number of the connected piece of the surface that each point is of
 *  \param[in] samples points taken from each patch, spread evenly over its list */
Eigen::MatrixXf
mutualVisibility(const LineOfSight& sight,
                 const std::vector<int>& patch,
                 const std::vector<int>& piece,
                 std::size_t samples);

} // namespace pcl_cid::benchmarks
