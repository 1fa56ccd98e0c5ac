/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the grid of the distance field needs while it is built.
 */

#pragma once

#include "distance_grid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pcl_cid {

/** A cell that is being built. */
struct DistanceGrid::Region {
  int x = 0, y = 0, z = 0; ///< its corner, in finest cells
  int shift = levels;      ///< its side is 2^shift finest cells
  std::int32_t slot = 0;   ///< the surface point nearest to the center c
  float distance = 0.0f;   ///< d(c)
  /** Nodes that can hold the nearest point of an x inside; no two overlap. */
  std::vector<std::int32_t> nodes;

  Place
  corner() const
  {
    return {x, y, z, true};
  }

  /** Corner of one of its eight parts. */
  Place
  octant(int number) const
  {
    const int half = 1 << (shift - 1);
    return {x + (number & 1 ? half : 0),
            y + (number & 2 ? half : 0),
            z + (number & 4 ? half : 0),
            true};
  }
};

/** Nodes and, as columns for SIMD, their boxes. */
struct DistanceGrid::Boxes {
  std::vector<std::int32_t> nodes;
  Eigen::Array<float, Eigen::Dynamic, 6> sides; ///< at least as many rows as nodes
  /** Along each axis, from the centers of the lower and of the upper half of a region;
   *  likewise. */
  Eigen::Array<float, Eigen::Dynamic, 6> squared_gap;
  Eigen::ArrayXf squared_distance; ///< likewise

  Eigen::Index
  size() const
  {
    return static_cast<Eigen::Index>(nodes.size());
  }

  void
  load(const BlockTree& tree)
  {
    if (sides.rows() < size()) {
      // Where memory lacks, Eigen's resize() lets go of what it had, and later again.
      sides = decltype(sides)(2 * size(), 6);
      squared_gap = decltype(squared_gap)(2 * size(), 6);
      squared_distance = Eigen::ArrayXf(2 * size());
    }
    for (Eigen::Index k = 0; k < size(); ++k) {
      const PointBox& box =
          tree.box(static_cast<std::size_t>(nodes[static_cast<std::size_t>(k)]));
      for (int axis = 0; axis < 3; ++axis) {
        sides(k, axis) = box.low[axis];
        sides(k, axis + 3) = box.high[axis];
      }
    }
  }

  /** \param[in] center of the octant that is lowest along each axis
   *  \param[in] opposite center of the one that is highest along each */
  void
  measureGaps(const Eigen::Vector3f& center, const Eigen::Vector3f& opposite)
  {
    for (int axis = 0; axis < 3; ++axis)
      for (const int upper : {0, 1}) {
        const float p = upper == 0 ? center[axis] : opposite[axis];
        squared_gap.col(2 * axis + upper).head(size()) =
            (sides.col(axis).head(size()) - p)
                .max(p - sides.col(axis + 3).head(size()))
                .max(0.0f)
                .square();
      }
  }

  /** Fill squared_distance, from the center of an octant: along each axis the eight
   *  centers have only two coordinates. */
  void
  measure(int octant)
  {
    const auto gap = [&](int axis) {
      return squared_gap.col(2 * axis + ((octant >> axis) & 1)).head(size());
    };
    squared_distance.head(size()) = gap(0) + gap(1) + gap(2);
  }
};

/** What it takes to build a piece. */
struct DistanceGrid::Growth {
  Piece& piece;
  std::size_t budget; ///< bytes
  Progress& progress;
  std::array<Region, levels + 1> regions; ///< the one that is being divided, by level
  std::array<Boxes, levels + 1> boxes;

  bool
  hasMemory() const
  {
    return piece.bytes() < budget;
  }
};

/** A list that the parts of a region share; made when the first of them needs it. */
struct DistanceGrid::SharedList {
  const Region& region;
  std::uint32_t list;

  std::uint32_t
  make(const DistanceGrid& grid, Growth& growth)
  {
    if (list == 0)
      list = grid.makeList(region, growth);
    return list;
  }
};

} // namespace pcl_cid
