/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points in the order of a balanced kd-tree, in blocks that are contiguous in
 * memory.
 */

#pragma once

#include "base/progress.h"
#include "base/rounding.h"

#include <pcl_cid/core/point_set.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief Up to sixteen neighboring points, as columns x, y, z. Unused rows repeat the
 *  last point, so a minimum over all rows is that over the points. */
struct alignas(16) PointBlock {
  static constexpr int capacity = 16;

  Eigen::Array<float, capacity, 1> x, y, z;
  /** Index of each point among those that the tree was built from. */
  Eigen::Array<std::int32_t, capacity, 1> index;
  std::int32_t count;

  Eigen::Vector3f
  point(int row) const
  {
    return {x[row], y[row], z[row]};
  }

  /** \brief Squared distances, each rounded as (dx dx + dy dy) + dz dz in float: the
   *  only formula that d(x; S) is computed by. Four at a time, by Eigen. */
  Eigen::Array<float, capacity, 1>
  squaredDistances(const Eigen::Vector3f& p) const
  {
    const Eigen::Array<float, capacity, 1> dx = p.x() - x;
    const Eigen::Array<float, capacity, 1> dy = p.y() - y;
    const Eigen::Array<float, capacity, 1> dz = p.z() - z;
    return (dx * dx + dy * dy) + dz * dz;
  }
};

/** \brief Three coordinates and a 0, which fill a SIMD register. */
inline Eigen::Array4f
padded(const Eigen::Vector3f& p)
{
  return {p.x(), p.y(), p.z(), 0.0f};
}

/** \brief The bounding box of some points; its corners are padded(). */
struct PointBox {
  Eigen::Array4f low;
  Eigen::Array4f high;

  Eigen::Vector3f
  center() const
  {
    return (0.5f * (low + high)).matrix().head<3>();
  }

  /** \brief Upper bound of the distance from the center to any point of the box. */
  float
  radius() const
  {
    return (0.5f * (high - low)).matrix().norm() * rounding::widening;
  }

  /** \brief Squared distance from a padded point to the box, 0 inside. */
  float
  squaredDistance(const Eigen::Array4f& p) const
  {
    return (low - p).max(p - high).max(0.0f).square().sum();
  }
};

/** \brief A complete binary tree over blocks of points: node 1 is the root, the
 *  children of node n are 2n and 2n + 1, and nodes size() to 2 size() - 1 are the
 *  blocks, on the last level and, unless their number is a power of two, the one above.
 *
 *  Each node is split at its widest side so that the blocks have the same number of
 *  points, to within one; equal coordinates are ordered by index: the tree is the same
 *  on every machine and for every number of threads. */
class BlockTree {
public:
  /** \param[in] points finite, at least 1
   *  \param[in] threads never changes the tree
   *  \param[in,out] progress asked for cancellation */
  BlockTree(const Points& points, int threads, Progress& progress);

  /** \brief Number of blocks: as few as hold the points. */
  std::size_t
  size() const
  {
    return blocks_.size();
  }

  const PointBlock&
  block(std::size_t number) const
  {
    return blocks_[number];
  }

  /** \brief The point in a slot: block * PointBlock::capacity + row. */
  const Eigen::Vector3f&
  position(std::int32_t slot) const
  {
    return positions_[static_cast<std::size_t>(slot)];
  }

  /** \brief The box of a node, 1 to 2 size() - 1. */
  const PointBox&
  box(std::size_t node) const
  {
    return boxes_[node];
  }

  /** \brief The node of a block. */
  std::size_t
  nodeOfBlock(std::size_t block) const
  {
    return size() + block;
  }

  bool
  isBlock(std::size_t node) const
  {
    return node >= size();
  }

  /** \brief The nearest point found so far. */
  struct Nearest {
    float squared_distance = std::numeric_limits<float>::infinity();
    std::int32_t slot = -1;
  };

  /** \brief Improve on the nearest point found so far with the points below a node.
   *  \param[in] x padded */
  void
  descend(std::size_t node, const Eigen::Array4f& x, Nearest& nearest) const
  {
    if (!isBlock(node)) {
      const float left = box(2 * node).squaredDistance(x);
      const float right = box(2 * node + 1).squaredDistance(x);
      const std::size_t near = right < left ? 2 * node + 1 : 2 * node;
      if (std::min(left, right) <= nearest.squared_distance * rounding::widening)
        descend(near, x, nearest);
      if (std::max(left, right) <= nearest.squared_distance * rounding::widening)
        descend(near ^ 1, x, nearest);
      return;
    }
    scan(node - size(), x, nearest);
  }

  /** \brief Improve on the nearest point found so far with the points of a block.
   *  \param[in] x padded */
  void
  scan(std::size_t number, const Eigen::Array4f& x, Nearest& nearest) const
  {
    const auto squared = block(number).squaredDistances(x.matrix().head<3>());
    const float smallest = squared.minCoeff();
    if (smallest >= nearest.squared_distance)
      return;
    constexpr int last = PointBlock::capacity - 1;
    int row = last; // the first with this distance; branch-free
    for (int k = 0; k <= last; ++k)
      row = std::min(row, squared[k] == smallest ? k : last);
    nearest.squared_distance = smallest;
    nearest.slot = static_cast<std::int32_t>(number) * PointBlock::capacity + row;
  }

private:
  /** The number, from left to right, of a node that is a block: those of the last level
   *  come before those above. */
  std::size_t
  leafOf(std::size_t node) const;

  /** Leftmost of the blocks below a node. */
  std::size_t
  firstLeaf(std::size_t node) const;

  /** One past the rightmost. */
  std::size_t
  endLeaf(std::size_t node) const;

  std::vector<PointBlock> blocks_;
  Points positions_; ///< the same points, for access one at a time
  std::vector<PointBox> boxes_;
};

} // namespace pcl_cid
