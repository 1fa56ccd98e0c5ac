/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The grid of free places from outside: where its places are.
 */

#pragma once

#include "fitting/free_space.h"

#include <vector>

#include <Eigen/Dense>

namespace pcl_cid::test {

/** From the grid to the scan: the columns are one place along each axis of the grid. */
inline Eigen::Matrix3d
gridSteps(const FreeSpace& space)
{
  Eigen::Matrix3d to_grid;
  for (int axis = 0; axis < 3; ++axis)
    to_grid.col(axis) = space.turned(Eigen::Vector3d::Unit(axis)) / space.step();
  return to_grid.inverse();
}

/** The axes of the grid, in the scan. */
inline Eigen::Matrix3d
gridAxes(const FreeSpace& space)
{
  return gridSteps(space) / space.step();
}

/** Where a place is that is known by its numbers along the axes. */
inline Eigen::Vector3d
placeAt(const FreeSpace& space, const Eigen::Vector3d& numbers)
{
  return gridSteps(space) * (numbers - space.toGrid(Eigen::Vector3d::Zero()));
}

/** Calls \a visit(x, y, z, number of the place) for all free places. */
template <typename Visit>
void
forEachFreePlace(const FreeSpace& space, const Visit& visit)
{
  for (int y = 0; y < space.places().y(); ++y)
    for (int x = 0; x < space.places().x(); ++x)
      for (int z = 0; z < space.places().z(); ++z)
        space.forEachRange(x, y, z, z + 1, [&](const PlaceRange& one) {
          visit(Eigen::Vector3i(x, y, z), one.begin);
        });
}

/** All of them, by number. */
inline std::vector<Eigen::Vector3d>
freePlaces(const FreeSpace& space)
{
  const Eigen::Matrix3d steps = gridSteps(space);
  const Eigen::Vector3d first = placeAt(space, Eigen::Vector3d::Zero());
  std::vector<Eigen::Vector3d> places(space.size());
  forEachFreePlace(space, [&](const Eigen::Vector3i& at, std::uint32_t number) {
    places.at(number) = first + steps * at.cast<double>();
  });
  return places;
}

} // namespace pcl_cid::test
