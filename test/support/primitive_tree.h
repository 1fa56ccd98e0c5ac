/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A bounding volume tree over primitives: rays and points against a room, quickly.
 */

#pragma once

#include <cstddef>
#include <vector>

#include "scene_primitive.h"

namespace pcl_cid::test {

/** \brief The primitive that a ray meets first. */
struct RayHit {
  std::size_t primitive; ///< index; the lowest one where two are met at once
  SurfaceHit surface;
};

/** \brief Answers for rays and points without trying every primitive. Safe to share
 *  between threads once built. Keeps a reference: the primitives must outlive it. */
class PrimitiveTree {
public:
  explicit PrimitiveTree(const std::vector<Primitive>& primitives);

  /** \brief The first surface ahead of \a origin along the unit \a direction.
   *  \return false when the ray leaves the scene; \a hit is filled when true */
  bool
  firstHit(const Eigen::Vector3d& origin,
           const Eigen::Vector3d& direction,
           RayHit& hit) const;

  /** \brief Whether \a point lies on or in a primitive other than number \a self. */
  bool
  isCovered(const Eigen::Vector3d& point, std::size_t self) const;

private:
  struct Node {
    Eigen::Vector3d low;
    Eigen::Vector3d high;
    std::size_t begin; ///< of the primitives in order_
    std::size_t end;
    std::size_t second_child; ///< 0 in a leaf; the first child follows its parent
  };

  void
  build(std::size_t begin, std::size_t end);

  const std::vector<Primitive>& primitives_;
  std::vector<std::size_t> order_;
  std::vector<Node> nodes_;
};

} // namespace pcl_cid::test
