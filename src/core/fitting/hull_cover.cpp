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

/** Of a half-space, in units of places, the border that a column crosses or runs along:
 *  z = rest - x * X - y * Y, or else x * X + y * Y = rest. */
struct GridBorder {
  double x;
  double y;
  double rest;

  /** What is left for X in a row. */
  double
  restOf(int row) const
  {
    return rest - y * row;
  }
};

/** Half-spaces, by where they cut a column. */
struct GridBorders {
  std::vector<GridBorder> above;
  std::vector<GridBorder> below;
  std::vector<GridBorder> along;
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
  const Eigen::MatrixX3d vertices =
      Eigen::Map<const Eigen::Matrix3Xd>(
          hull.vertices[0].data(), 3, static_cast<Eigen::Index>(hull.vertices.size()))
          .transpose();
  for (HalfSpace& bound : bounds)
    bound.offset = (vertices * bound.normal).maxCoeff();
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

GridBorders
bordersOnGrid(const FastHull& hull, const FreeSpace& space, double radius)
{
  // Across all of a column such a border is off by less than a thousandth of a place.
  constexpr double upright = 1e-7;
  GridBorders borders;
  for (const HalfSpace& bound : boundsOf(hull)) {
    const Eigen::Vector3d normal = space.turned(bound.normal);
    const double rest =
        normal.dot(space.toGrid((bound.offset + radius) * bound.normal));
    const double z = normal.z();
    if (std::abs(z) <= upright)
      borders.along.push_back({normal.x(), normal.y(), rest});
    else
      (z > 0.0 ? borders.above : borders.below)
          .push_back({normal.x() / z, normal.y() / z, rest / z});
  }
  return borders;
}

/** A row of columns, and from where to where they are near a hull, along z. Heights are
 *  counted from the box, which keeps them small enough for float. */
class RowOfColumns {
public:
  explicit RowOfColumns(const GridBox& box)
  : box_(box)
  , low_(static_cast<std::size_t>(box.high.x() - box.low.x()))
  , high_(low_.size())
  {
  }

  void
  cut(const GridBorders& borders, int y)
  {
    begin_ = box_.low.x();
    end_ = box_.high.x();
    for (const GridBorder& border : borders.along)
      narrow(border.x, border.restOf(y));
    std::fill(low_.begin(), low_.end(), 0.0f);
    std::fill(high_.begin(),
              high_.end(),
              static_cast<float>(box_.high.z() - 1 - box_.low.z()));
    for (const GridBorder& border : borders.above)
      cut(border, y, high_, [](float a, float b) { return a < b ? a : b; });
    for (const GridBorder& border : borders.below)
      cut(border, y, low_, [](float a, float b) { return a > b ? a : b; });
  }

  /** Call \a visit with x, the first z and one past the last z of each column. */
  template <typename Visit>
  void
  forEachColumn(const Visit& visit) const
  {
    for (int x = begin_; x < end_; ++x) {
      const auto i = static_cast<std::size_t>(x - begin_);
      if (low_[i] <= high_[i])
        visit(x,
              box_.low.z() + static_cast<int>(std::ceil(low_[i])),
              box_.low.z() + static_cast<int>(std::floor(high_[i])) + 1);
    }
  }

private:
  /** Keep the columns with x * X <= rest. */
  void
  narrow(double x, double rest)
  {
    const auto clamped = [&](double column) {
      return static_cast<int>(
          std::clamp(column, static_cast<double>(begin_), static_cast<double>(end_)));
    };
    if (x > 0.0)
      end_ = clamped(std::floor(rest / x) + 1.0);
    else if (x < 0.0)
      begin_ = clamped(std::ceil(rest / x));
    else if (rest < 0.0)
      end_ = begin_;
  }

  template <typename Choose>
  void
  cut(const GridBorder& border, int y, std::vector<float>& bound, const Choose& choose)
  {
    const auto first =
        static_cast<float>(border.restOf(y) - border.x * begin_ - box_.low.z());
    const auto slope = static_cast<float>(border.x);
    const int count = end_ - begin_;
    float* const of_column = bound.data();
    for (int i = 0; i < count; ++i)
      of_column[i] = choose(first - slope * static_cast<float>(i), of_column[i]);
  }

  GridBox box_;
  int begin_ = 0;
  int end_ = 0;
  std::vector<float> low_;  ///< from the first column on that is left
  std::vector<float> high_; ///< below low_ where none is
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
  const GridBorders borders = bordersOnGrid(hull, space, radius);
  RowOfColumns row(box);
  bool goes_on = true;
  for (int y = box.low.y(); y < box.high.y() && goes_on; ++y) {
    row.cut(borders, y);
    row.forEachColumn([&](int x, int low, int high) {
      if (goes_on)
        space.forEachRange(x, y, low, high, [&](const PlaceRange& range) {
          goes_on = goes_on && visit(range);
        });
    });
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
