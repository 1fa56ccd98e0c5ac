/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The free places that a hull takes from a robot.
 */

#include "hull_cover.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pcl_cid {
namespace {

/** A half-space in units of places: x, y, z count them from the first one. */
struct GridPlane {
  float x;
  float y;
  float z;
  float offset;
};

/** Number of places from the first one. */
struct GridBox {
  Eigen::Array3i low;
  Eigen::Array3i high; ///< one past the last
};

/** Bevels of the edges at which the normals turn by more than 60 degrees. */
void
addBevels(const FastHull& hull, std::vector<HalfSpace>& half_spaces)
{
  for (std::uint32_t f = 0; f < hull.faces.size(); ++f)
    for (std::size_t side = 0; side < 3; ++side) {
      const std::uint32_t other = hull.neighbors[f][side];
      const Eigen::Vector3d& normal = hull.faces[f].normal;
      const Eigen::Vector3d sum = normal + hull.faces[other].normal;
      const bool is_sharp = normal.dot(hull.faces[other].normal) <= 0.5;
      if (f < other && is_sharp && sum.squaredNorm() > 1e-6)
        half_spaces.push_back({sum.normalized(), 0.0});
    }
}

/** The faces, each direction once, and bevels. */
std::vector<HalfSpace>
boundsOf(const FastHull& hull)
{
  constexpr double same_direction = 1.0 - 1e-4;
  std::vector<HalfSpace> bounds;
  for (const HalfSpace& face : hull.faces) {
    const auto same =
        std::find_if(bounds.begin(), bounds.end(), [&](const HalfSpace& known) {
          return known.normal.dot(face.normal) > same_direction;
        });
    if (same == bounds.end())
      bounds.push_back(face);
  }
  addBevels(hull, bounds);
  for (HalfSpace& bound : bounds) {
    bound.offset = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& v : hull.vertices)
      bound.offset = std::max(bound.offset, bound.normal.dot(v));
  }
  return bounds;
}

GridBox
boxOf(const FastHull& hull, const FreeSpace& space, double radius)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : hull.vertices)
    box.extend(space.toGrid(v));
  const double places = radius / space.step();
  // Before they are int: a place may be far smaller than a hull.
  const Eigen::Array3d most = space.places().cast<double>();
  const Eigen::Array3d low = (box.min().array() - places).ceil();
  const Eigen::Array3d high = (box.max().array() + places).floor() + 1.0;
  return {low.max(0.0).min(most).cast<int>(), high.max(0.0).min(most).cast<int>()};
}

std::vector<GridPlane>
planesOnGrid(const FastHull& hull, const FreeSpace& space, double radius)
{
  std::vector<GridPlane> planes;
  for (const HalfSpace& bound : boundsOf(hull)) {
    const Eigen::Vector3d normal = space.turned(bound.normal);
    const double offset =
        normal.dot(space.toGrid((bound.offset + radius) * bound.normal));
    planes.push_back({static_cast<float>(normal.x()),
                      static_cast<float>(normal.y()),
                      static_cast<float>(normal.z()),
                      static_cast<float>(offset)});
  }
  return planes;
}

/** From where to where the columns of a row are near a hull, along z. */
struct RowOfColumns {
  std::vector<float> low;
  std::vector<float> high; ///< below low where none is

  explicit RowOfColumns(std::size_t width) : low(width), high(width) {}

  void
  reset(const GridBox& box)
  {
    std::fill(low.begin(), low.end(), static_cast<float>(box.low.z()));
    std::fill(high.begin(), high.end(), static_cast<float>(box.high.z() - 1));
  }

  /** Cut off what is above a plane: x * plane.x + z * plane.z <= rest. */
  void
  cut(const GridPlane& plane, float rest, int first)
  {
    // Across all of a column such a plane is off by less than a thousandth of a place.
    constexpr float upright = 1e-7f;
    const std::size_t width = low.size();
    const auto x = [&](std::size_t i) {
      return static_cast<float>(first + static_cast<int>(i));
    };
    if (plane.z > upright)
      for (std::size_t i = 0; i < width; ++i)
        high[i] = std::min(high[i], (rest - plane.x * x(i)) / plane.z);
    else if (plane.z < -upright)
      for (std::size_t i = 0; i < width; ++i)
        low[i] = std::max(low[i], (rest - plane.x * x(i)) / plane.z);
    else
      for (std::size_t i = 0; i < width; ++i)
        high[i] = plane.x * x(i) > rest ? -1.0f : high[i];
  }
};

} // namespace

bool
visitPlacesNear(const FastHull& hull,
                const FreeSpace& space,
                double radius,
                const std::function<bool(const PlaceRange&)>& visit)
{
  const GridBox box = boxOf(hull, space, radius);
  if (hull.faces.empty() || (box.low >= box.high).any())
    return true;
  const std::vector<GridPlane> planes = planesOnGrid(hull, space, radius);
  RowOfColumns row(static_cast<std::size_t>(box.high.x() - box.low.x()));
  bool goes_on = true;
  for (int y = box.low.y(); y < box.high.y() && goes_on; ++y) {
    row.reset(box);
    for (const GridPlane& plane : planes)
      row.cut(plane, plane.offset - plane.y * static_cast<float>(y), box.low.x());
    for (std::size_t i = 0; i < row.low.size() && goes_on; ++i)
      if (row.low[i] <= row.high[i])
        space.forEachRange(
            box.low.x() + static_cast<int>(i),
            y,
            static_cast<int>(std::ceil(row.low[i])),
            static_cast<int>(std::floor(row.high[i])) + 1,
            [&](const PlaceRange& range) { goes_on = goes_on && visit(range); });
  }
  return goes_on;
}

std::vector<PlaceRange>
placesNear(const FastHull& hull, const FreeSpace& space, double radius)
{
  std::vector<PlaceRange> near;
  visitPlacesNear(hull, space, radius, [&](const PlaceRange& range) {
    near.push_back(range);
    return true;
  });
  return near;
}

} // namespace pcl_cid
