/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How far places are from hulls: exact, by the faces that can be seen from a place.
 */

#include "convex_body.h"

#include <algorithm>
#include <limits>

namespace pcl_cid::benchmarks {
namespace {

double
distanceToSegment(const Eigen::Vector3d& a,
                  const Eigen::Vector3d& b,
                  const Eigen::Vector3d& x)
{
  const Eigen::Vector3d way = b - a;
  const double share = std::clamp((x - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (x - a - share * way).norm();
}

/** \param[in] normal of the triangle, outward: corners run counter-clockwise about it
 *  \param[in] height of x above the triangle's plane */
double
distanceToTriangle(const std::array<Eigen::Vector3d, 3>& corners,
                   const Eigen::Vector3d& normal,
                   double height,
                   const Eigen::Vector3d& x)
{
  bool is_above = true;
  double to_edges = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Eigen::Vector3d& a = corners[k];
    const Eigen::Vector3d& b = corners[(k + 1) % corners.size()];
    is_above = is_above && normal.dot((b - a).cross(x - a)) >= 0.0;
    to_edges = std::min(to_edges, distanceToSegment(a, b, x));
  }
  return is_above ? std::max(height, 0.0) : to_edges;
}

} // namespace

ConvexBody::ConvexBody(const TriangleMesh& hull)
{
  for (const Eigen::Vector3d& v : hull.vertices)
    box_.extend(v);
  constexpr double digits = 1e-13; // of double, with three to spare
  rounding_ = digits * box_.max().cwiseMax(-box_.min()).maxCoeff();
  const std::vector<HalfSpace> half_spaces = halfSpacesOf(hull);
  for (std::size_t k = 0; k < half_spaces.size(); ++k) {
    const auto& [a, b, c] = hull.triangles[k];
    faces_.push_back(
        {half_spaces[k], {hull.vertices[a], hull.vertices[b], hull.vertices[c]}});
  }
}

bool
ConvexBody::contains(const Eigen::Vector3d& x) const
{
  return box_.contains(x) &&
         std::all_of(faces_.begin(), faces_.end(), [&](const Face& face) {
           return face.half_space.excess(x) <= 0.0;
         });
}

double
ConvexBody::distanceUpTo(double limit, const Eigen::Vector3d& x) const
{
  if (box_.exteriorDistance(x) >= limit)
    return limit;
  double nearest = limit;
  bool is_outside = false;
  for (const Face& face : faces_) {
    // The nearest place of the body is on a face whose plane x is outside of, and no
    // nearer than that plane. Of faces in one plane, rounding may hide the right one.
    const double height = face.half_space.excess(x);
    if (height >= limit)
      return limit;
    is_outside = is_outside || height > 0.0;
    if (height > -rounding_ && height < nearest)
      nearest = std::min(
          nearest, distanceToTriangle(face.corners, face.half_space.normal, height, x));
  }
  return is_outside ? nearest : 0.0;
}

bool
containedIn(const std::vector<ConvexBody>& bodies, const Eigen::Vector3d& x)
{
  return std::any_of(bodies.begin(), bodies.end(), [&](const ConvexBody& body) {
    return body.contains(x);
  });
}

double
distanceUpTo(double limit,
             const std::vector<ConvexBody>& bodies,
             const Eigen::Vector3d& x)
{
  for (const ConvexBody& body : bodies)
    limit = body.distanceUpTo(limit, x);
  return limit;
}

} // namespace pcl_cid::benchmarks
