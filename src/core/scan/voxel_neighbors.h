/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The voxels around one, and how far they are from a point in it.
 */

#pragma once

#include "voxel_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** The 26 voxels around one, each a bit of a mask. */
inline std::vector<VoxelCell>
voxelsAround()
{
  std::vector<VoxelCell> around;
  for (std::int32_t x = -1; x <= 1; ++x)
    for (std::int32_t y = -1; y <= 1; ++y)
      for (std::int32_t z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0)
          around.push_back({x, y, z});
  return around;
}

/** Those around these: a point of its own voxel is nearer than any beyond them. */
inline std::vector<VoxelCell>
voxelsFartherOut()
{
  std::vector<VoxelCell> farther;
  for (std::int32_t x = -2; x <= 2; ++x)
    for (std::int32_t y = -2; y <= 2; ++y)
      for (std::int32_t z = -2; z <= 2; ++z)
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == 2)
          farther.push_back({x, y, z});
  return farther;
}

inline VoxelCell
operator+(const VoxelCell& a, const VoxelCell& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/** How far it is from a point to the voxels around its own: at most that, whatever is
 *  rounded. */
class VoxelGaps {
public:
  /** \param[in] corner of the point's voxel */
  VoxelGaps(const Eigen::Vector3d& p, const Eigen::Vector3d& corner, double size)
  {
    for (int axis = 0; axis < 3; ++axis) {
      // A coordinate, its voxel's corner and the quotient are each rounded once.
      constexpr double slack = 16.0 * std::numeric_limits<double>::epsilon();
      const double most = slack * (std::abs(p[axis]) + 3.0 * size);
      const double below = std::max(p[axis] - corner[axis] - most, 0.0);
      const double above = std::max(corner[axis] - p[axis] + size - most, 0.0);
      const double step = std::max(size - most, 0.0);
      squares_[static_cast<std::size_t>(axis)] = {square(below + step),
                                                  square(below),
                                                  0.0,
                                                  square(above),
                                                  square(above + step)};
    }
  }

  /** The square of the distance to the voxel at an offset. */
  double
  squared(const VoxelCell& offset) const
  {
    return squares_[0][at(offset[0])] + squares_[1][at(offset[1])] +
           squares_[2][at(offset[2])];
  }

  /** The square of the distance to all that is at least so many voxels away. */
  double
  squaredBeyond(std::int32_t steps) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& squares : squares_)
      least = std::min({least, squares[at(-steps)], squares[at(steps)]});
    return least;
  }

private:
  static std::size_t
  at(std::int32_t steps)
  {
    return static_cast<std::size_t>(steps + 2);
  }

  /** A squared distance is off by less than this share, and so is a squared gap. */
  static double
  square(double gap)
  {
    return gap * gap * (1.0 - 16.0 * std::numeric_limits<double>::epsilon());
  }

  std::array<std::array<double, 5>, 3>
      squares_; ///< for each axis, two steps down to up
};

} // namespace pcl_cid
