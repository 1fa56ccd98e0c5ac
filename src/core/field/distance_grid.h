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

#include "base/rounding.h"
#include "block_tree.h"

#include <pcl_cid/core/distance_field.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief An octree over the surface, with a regular grid for its upper levels. Cells
 *  are divided until the error of their bounds is about the spacing of the points.
 *
 *  A cell that is not divided knows the surface point n nearest to its center c:
 *  - |x - n| bounds d(x) from above, since n is a point of S;
 *  - |c - n| - |x - c| bounds it from below, since d is 1-Lipschitz.
 *
 *  It also shares with its neighbors a list of the nodes of the block tree that can
 *  hold the point nearest to any x inside, unless they are too many: the minimum over
 *  these is exact.
 *
 *  A finer grid is faster and nothing else: where the memory budget ends the division,
 *  every answer is still right. */
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

  /** \brief What a *look* at x gives, without a search: certified bounds of d(x; S) and
   *  the point of S that they come from, which is the one nearest to the center of the
   *  cell of x. */
  struct Look {
    DistanceBounds bounds;
    const Eigen::Vector3f& point;
  };

  Look
  look(const Eigen::Vector3f& x) const
  {
    const Place place = placeOf(x);
    const Leaf leaf = leafAt(place);
    const Eigen::Vector3f& nearest = tree_.position(leaf.slot);
    return {{lowerBound(x, centerOf(place, leaf.shift), nearest),
             (x - nearest).norm() * rounding::norm_widening + slack_},
            nearest};
  }

  /** \brief Only the lower bound of a look. */
  float
  lowerBound(const Eigen::Vector3f& x) const
  {
    const Place place = placeOf(x);
    const Leaf leaf = leafAt(place);
    return lowerBound(x, centerOf(place, leaf.shift), tree_.position(leaf.slot));
  }

  /** \brief Only the surface point of a look. */
  const Eigen::Vector3f&
  likelyNearest(const Eigen::Vector3f& x) const
  {
    return tree_.position(leafAt(placeOf(x)).slot);
  }

  /** \brief A surface point at distance d(x; S), when the cell of x has a list; slot -1
   *  when it has none. */
  BlockTree::Nearest
  nearest(const Eigen::Vector3f& x) const;

  std::size_t
  bytes() const;

private:
  static constexpr int levels =
      22; ///< 2^22 finest cells a side: the resolution of float
  static constexpr float last_place = static_cast<float>((1 << levels) - 1);

  struct Cell {
    std::int32_t slot;  ///< of the nearest point, or ~index of the first of 8 cells
    std::uint32_t list; ///< where its nodes are listed; 0: not kept
  };

  /** One of the 8^piece_bits_ equal cubes of the grid, each built by one thread: its
   *  part of the regular grid, then the cells that those are divided into. Most looks
   *  need no list, so slots and lists are separate arrays, for the cache. */
  struct Piece {
    std::vector<std::int32_t> slot;  ///< of each cell
    std::vector<std::uint32_t> list; ///< of each cell
    std::vector<std::int32_t> lists; ///< each begins with the number of its nodes

    void
    resize(std::size_t cells)
    {
      slot.resize(cells);
      list.resize(cells);
    }

    void
    set(std::size_t index, const Cell& cell)
    {
      slot[index] = cell.slot;
      list[index] = cell.list;
    }

    std::size_t
    bytes() const
    {
      return slot.size() * sizeof(Cell) + lists.size() * sizeof(std::int32_t);
    }
  };

  /** Coordinates in units of the finest cell. */
  struct Place {
    int x, y, z;
    bool inside;
  };

  struct Leaf {
    const Piece* piece;
    std::size_t index; ///< in the piece
    std::int32_t slot; ///< of the nearest point
    int shift;         ///< its side is 2^shift finest cells
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

  int
  pieceShift() const
  {
    return levels - piece_bits_;
  }

  /** Index of a cube in a row-major array of 2^bits a side. */
  static std::size_t
  indexOf(int x, int y, int z, int bits)
  {
    return static_cast<std::size_t>((((z << bits) | y) << bits) | x);
  }

  std::size_t
  pieceAt(const Place& at) const
  {
    const int shift = pieceShift();
    return indexOf(at.x >> shift, at.y >> shift, at.z >> shift, piece_bits_);
  }

  /** Index, in its piece, of a cell of the regular grid. */
  std::size_t
  rootAt(const Place& at) const
  {
    const int bits = root_bits_ - piece_bits_;
    const int inside = (1 << bits) - 1;
    const int shift = rootShift();
    return indexOf((at.x >> shift) & inside,
                   (at.y >> shift) & inside,
                   (at.z >> shift) & inside,
                   bits);
  }

  Leaf
  leafAt(const Place& at) const
  {
    const Piece& piece = pieces_[pieceAt(at)];
    int shift = rootShift();
    std::size_t index = rootAt(at);
    std::int32_t slot = piece.slot[index];
    while (slot < 0) {
      --shift;
      const int octant = ((at.x >> shift) & 1) | (((at.y >> shift) & 1) << 1) |
                         (((at.z >> shift) & 1) << 2);
      index = static_cast<std::size_t>(~slot + octant);
      slot = piece.slot[index];
    }
    return {&piece, index, slot, shift};
  }

  /** \param[in] nearest to the center of the cell of x */
  float
  lowerBound(const Eigen::Vector3f& x,
             const Eigen::Vector3f& center,
             const Eigen::Vector3f& nearest) const
  {
    return (center - nearest).norm() * rounding::norm_narrowing -
           (x - center).norm() * rounding::norm_widening - slack_;
  }

  Eigen::Vector3f
  centerOf(const Place& at, int shift) const
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
  struct SharedList;

  float
  halfDiagonal(int shift) const
  {
    return 0.8660255f * finest_ * static_cast<float>(1 << shift);
  }

  Region
  wholeRegion() const;

  void
  open(const Region& region, Boxes& boxes) const;

  void
  makePart(const Region& whole, Boxes& boxes, int octant, Region& part) const;

  void
  keepNodes(const Boxes& boxes, Region& part) const;

  bool
  isVisited(const Region& cell) const;

  bool
  isCoarse(const Region& cell) const;

  void
  tolerateErrors();

  std::vector<Region>
  divideWhole() const;

  void
  growPiece(const Region& region, std::size_t budget, Progress& progress);

  void
  grow(const Region& region, SharedList& whole, Growth& growth) const;

  Cell
  makeCell(const Region& region,
           std::uint32_t list,
           SharedList& whole,
           Growth& growth) const;

  std::uint32_t
  makeList(const Region& region, Growth& growth) const;

  const BlockTree& tree_;
  int root_bits_ = 0;  ///< the regular grid has 2^this cells a side
  int piece_bits_ = 0; ///< and is built in 2^this pieces a side
  Eigen::Vector3f corner_;
  float finest_; ///< side of a finest cell
  float inverse_finest_;
  float slack_;                        ///< covers the rounding of every bound
  std::vector<float> tolerated_error_; ///< by block, while the grid is built
  std::vector<Piece> pieces_;
};

} // namespace pcl_cid
