/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Where a robot can be, and two places of it far apart.
 */

#include "free_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

namespace planning {
namespace {

/** Two directions nearer than this are the same, radians: a few pixels of a camera. */
constexpr float same_direction = 0.01F;

/** Steps along x, y and z; ordered, so that every run is the same. */
using Cell = std::array<int, 3>;

Place
placeOf(const Cell& cell, const FreeSpace& space, double spacing)
{
  return space.box.min() +
         spacing * Eigen::Map<const Eigen::Vector3i>(cell.data()).cast<double>();
}

std::set<Cell>
freeCells(const FreeSpace& space, double spacing)
{
  const Eigen::Vector3i last = (space.box.sizes() / spacing).cast<int>();
  std::set<Cell> cells;
  for (int x = 0; x <= last.x(); ++x)
    for (int y = 0; y <= last.y(); ++y)
      for (int z = 0; z <= last.z(); ++z)
        if (space.isFree(placeOf({x, y, z}, space, spacing)))
          cells.insert({x, y, z});
  return cells;
}

/** Take out of \a cells one of them and all that free ways along the grid lead to. */
std::vector<Cell>
takeConnected(std::set<Cell>& cells,
              const FreeSpace& space,
              double spacing,
              double step)
{
  std::vector<Cell> connected{cells.extract(cells.begin()).value()};
  for (std::size_t i = 0; i < connected.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int way : {-1, 1}) {
        const Cell from = connected[i];
        Cell to = from;
        to[axis] += way;
        if (cells.count(to) != 0 && isStraightWayFree(space,
                                                      placeOf(from, space, spacing),
                                                      placeOf(to, space, spacing),
                                                      step)) {
          cells.erase(to);
          connected.push_back(to);
        }
      }
  return connected;
}

/** The farthest first. */
void
sortByDistance(Places& places, const Place& from)
{
  std::stable_sort(
      places.begin(), places.end(), [&from](const Place& a, const Place& b) {
        return (a - from).squaredNorm() > (b - from).squaredNorm();
      });
}

} // namespace

View::View(const Cloud& scan)
{
  for (const pcl::PointXYZ& point : scan) {
    const float range = point.getVector3fMap().norm();
    if (range > 0.0F) {
      pcl::PointXYZ direction;
      direction.getVector3fMap() = point.getVector3fMap() / range;
      directions_->push_back(direction);
      ranges_.push_back(range);
    }
  }
  nearest_.setInputCloud(directions_);
}

bool
View::saw(const Place& place) const
{
  const double range = place.norm();
  if (range == 0.0)
    return true;
  pcl::PointXYZ direction;
  direction.getVector3fMap() = (place / range).cast<float>();
  pcl::Indices index(1);
  std::vector<float> distance2(1);
  nearest_.nearestKSearch(direction, 1, index, distance2);
  return distance2[0] <= same_direction * same_direction &&
         ranges_[static_cast<std::size_t>(index[0])] > range;
}

bool
isStraightWayFree(const FreeSpace& space,
                  const Place& from,
                  const Place& to,
                  double step)
{
  const int steps = static_cast<int>(std::ceil((to - from).norm() / step));
  for (int i = 0; i <= steps; ++i)
    if (!space.isFree(from + (to - from) * i / std::max(steps, 1)))
      return false;
  return true;
}

Places
connectedPlaces(const FreeSpace& space, double spacing, double step)
{
  std::set<Cell> cells = freeCells(space, spacing);
  std::vector<Cell> largest;
  while (!cells.empty()) {
    std::vector<Cell> connected = takeConnected(cells, space, spacing, step);
    if (connected.size() > largest.size())
      largest.swap(connected);
  }
  Places places;
  for (const Cell& cell : largest)
    places.push_back(placeOf(cell, space, spacing));
  return places;
}

Task
chooseTask(const FreeSpace& space, double spacing, double step)
{
  Places places = connectedPlaces(space, spacing, step);
  if (places.empty())
    throw std::runtime_error("no place is free");
  sortByDistance(places, space.box.center());
  const Place start = places.front();
  sortByDistance(places, start);
  const auto goal = std::find_if(places.begin(), places.end(), [&](const Place& place) {
    return !isStraightWayFree(space, start, place, step);
  });
  return {start, goal == places.end() ? places.front() : *goal};
}

} // namespace planning
