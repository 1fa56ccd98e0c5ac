/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Shapes that a sphere must not touch, held by FCL.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>

#include <memory>
#include <vector>

#include <fcl/fcl.h>

#include <Eigen/Core>

namespace planning {

using Shape = std::shared_ptr<fcl::CollisionGeometryd>;

/** \brief A hull as FCL takes it.
 *  \throws std::exception when FCL finds it invalid */
Shape
shapeOf(const pcl_cid::TriangleMesh& hull);

/** \brief One shape for each part. */
std::vector<Shape>
shapesOf(const std::vector<pcl_cid::ConvexPart>& parts);

/** \brief Shapes in a tree of boxes, so that a query looks at the few that are near. */
class CollisionMap {
public:
  explicit CollisionMap(const std::vector<Shape>& shapes);

  /** \brief Whether a sphere touches any of the shapes. */
  bool
  touches(const Eigen::Vector3d& center, double radius) const;

private:
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
  fcl::DynamicAABBTreeCollisionManagerd tree_;
};

} // namespace planning
