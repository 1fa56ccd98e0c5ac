/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points spread evenly over the surface of a mesh.
 */

#include "base/requirements.h"
#include "base/sentence.h"
#include "columns/point_columns.h"

#include <pcl_cid/core/settings.h>
#include <pcl_cid/io/mesh_surface.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace pcl_cid {
namespace {

using Vector = Eigen::Vector3d;
using Triangle = std::array<Vector, 3>;

/** Points that remain of a square of the spacing, about. */
constexpr double usual_density = 0.7;

Triangle
triangleOf(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& corners)
{
  return {
      mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]};
}

double
areaOf(const TriangleMesh& mesh)
{
  double area = 0.0;
  for (const auto& corners : mesh.triangles) {
    const Triangle t = triangleOf(mesh, corners);
    area += 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
  }
  if (!(area > 0.0) || !std::isfinite(area))
    throw CIDException(
        sentence("the surface has an area of ", area, "; it must be above 0"));
  return area;
}

/** Takes points that are not too near to those that it took. */
class Thinning {
public:
  explicit Thinning(double spacing) : spacing_(spacing) {}

  void
  offer(const Vector& point)
  {
    const Cell home = cellOf(point);
    if (isNear(point, home))
      return;
    for (const Cell& step : steps())
      if (isNear(point, {home[0] + step[0], home[1] + step[1], home[2] + step[2]}))
        return;
    if (points_.size() == most_points)
      throw CIDException(sentence("the surface would have more than ",
                                  most_points,
                                  " points; a larger spacing is needed"));
    const auto [place, is_new] = last_.emplace(home, points_.size());
    before_.push_back(is_new ? none : place->second);
    place->second = points_.size();
    points_.push_back(point);
  }

  std::vector<Vector>
  points()
  {
    return std::move(points_);
  }

private:
  /** A cube of the spacing. */
  using Cell = std::array<std::int64_t, 3>;

  struct CellHash {
    std::size_t
    operator()(const Cell& cell) const
    {
      std::uint64_t hash = 0;
      for (const std::int64_t each : cell)
        hash = (hash ^ static_cast<std::uint64_t>(each)) * 0x9E3779B97F4A7C15u;
      return hash ^ hash >> 32;
    }
  };

  static constexpr std::size_t none = ~std::size_t{0};

  /** To the cells around one, those that are likely to hold a near point first. */
  static const std::vector<Cell>&
  steps()
  {
    static const std::vector<Cell> steps = [] {
      std::vector<Cell> list;
      for (int shared = 1; shared <= 3; ++shared) // a face, an edge, a corner
        for (int x = -1; x <= 1; ++x)
          for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
              if (x * x + y * y + z * z == shared)
                list.push_back({x, y, z});
      return list;
    }();
    return steps;
  }

  Cell
  cellOf(const Vector& point) const
  {
    Cell cell;
    for (std::size_t axis = 0; axis < 3; ++axis)
      cell[axis] = static_cast<std::int64_t>(
          std::floor(point[static_cast<Eigen::Index>(axis)] / spacing_));
    return cell;
  }

  bool
  isNear(const Vector& point, const Cell& cell) const
  {
    const auto place = last_.find(cell);
    for (std::size_t i = place == last_.end() ? none : place->second; i != none;
         i = before_[i])
      if ((points_[i] - point).squaredNorm() < spacing_ * spacing_)
        return true;
    return false;
  }

  double spacing_;
  std::vector<Vector> points_;
  std::vector<std::size_t> before_; ///< the point before each in its cell, or none
  std::unordered_map<Cell, std::size_t, CellHash> last_; ///< the last point of a cell
};

/** Offer the middles of pieces of a triangle so small that each point of it is within a
 *  third of the spacing of one: the longest edge is halved until it is half the
 *  spacing. */
void
offerPieces(const Triangle& whole, double spacing, Thinning& thinning)
{
  std::vector<Triangle> open{whole};
  while (!open.empty()) {
    const Triangle t = open.back();
    open.pop_back();
    std::size_t longest = 0; // the edge that begins at this corner
    double squared_length = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double squared = (t[(k + 1) % 3] - t[k]).squaredNorm();
      if (squared > squared_length) {
        squared_length = squared;
        longest = k;
      }
    }
    if (squared_length <= 0.25 * spacing * spacing) {
      thinning.offer((t[0] + t[1] + t[2]) / 3.0);
      continue;
    }
    const Vector& from = t[longest];
    const Vector& to = t[(longest + 1) % 3];
    const Vector& apex = t[(longest + 2) % 3];
    const Vector middle = 0.5 * (from + to);
    open.push_back({middle, to, apex});
    open.push_back({from, middle, apex});
  }
}

} // namespace

double
usualSpacing(const TriangleMesh& mesh)
{
  constexpr double usual_points = 200000.0;
  return std::sqrt(usual_density * areaOf(mesh) / usual_points);
}

std::vector<Eigen::Vector3d>
sampleSurface(const TriangleMesh& mesh, double spacing)
{
  require(setting::mesh_spacing.withoutZero(), spacing);
  const double expected = usual_density * areaOf(mesh) / (spacing * spacing);
  if (!(expected < static_cast<double>(most_points)))
    throw CIDException(sentence("with a spacing of ",
                                spacing,
                                " the surface would have about ",
                                expected,
                                " points; at most ",
                                most_points,
                                " are possible"));
  Thinning thinning(spacing);
  for (const auto& corners : mesh.triangles)
    offerPieces(triangleOf(mesh, corners), spacing, thinning);
  return thinning.points();
}

} // namespace pcl_cid
