/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What scanners have seen to be free.
 */

#include "seen_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_cid {
namespace {

/** A cube around a viewpoint has six faces of side x side cells, of a degree each. */
constexpr int side = 90;
constexpr std::size_t cells = 6u * side * side;

/** The cell that a ray goes through. */
std::size_t
cellOf(const Eigen::Vector3d& direction)
{
  Eigen::Index axis = 0;
  const double longest = direction.cwiseAbs().maxCoeff(&axis);
  const auto cellAlong = [&](Eigen::Index other) {
    const double t = 0.5 + 0.5 * direction[other] / longest;
    return std::clamp(static_cast<int>(t * side), 0, side - 1);
  };
  const auto face = static_cast<int>(2 * axis) + (direction[axis] < 0.0 ? 1 : 0);
  return static_cast<std::size_t>((face * side + cellAlong((axis + 1) % 3)) * side +
                                  cellAlong((axis + 2) % 3));
}

} // namespace

SeenSpace::SeenSpace(const Points& points,
                     const std::vector<Eigen::Vector3d>& viewpoints,
                     double margin)
: margin_(margin)
{
  for (const Eigen::Vector3d& viewpoint : viewpoints)
    cubes_.push_back(cubeOf(points, viewpoint, viewpoints.size() == 1, margin));
}

SeenSpace::RangeCube
SeenSpace::cubeOf(const Points& points,
                  const Eigen::Vector3d& viewpoint,
                  bool is_only_one,
                  double margin)
{
  RangeCube cube{viewpoint, std::vector<float>(cells, 0.0f)};
  std::vector<float> nearest(cells, std::numeric_limits<float>::infinity());
  const auto forEachPoint = [&](const auto& visit) {
    for (const Eigen::Vector3f& p : points) {
      const Eigen::Vector3d direction = p.cast<double>() - viewpoint;
      const auto range = static_cast<float>(direction.norm());
      if (range > 0.0f)
        visit(cellOf(direction), range);
    }
  };
  if (!is_only_one)
    forEachPoint([&](std::size_t cell, float range) {
      nearest[cell] = std::min(nearest[cell], range);
    });
  forEachPoint([&](std::size_t cell, float range) {
    if (is_only_one || range <= 1.05f * nearest[cell] + static_cast<float>(margin))
      cube.farthest[cell] = std::max(cube.farthest[cell], range);
  });
  return cube;
}

bool
SeenSpace::isSeen(const Eigen::Vector3d& place) const
{
  return cubes_.empty() ||
         std::any_of(cubes_.begin(), cubes_.end(), [&](const RangeCube& cube) {
           const Eigen::Vector3d direction = place - cube.center;
           const double range = direction.norm();
           return range == 0.0 ||
                  range + margin_ <=
                      static_cast<double>(cube.farthest[cellOf(direction)]);
         });
}

} // namespace pcl_cid
