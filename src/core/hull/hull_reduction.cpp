/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Fewer vertices, around the same points.
 */

#include "hull_reduction.h"

#include "box_mesh.h"
#include "clean_hull.h"
#include "hull_mesh.h"
#include "principal_box.h"
#include "quick_hull.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {
namespace {

using Corners = std::vector<Eigen::Vector3d>;

/** Distance of dual points below which their planes are the same. */
constexpr double same_plane = 1e-6;

/** A half-space about an inside point is the point normal / offset; the half-spaces
 *  that bound their intersection are the corners of those points' hull, and each of
 *  its faces is a corner of the intersection. Both are scaled to the box, so that thin
 *  bodies are as round as others. */
class Duality {
public:
  explicit Duality(const TriangleMesh& hull)
  : box_(principalBox(hull.vertices)), inside_(centroidOf(hull))
  {
  }

  Eigen::Vector3d
  pointOf(const HalfSpace& half_space) const
  {
    const Eigen::Vector3d scaled =
        (box_.axes.transpose() * half_space.normal).cwiseProduct(box_.extents);
    return scaled / -half_space.excess(inside_);
  }

  /** \brief The corner that a face of the hull of the dual points is. */
  Eigen::Vector3d
  cornerOf(const HalfSpace& face) const
  {
    return inside_ + box_.axes * (face.normal / face.offset).cwiseProduct(box_.extents);
  }

private:
  PrincipalBox box_;
  Eigen::Vector3d inside_;
};

/** Two triangles may lie in one plane, and more than three planes meet in a corner. */
void
addIfNew(const Eigen::Vector3d& p, double tolerance, Corners& points)
{
  if (std::none_of(points.begin(), points.end(), [&](const Eigen::Vector3d& other) {
        return (p - other).squaredNorm() <= tolerance * tolerance;
      }))
    points.push_back(p);
}

Corners
cornersOf(const Corners& dual_points, const Duality& duality, double tolerance)
{
  Corners corners;
  for (const HalfSpace& face : halfSpacesOf(quickHull(dual_points)))
    addIfNew(duality.cornerOf(face), tolerance, corners);
  return corners;
}

/** How far the farthest corner is outside. */
double
excessOf(const Corners& corners, const HalfSpace& half_space)
{
  double highest = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& corner : corners)
    highest = std::max(highest, half_space.normal.dot(corner));
  return highest - half_space.offset;
}

/** Moved outward by \a margin: what rounding and the clean hull take away later. */
std::vector<HalfSpace>
loosened(std::vector<HalfSpace> half_spaces, double margin)
{
  for (HalfSpace& half_space : half_spaces)
    half_space.offset += margin;
  return half_spaces;
}

/** The half-space that a corner is farthest outside of, if any is by more than
 *  \a tolerance. */
std::optional<HalfSpace>
mostViolated(const std::vector<HalfSpace>& half_spaces,
             const Corners& corners,
             double tolerance)
{
  std::optional<HalfSpace> most;
  double most_excess = tolerance;
  for (const HalfSpace& half_space : half_spaces)
    if (const double excess = excessOf(corners, half_space); excess > most_excess) {
      most_excess = excess;
      most = half_space;
    }
  return most;
}

} // namespace

TriangleMesh
reduceOutward(const TriangleMesh& hull, std::size_t max_vertices)
{
  if (max_vertices == 0 || hull.vertices.size() <= max_vertices)
    return hull;
  const double margin = 0.25 * hull_tolerance * diagonalOf(hull);
  const std::vector<HalfSpace> faces = loosened(halfSpacesOf(hull), margin);
  PrincipalBox box = principalBox(hull.vertices);
  box.extents.array() += 2.0 * margin;
  const TriangleMesh start = boxMesh(box, max_vertices);
  const Duality duality(hull);
  Corners dual_points;
  for (const HalfSpace& half_space : halfSpacesOf(start))
    addIfNew(duality.pointOf(half_space), same_plane, dual_points);

  Corners corners = start.vertices;
  while (const auto cut = mostViolated(faces, corners, margin)) {
    dual_points.push_back(duality.pointOf(*cut));
    Corners cut_corners = cornersOf(dual_points, duality, margin);
    if (cut_corners.empty() || cut_corners.size() > max_vertices)
      break;
    corners = std::move(cut_corners);
  }
  return convexHull(corners);
}

} // namespace pcl_cid
