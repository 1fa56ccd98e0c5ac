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

#include <algorithm>
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
areaOf(const Triangle& t)
{
  return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
}

double
areaOf(const TriangleMesh& mesh)
{
  double area = 0.0;
  for (const auto& corners : mesh.triangles)
    area += areaOf(triangleOf(mesh, corners));
  if (!(area > 0.0) || !std::isfinite(area))
    throw CIDException(
        sentence("the surface has an area of ", area, "; it must be above 0"));
  return area;
}

double
longestEdge(const Triangle& t)
{
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

/** The length of all needles: triangles much longer and thinner than the spacing, which
 *  get a row of points although they have hardly any area. */
double
lengthOfNeedles(const TriangleMesh& mesh, double spacing)
{
  double length = 0.0;
  for (const auto& corners : mesh.triangles) {
    const Triangle t = triangleOf(mesh, corners);
    const double edge = longestEdge(t);
    if (edge > 4.0 * spacing && areaOf(t) < 0.125 * spacing * edge)
      length += edge;
  }
  return length;
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
    for (const Cell& step : stepsAround())
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
  stepsAround()
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

/** How many steps of at most this length make up a whole. */
std::size_t
steps(double whole, double longest_step)
{
  return std::max<std::size_t>(
      1, static_cast<std::size_t>(std::ceil(whole / longest_step)));
}

/** Offer points of a triangle so that each point of it is within 0.36 times the spacing
 *  of one: in rows along its longest edge, a quarter of the spacing apart, at steps of
 *  half of it. The angles at that edge are acute, so what is above a row projects into
 *  it. */
void
offerRows(Triangle t, double spacing, Thinning& thinning)
{
  const auto length = [&t](int k) { return (t[(k + 1) % 3] - t[k]).norm(); };
  while (length(0) < std::max(length(1), length(2)))
    std::rotate(t.begin(), t.begin() + 1, t.end());
  const Vector base = t[1] - t[0];
  const double height =
      base.isZero() ? 0.0 : base.cross(t[2] - t[0]).norm() / base.norm();
  const std::size_t rows = steps(height, 0.25 * spacing);
  for (std::size_t row = 0; row < rows; ++row) {
    const double up = static_cast<double>(row) / static_cast<double>(rows);
    const Vector from = t[0] + up * (t[2] - t[0]);
    const Vector along = (1.0 - up) * base;
    const std::size_t points = steps(along.norm(), 0.5 * spacing);
    for (std::size_t k = 0; k < points; ++k)
      thinning.offer(from + (static_cast<double>(k) + 0.5) /
                                static_cast<double>(points) * along);
  }
}

} // namespace

double
usualSpacing(const TriangleMesh& mesh)
{
  constexpr double usual_points = 200000.0;
  const double spacing = std::sqrt(usual_density * areaOf(mesh) / usual_points);
  return std::max(spacing, lengthOfNeedles(mesh, spacing) / usual_points);
}

std::vector<Eigen::Vector3d>
sampleSurface(const TriangleMesh& mesh, double spacing)
{
  require(setting::mesh_spacing.withoutZero(), spacing);
  const double expected = usual_density * areaOf(mesh) / (spacing * spacing) +
                          lengthOfNeedles(mesh, spacing) / spacing;
  if (!(expected < static_cast<double>(most_points)))
    throw CIDException(sentence("with a spacing of ",
                                spacing,
                                " the surface would have about ",
                                expected,
                                " points; at most ",
                                most_points,
                                " are possible"));
  double largest = 0.0;
  for (const Vector& vertex : mesh.vertices)
    largest = std::max(largest, vertex.cwiseAbs().maxCoeff());
  constexpr double fine = 1e12; // what double tells apart, and more
  if (largest > fine * spacing)
    throw CIDException(sentence("coordinates of ",
                                largest,
                                " are too large for a spacing of ",
                                spacing,
                                "; move the mesh nearer to the origin"));
  Thinning thinning(spacing);
  for (const auto& corners : mesh.triangles)
    offerRows(triangleOf(mesh, corners), spacing, thinning);
  return thinning.points();
}

} // namespace pcl_cid
