/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The least width of a convex polytope, over all directions.
 */

#include "hull_width.h"

#include "hull_mesh.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_cid {
namespace {

using Vertices = std::vector<Eigen::Vector3d>;

void
takeIfLess(const Width& width, Width& least)
{
  if (width.width < least.width)
    least = width;
}

/** The vertex that is farthest against a direction. */
std::size_t
lowest(const Vertices& vertices, const Eigen::Vector3d& direction)
{
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (const double height = direction.dot(vertices[i]); height < least) {
      least = height;
      best = i;
    }
  return best;
}

/** The vertex that lies opposite each face, and the least of the widths between. */
std::vector<std::size_t>
oppositeVertices(const TriangleMesh& hull,
                 const std::vector<HalfSpace>& faces,
                 Width& least)
{
  std::vector<std::size_t> opposite;
  opposite.reserve(faces.size());
  for (const HalfSpace& face : faces) {
    opposite.push_back(lowest(hull.vertices, face.normal));
    takeIfLess({face.normal, -face.excess(hull.vertices[opposite.back()])}, least);
  }
  return opposite;
}

/** The smaller of the distances between two points along two directions. Along all
 *  directions between these, it is no smaller: a cosine, where it is positive, is
 *  concave. */
double
leastBetween(const Eigen::Vector3d& from_to,
             const Eigen::Vector3d& one,
             const Eigen::Vector3d& other)
{
  return std::min(from_to.dot(one), from_to.dot(other));
}

double
cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** \brief A hull seen along one of its edges: a polygon, with the edge as a corner.
 *
 *  Between the normals of the edge's two faces, the width is that between this corner
 *  and the polygon's other side. It is least along one of the two normals, or across a
 *  side of the polygon; those are visited as by rotating callipers. */
class ViewAlongEdge {
public:
  ViewAlongEdge(const Vertices& vertices,
                const Eigen::Vector3d& corner,
                const Eigen::Vector3d& first_normal,
                const Eigen::Vector3d& second_normal)
  : x_axis_(first_normal)
  , y_axis_(
        (second_normal - second_normal.dot(first_normal) * first_normal).normalized())
  , last_(second_normal.dot(x_axis_), second_normal.dot(y_axis_))
  {
    points_.reserve(vertices.size());
    for (const Eigen::Vector3d& v : vertices)
      points_.emplace_back((v - corner).dot(x_axis_), (v - corner).dot(y_axis_));
  }

  /** \brief Lower \a least, if the hull is thinner somewhere between the normals.
   *  \param[in] opposite the vertex opposite the first face */
  void
  improve(std::size_t opposite, Width& least) const
  {
    Eigen::Vector2d at = points_[opposite];
    for (std::size_t step = 0; step < points_.size(); ++step) {
      const Eigen::Vector2d side = nextCorner(at) - at;
      const Eigen::Vector2d direction =
          Eigen::Vector2d(-side.y(), side.x()).normalized();
      if (!(cross(direction, last_) > 0.0))
        return;
      if (-direction.dot(at) < least.width)
        takeIfLess(
            {direction.x() * x_axis_ + direction.y() * y_axis_, widthAlong(direction)},
            least);
      at += side;
    }
  }

private:
  double
  widthAlong(const Eigen::Vector2d& direction) const
  {
    double low = 0.0;
    double high = 0.0;
    for (const Eigen::Vector2d& p : points_) {
      low = std::min(low, direction.dot(p));
      high = std::max(high, direction.dot(p));
    }
    return high - low;
  }

  /** The next corner, counter-clockwise: all points lie to the left of the way there.
   */
  Eigen::Vector2d
  nextCorner(const Eigen::Vector2d& at) const
  {
    Eigen::Vector2d best = at;
    for (const Eigen::Vector2d& p : points_) {
      const double turn = cross(best - at, p - at);
      if (turn < 0.0 ||
          (turn == 0.0 && (p - at).squaredNorm() > (best - at).squaredNorm()))
        best = p;
    }
    return best;
  }

  Eigen::Vector3d x_axis_;
  Eigen::Vector3d y_axis_;
  Eigen::Vector2d last_; ///< the second normal
  std::vector<Eigen::Vector2d> points_;
};

} // namespace

Width
leastWidth(const TriangleMesh& hull)
{
  const std::vector<HalfSpace> faces = halfSpacesOf(hull);
  Width least;
  const std::vector<std::size_t> opposite = oppositeVertices(hull, faces, least);
  for (const HullEdge& edge : edgesOf(hull)) {
    const Eigen::Vector3d& corner = hull.vertices[edge.begin];
    const Eigen::Vector3d& first = faces[edge.triangle].normal;
    const Eigen::Vector3d& second = faces[edge.neighbour].normal;
    const double bound = std::max(
        leastBetween(corner - hull.vertices[opposite[edge.triangle]], first, second),
        leastBetween(corner - hull.vertices[opposite[edge.neighbour]], first, second));
    if (bound < least.width)
      ViewAlongEdge(hull.vertices, corner, first, second)
          .improve(opposite[edge.triangle], least);
  }
  return least;
}

} // namespace pcl_cid
