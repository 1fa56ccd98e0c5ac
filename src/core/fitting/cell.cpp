/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Some points, their hull, and the free places that it takes.
 */

#include "cell.h"

#include "hull_cover.h"
#include "hull_search.h"

#include <limits>
#include <utility>

namespace pcl_cid {
namespace {

/** The corners of a small cube about each point: their hull fills space. */
std::vector<Eigen::Vector3d>
cornersAround(const std::vector<Eigen::Vector3d>& points, double thickness)
{
  std::vector<Eigen::Vector3d> corners;
  corners.reserve(8 * points.size());
  for (const Eigen::Vector3d& p : points)
    for (int k = 0; k < 8; ++k)
      corners.push_back(p + 0.5 * thickness *
                                Eigen::Vector3d((k & 1) != 0 ? 1.0 : -1.0,
                                                (k & 2) != 0 ? 1.0 : -1.0,
                                                (k & 4) != 0 ? 1.0 : -1.0));
  return corners;
}

} // namespace

bool
FittingScene::keepsBound(const FastHull& hull) const
{
  if (max_error == std::numeric_limits<double>::infinity())
    return true;
  if (!deep)
    return !straysFarther(hull, field, max_error);
  return visitPlacesNear(hull, *deep, 0.0, [](const PlaceRange&) { return false; });
}

Cell
makeCell(pcl::Indices members, const FittingScene& scene)
{
  std::vector<Eigen::Vector3d> positions;
  positions.reserve(members.size());
  for (const pcl::index_t i : members)
    positions.push_back(scene.points[static_cast<std::size_t>(i)].cast<double>());
  const FastHull thin = fastHull(positions);
  Cell cell;
  cell.hull = fastHull(cornersAround(thin.vertices.empty() ? positions : thin.vertices,
                                     scene.thickness));
  cell.near = placesNear(cell.hull, scene.space, scene.robot_radius);
  cell.points = std::move(members);
  return cell;
}

std::size_t
placesTaken(const std::vector<Cell>& cells, const FreeSpace& space)
{
  std::vector<bool> taken(space.size());
  std::size_t count = 0;
  for (const Cell& cell : cells)
    for (const PlaceRange& range : cell.near)
      for (std::uint32_t place = range.begin; place < range.end; ++place)
        if (!taken[place]) {
          taken[place] = true;
          ++count;
        }
  return count;
}

} // namespace pcl_cid
