/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How far a body reaches out of a hull that it holds.
 */

#include "hull_distance.h"

#include "hull_mesh.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace pcl_cid {
namespace {

/** The squared distance from a place to a segment. */
double
toSegment(const Eigen::Vector3d& x, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d along = b - a;
  const double t = std::clamp((x - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (x - a - t * along).squaredNorm();
}

/** The squared distance from a place to a triangle: to its plane when the foot of the
 *  perpendicular is in it, else to one of its sides. */
double
toTriangle(const Eigen::Vector3d& x, const TriangleMesh& mesh, const Triangle& triangle)
{
  const Eigen::Vector3d normal = doubleAreaNormal(mesh, triangle).normalized();
  bool is_above = true;
  double to_sides = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d& a = mesh.vertices[triangle[i]];
    const Eigen::Vector3d& b = mesh.vertices[triangle[(i + 1) % 3]];
    is_above = is_above && normal.cross(b - a).dot(x - a) >= 0.0;
    to_sides = std::min(to_sides, toSegment(x, a, b));
  }
  const double to_plane = normal.dot(x - mesh.vertices[triangle[0]]);
  return is_above ? to_plane * to_plane : to_sides;
}

} // namespace

bool
staysNear(const TriangleMesh& hull, const TriangleMesh& body, double most)
{
  const std::vector<HalfSpace> faces = halfSpacesOf(hull);
  // The distance to a convex hull is convex: it is largest at a vertex.
  return std::all_of(
      body.vertices.begin(), body.vertices.end(), [&](const Eigen::Vector3d& x) {
        if (!isInside(faces, x, most))
          return false;
        return isInside(faces, x) ||
               std::any_of(hull.triangles.begin(),
                           hull.triangles.end(),
                           [&](const Triangle& triangle) {
                             return toTriangle(x, hull, triangle) <= most * most;
                           });
      });
}

} // namespace pcl_cid
