/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Bounds of d(x; S) everywhere, and exact values near the surface: an adaptive
 * grid.
 */

#pragma once

#include "block_tree.h"

#include <pcl_cid/core/distance_field.h>

#include <algorithm>
#include <array>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief An octree over the surface, on top of an even grid that takes its upper
 *  levels: cells near the surface are divided until few points are near.
 *
 *  A cell that is not divided knows the surface point nearest to its centre c:
 *  - |x - that point| bounds d(x) from above, since the point is one of S;
 *  - |c - that point| - |x - c| bounds it from below, since d is 1-Lipschitz. It also
 *    lists the nodes of the block tree that can hold the nearest point of anything
 *    inside it, unless they are too many: a minimum over those is exact.
 *
 *  Finer means nothing but faster: memory that runs out ends the division, and every
 *  answer stays right. */
class DistanceGrid {
public:
  /** \param[in] tree the surface; kept by reference
   *  \param[in] memory_budget bytes that the grid may take
   *  \param[in] threads never changes the grid
   *  \param[in,out] progress asked for cancellation */
  DistanceGrid(const BlockTree& tree,
               std::size_t memory_budget,
               int threads,
               Progress& progress);

  /** \brief Certified bounds of d(x; S), for any x. */
  DistanceBounds
  bounds(const Eigen::Vector3f& x) const
  {
    const Place place = placeOf(x);
    const Leaf leaf = leafAt(place);
    const Eigen::Vector3f& nearest = tree_.position(leaf.cell->slot);
    const Eigen::Vector3f centre = centreOf(place, leaf.shift);
    return {(centre - nearest).norm() / widening - (x - centre).norm() * widening -
                slack_,
            (x - nearest).norm() * widening + slack_};
  }

  /** \brief The upper bound alone. */
  float
  high(const Eigen::Vector3f& x) const
  {
    return (x - tree_.position(leafAt(placeOf(x)).cell->slot)).norm() * widening +
           slack_;
  }

  /** \brief The surface point nearest to x, when the cell of x lists who can be that;
   *  slot -1 when it does not. */
  BlockTree::Nearest
  nearest(const Eigen::Vector3f& x) const;

  std::size_t
  bytes() const
  {
    return cells_.size() * sizeof(Cell) + lists_.size() * sizeof(std::int32_t);
  }

private:
  static constexpr int levels =
      22; ///< 2^22 finest cells a side: what float tells apart
  static constexpr float last_place = static_cast<float>((1 << levels) - 1);

  /** Covers the rounding of a norm; `slack_` covers that of coordinates in the box. */
  static constexpr float widening = 1.000002f;

  struct Cell {
    std::int32_t slot;  ///< of the nearest point, or ~index of the first of 8 cells
    std::uint32_t list; ///< where its nodes are listed, number first; 0: not kept
  };

  /** Coordinates in units of the finest cell. */
  struct Place {
    int x, y, z;
    bool inside;
  };

  struct Leaf {
    const Cell* cell;
    int shift; ///< its side is 2^shift finest cells
  };

  Place
  placeOf(const Eigen::Vector3f& x) const
  {
    const Eigen::Vector3f scaled = (x - corner_) * inverse_finest_;
    const auto clamp = [](float v) { return std::min(std::max(v, 0.0f), last_place); };
    const float cx = clamp(scaled.x()), cy = clamp(scaled.y()), cz = clamp(scaled.z());
    return {static_cast<int>(cx),
            static_cast<int>(cy),
            static_cast<int>(cz),
            cx == scaled.x() && cy == scaled.y() && cz == scaled.z()};
  }

  int
  rootShift() const
  {
    return levels - root_bits_;
  }

  std::size_t
  rootIndex(int x, int y, int z) const
  {
    return static_cast<std::size_t>((((z << root_bits_) | y) << root_bits_) | x);
  }

  Leaf
  leafAt(const Place& at) const
  {
    int shift = rootShift();
    const Cell* cell = &cells_[rootIndex(at.x >> shift, at.y >> shift, at.z >> shift)];
    while (cell->slot < 0) {
      --shift;
      const int octant = ((at.x >> shift) & 1) | (((at.y >> shift) & 1) << 1) |
                         (((at.z >> shift) & 1) << 2);
      cell = &cells_[static_cast<std::size_t>(~cell->slot + octant)];
    }
    return {cell, shift};
  }

  Eigen::Vector3f
  centreOf(const Place& at, int shift) const
  {
    const float half = 0.5f * static_cast<float>(1 << shift);
    const auto middle = [&](int v) {
      return static_cast<float>(v >> shift << shift) + half;
    };
    return corner_ +
           finest_ * Eigen::Vector3f(middle(at.x), middle(at.y), middle(at.z));
  }

  struct Region;
  struct Boxes;
  struct Growth;

  float
  halfDiagonal(int shift) const
  {
    return 0.8660255f * finest_ * static_cast<float>(1 << shift);
  }

  Region
  wholeRegion() const;

  Region
  child(const Region& parent, const Boxes& boxes, int octant) const;

  std::vector<Region>
  divide(const Region& region) const;

  void
  grow(const Region& region, Growth& growth);

  void
  merge(Growth& growth);

  const BlockTree& tree_;
  int root_bits_ = 0;
  Eigen::Vector3f corner_;
  float finest_; ///< side of a finest cell
  float inverse_finest_;
  float slack_; ///< covers the rounding of every bound
  std::vector<Cell> cells_;
  std::vector<std::int32_t> lists_;
};

} // namespace pcl_cid
