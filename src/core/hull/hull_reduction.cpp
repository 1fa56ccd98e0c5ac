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

/** None when the half-spaces leave the body open, as then no hull of their points has
 *  the inside point in it. */
Corners
cornersOf(const Corners& dual_points, const Duality& duality, double tolerance)
{
  Corners corners;
  for (const HalfSpace& face : halfSpacesOf(quickHull(dual_points))) {
    if (face.offset <= 0.0)
      return {};
    addIfNew(duality.cornerOf(face), tolerance, corners);
  }
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

/** A body that holds a hull, from which planes of the hull cut one corner after the
 *  other. */
class OuterBody {
public:
  /** \param[in] max_vertices of the body to begin with: a box, or a tetrahedron */
  OuterBody(const TriangleMesh& hull, std::size_t max_vertices)
  : duality_(hull)
  , margin_(0.25 * hull_tolerance * diagonalOf(hull))
  , faces_(loosened(halfSpacesOf(hull), margin_))
  {
    PrincipalBox box = principalBox(hull.vertices);
    box.extents.array() += 2.0 * margin_;
    const TriangleMesh start = boxMesh(box, max_vertices);
    for (const HalfSpace& half_space : halfSpacesOf(start))
      addIfNew(duality_.pointOf(half_space), same_plane, dual_points_);
    corners_ = start.vertices;
  }

  const Corners&
  corners() const
  {
    return corners_;
  }

  /** Cut away what is farthest outside; false when nothing is, or qhull fails. */
  bool
  cut()
  {
    const auto half_space = mostViolated(faces_, corners_, margin_);
    if (!half_space)
      return false;
    dual_points_.push_back(duality_.pointOf(*half_space));
    corners_ = cornersOf(dual_points_, duality_, margin_);
    return !corners_.empty();
  }

  /** Leave out planes, the first ones first, as long as what is left is a good body:
   *  later cuts have made some of them useless, and others nearly so. */
  template <typename IsGood>
  void
  leaveOutPlanes(const IsGood& is_good)
  {
    for (std::size_t i = 0; i < dual_points_.size();) {
      Corners fewer = dual_points_;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      Corners corners = cornersOf(fewer, duality_, margin_);
      if (corners.empty() || !is_good(corners)) {
        ++i;
        continue;
      }
      dual_points_ = std::move(fewer);
      corners_ = std::move(corners);
    }
  }

private:
  Duality duality_;
  double margin_;
  std::vector<HalfSpace> faces_;
  Corners dual_points_;
  Corners corners_;
};

} // namespace

TriangleMesh
reduceOutward(const TriangleMesh& hull, std::size_t max_vertices)
{
  if (max_vertices == 0 || hull.vertices.size() <= max_vertices)
    return hull;
  OuterBody body(hull, max_vertices);
  Corners corners = body.corners();
  while (body.cut() && body.corners().size() <= max_vertices)
    corners = body.corners();
  return convexHull(corners);
}

TriangleMesh
simplifyOutward(const TriangleMesh& hull,
                const std::function<bool(const TriangleMesh& body)>& may_replace)
{
  constexpr std::size_t corners_of_a_box = 8;
  if (hull.vertices.size() <= corners_of_a_box)
    return hull;
  OuterBody body(hull, 0);
  TriangleMesh best = hull;
  const auto isGood = [&](const Corners& corners) {
    TriangleMesh simpler = convexHull(corners);
    if (simpler.triangles.empty() || simpler.vertices.size() >= best.vertices.size() ||
        !may_replace(simpler))
      return false;
    best = std::move(simpler);
    return true;
  };
  while (!isGood(body.corners()))
    if (!body.cut() || body.corners().size() >= hull.vertices.size())
      return hull;
  body.leaveOutPlanes(isGood);
  return best;
}

} // namespace pcl_cid
