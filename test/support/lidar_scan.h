/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * An empty room as a scanner on a mount sees it, which hides the floor under it.
 */

#pragma once

#include "base/random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <pcl_cid/core/point_set.h>

namespace pcl_cid::test {

/** A scanner at the origin, the room around it; metres and degrees. */
struct LidarOptions {
  Eigen::AlignedBox3f room{Eigen::Vector3f(-3.0f, -2.5f, -1.3f),
                           Eigen::Vector3f(4.0f, 3.5f, 1.4f)};
  float blind = 38.0f;      ///< straight down to here it sees its own mount
  float mount_range = 0.2f; ///< so far away
  float azimuth_end = 360.0f;
  float step = 2.0f; ///< between two rays
  float noise = 0.004f;
};

/** How far it is to the side of the room, from inside, in a direction. */
inline float
rangeInRoom(const Eigen::AlignedBox3f& room, const Eigen::Vector3f& direction)
{
  float range = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    if (direction[axis] != 0.0f)
      range = std::min(range,
                       (direction[axis] > 0.0f ? room.max() : room.min())[axis] /
                           direction[axis]);
  return range;
}

inline Points
lidarScan(const LidarOptions& options)
{
  constexpr float degree = 0.017453293f;
  RandomGenerator generator(7);
  Points points;
  for (float azimuth = 0.0f; azimuth < options.azimuth_end; azimuth += options.step)
    for (float from_nadir = options.step; from_nadir < 180.0f;
         from_nadir += options.step) {
      const float out = std::sin(from_nadir * degree);
      const Eigen::Vector3f direction(out * std::cos(azimuth * degree),
                                      out * std::sin(azimuth * degree),
                                      -std::cos(from_nadir * degree));
      const float range = from_nadir < options.blind
                              ? options.mount_range
                              : rangeInRoom(options.room, direction);
      const float draw = static_cast<float>(drawBelow(generator, 2001)) / 1000.0f;
      points.emplace_back(direction * (range + options.noise * (draw - 1.0f)));
    }
  return points;
}

} // namespace pcl_cid::test
