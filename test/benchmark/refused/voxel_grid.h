/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Space in cubes, and the cubes that a segment crosses.
 */

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pcl_cid::benchmarks {

/** \brief Cubes that cover a box, the first one at its lowest corner. */
class VoxelGrid {
public:
  /** \param[in] box not empty
   *  \param[in] voxel edge of a cube, metres, above 0 */
  VoxelGrid(const Eigen::AlignedBox3d& box, double voxel)
  : origin_(box.min())
  , voxel_(voxel)
  , counts_((box.sizes() / voxel).array().floor() + 1)
  {
  }

  /** \brief Number of cubes, which may be more than memory has room for. */
  double
  size() const
  {
    return counts_.prod();
  }

  double
  voxel() const
  {
    return voxel_;
  }

  bool
  contains(const Eigen::Vector3d& x) const
  {
    const Eigen::Array3d cell = inVoxels(x).array().floor();
    return (cell >= 0.0).all() && (cell < counts_.array()).all();
  }

  /** \brief The number of the cube that a place in the grid is in. */
  std::size_t
  indexOf(const Eigen::Vector3d& x) const
  {
    return indexOf(cellOf(inVoxels(x)));
  }

  Eigen::Vector3d
  centerOf(std::size_t index) const
  {
    const auto ny = static_cast<std::size_t>(counts_.y());
    const auto nz = static_cast<std::size_t>(counts_.z());
    const Eigen::Vector3d cell(static_cast<double>(index / (ny * nz)),
                               static_cast<double>(index / nz % ny),
                               static_cast<double>(index % nz));
    return origin_ + voxel_ * (cell.array() + 0.5).matrix();
  }

  /** \brief Call \a visit(index) for each cube that a segment crosses, in its order. */
  template <typename Visit>
  void
  forEachOn(const Eigen::Vector3d& from,
            const Eigen::Vector3d& to,
            const Visit& visit) const
  {
    const Eigen::Vector3d begin = inVoxels(from);
    const Eigen::Vector3d way = inVoxels(to) - begin;
    double enter = 0.0;
    double leave = 1.0;
    if (clip(begin, way, enter, leave))
      walk(begin, way, cellOf(begin + enter * way), cellOf(begin + leave * way), visit);
  }

private:
  using Cell = std::array<std::ptrdiff_t, 3>;

  Eigen::Vector3d
  inVoxels(const Eigen::Vector3d& x) const
  {
    return (x - origin_) / voxel_;
  }

  /** Of the border, where rounding has led out of the grid. */
  Cell
  cellOf(const Eigen::Vector3d& in_voxels) const
  {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis)
      cell[static_cast<std::size_t>(axis)] = static_cast<std::ptrdiff_t>(
          std::clamp(std::floor(in_voxels[axis]), 0.0, counts_[axis] - 1.0));
    return cell;
  }

  std::size_t
  indexOf(const Cell& cell) const
  {
    const auto ny = static_cast<std::ptrdiff_t>(counts_.y());
    const auto nz = static_cast<std::ptrdiff_t>(counts_.z());
    return static_cast<std::size_t>((cell[0] * ny + cell[1]) * nz + cell[2]);
  }

  /** The share of the way that is in the grid.
   *  \return whether any is */
  bool
  clip(const Eigen::Vector3d& begin,
       const Eigen::Vector3d& way,
       double& enter,
       double& leave) const
  {
    for (int axis = 0; axis < 3; ++axis) {
      if (way[axis] == 0.0) {
        if (begin[axis] < 0.0 || begin[axis] > counts_[axis])
          return false;
        continue;
      }
      const double low = -begin[axis] / way[axis];
      const double high = (counts_[axis] - begin[axis]) / way[axis];
      enter = std::max(enter, std::min(low, high));
      leave = std::min(leave, std::max(low, high));
    }
    return enter <= leave;
  }

  /** From cell to cell through the side that the segment reaches first. Each step comes
   *  nearer to the last cell, whatever is rounded. */
  template <typename Visit>
  void
  walk(const Eigen::Vector3d& begin,
       const Eigen::Vector3d& way,
       Cell cell,
       const Cell& last,
       const Visit& visit) const
  {
    visit(indexOf(cell));
    while (cell != last) {
      std::size_t next = 0;
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (cell[axis] == last[axis])
          continue;
        const double side =
            static_cast<double>(cell[axis] + (last[axis] > cell[axis] ? 1 : 0));
        const auto i = static_cast<Eigen::Index>(axis);
        const double share = (side - begin[i]) / way[i];
        if (share < nearest) {
          nearest = share;
          next = axis;
        }
      }
      cell[next] += last[next] > cell[next] ? 1 : -1;
      visit(indexOf(cell));
    }
  }

  Eigen::Vector3d origin_;
  double voxel_;
  Eigen::Vector3d counts_;
};

} // namespace pcl_cid::benchmarks
