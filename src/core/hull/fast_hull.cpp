/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex hulls of few points, to compare hulls by, and which points they need.
 */

#include "fast_hull.h"

#include "box_mesh.h"
#include "clean_hull.h"
#include "principal_box.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace pcl_cid {
namespace {

using Corners = std::vector<Eigen::Vector3d>;

constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

/** A face while the hull grows. The points that only this face is asked about are a
 *  chain: allocating memory for each face would take as long as all else. */
struct GrowingFace {
  Triangle corners;   ///< counter-clockwise from outside
  Triangle neighbors; ///< across the side from each corner to the next
  HalfSpace half_space;
  std::uint32_t first = none; ///< of the chain
  std::uint32_t last = none;
  std::uint32_t farthest = none; ///< the first of those farthest outside
  double distance = 0.0;         ///< of the farthest
  bool is_alive = true;
};

/** A side of the hole that is left when the faces that see a point are gone. */
struct HorizonSide {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint32_t beyond;       ///< the face on the other side, which stays
  std::size_t side_of_beyond; ///< which of its sides this is; 3 where it is none
};

/** Quickhull: the farthest point outside of a face takes the place of all faces that it
 *  sees. */
class GrowingHull {
public:
  explicit GrowingHull(const Corners& points) : points_(points)
  {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : points)
      box.extend(p);
    tolerance_ = 1e-9 * box.diagonal().norm();
    faces_.reserve(256);
  }

  /** Begin with a tetrahedron of far points; false when there is none, as the points
   * are flat. */
  bool
  begin()
  {
    return points_.size() >= 4 && findTetrahedron();
  }

  /** False when rounding spoils the hull. */
  bool
  grow()
  {
    for (std::uint32_t f = 0; f < faces_.size(); ++f)
      if (faces_[f].is_alive && faces_[f].farthest != none)
        if (!add(faces_[f].farthest, f))
          return false;
    return true;
  }

  FastHull
  result() const
  {
    FastHull hull;
    std::vector<std::uint32_t> number(points_.size(), none);
    std::vector<std::uint32_t> face_number(faces_.size(), none);
    std::uint32_t faces = 0;
    for (std::size_t f = 0; f < faces_.size(); ++f)
      if (faces_[f].is_alive)
        face_number[f] = faces++;
    for (const GrowingFace& face : faces_) {
      if (!face.is_alive)
        continue;
      Triangle triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint32_t& known = number[face.corners[k]];
        if (known == none) {
          known = static_cast<std::uint32_t>(hull.vertices.size());
          hull.vertices.push_back(points_[face.corners[k]]);
          hull.corners.push_back(face.corners[k]);
        }
        triangle[k] = known;
      }
      hull.triangles.push_back(triangle);
      hull.neighbors.push_back({face_number[face.neighbors[0]],
                                face_number[face.neighbors[1]],
                                face_number[face.neighbors[2]]});
      hull.faces.push_back(face.half_space);
    }
    hull.volume = volumeOf(hull);
    return hull;
  }

private:
  const Eigen::Vector3d&
  at(std::uint32_t point) const
  {
    return points_[point];
  }

  template <typename Height>
  std::uint32_t
  highest(const Height& height) const
  {
    std::uint32_t best = 0;
    double most = -1.0;
    for (std::uint32_t i = 0; i < points_.size(); ++i)
      if (const double h = height(points_[i]); h > most) {
        most = h;
        best = i;
      }
    return best;
  }

  bool
  findTetrahedron()
  {
    const Eigen::Vector3d first = points_.front();
    const std::uint32_t a =
        highest([&](const Eigen::Vector3d& p) { return (p - first).squaredNorm(); });
    const std::uint32_t b =
        highest([&](const Eigen::Vector3d& p) { return (p - at(a)).squaredNorm(); });
    const Eigen::Vector3d line = (at(b) - at(a)).normalized();
    const auto off_line = [&](const Eigen::Vector3d& p) {
      return (p - at(a)).cross(line).norm();
    };
    const std::uint32_t c = highest(off_line);
    if (!(off_line(at(c)) > tolerance_))
      return false;
    const Eigen::Vector3d normal = line.cross(at(c) - at(a)).normalized();
    const auto off_plane = [&](const Eigen::Vector3d& p) {
      return std::abs(normal.dot(p - at(a)));
    };
    const std::uint32_t d = highest(off_plane);
    if (!(off_plane(at(d)) > tolerance_))
      return false;
    makeTetrahedron(a, b, c, d);
    return true;
  }

  void
  makeTetrahedron(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
  {
    const Eigen::Vector3d normal = (at(b) - at(a)).cross(at(c) - at(a));
    if (normal.dot(at(d) - at(a)) > 0.0)
      std::swap(b, c);
    addFace({a, b, c}, {3, 2, 1});
    addFace({a, c, d}, {0, 2, 3});
    addFace({c, b, d}, {0, 3, 1});
    addFace({b, a, d}, {0, 1, 2});
    next_.resize(points_.size());
    for (std::uint32_t i = 0; i < points_.size(); ++i)
      share(i, 0);
  }

  std::uint32_t
  addFace(const Triangle& corners, const Triangle& neighbors)
  {
    const Eigen::Vector3d& a = at(corners[0]);
    const Eigen::Vector3d normal =
        (at(corners[1]) - a).cross(at(corners[2]) - a).normalized();
    faces_.push_back({corners, neighbors, {normal, normal.dot(a)}});
    return static_cast<std::uint32_t>(faces_.size() - 1);
  }

  /** Give a point to the first of the faces from \a begin on that it is outside of. */
  void
  share(std::uint32_t point, std::size_t begin)
  {
    for (std::size_t f = begin; f < faces_.size(); ++f)
      if (const double distance = faces_[f].half_space.excess(at(point));
          distance > tolerance_)
        return give(point, distance, faces_[f]);
  }

  void
  give(std::uint32_t point, double distance, GrowingFace& face)
  {
    next_[point] = none;
    (face.last == none ? face.first : next_[face.last]) = point;
    face.last = point;
    if (distance > face.distance) {
      face.farthest = point;
      face.distance = distance;
    }
  }

  /** Find the faces that see a point, from \a f on. */
  void
  findVisible(std::uint32_t point, std::uint32_t f)
  {
    visible_ = {f};
    faces_[f].is_alive = false;
    for (std::size_t i = 0; i < visible_.size(); ++i)
      for (const std::uint32_t other : faces_[visible_[i]].neighbors)
        if (faces_[other].is_alive &&
            faces_[other].half_space.excess(at(point)) > -tolerance_) {
          faces_[other].is_alive = false;
          visible_.push_back(other);
        }
  }

  /** What is beyond the border of the visible faces. */
  void
  findHorizon()
  {
    horizon_.clear();
    for (const std::uint32_t seen : visible_)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = faces_[seen].neighbors[k];
        if (!faces_[other].is_alive)
          continue;
        const std::uint32_t begin = faces_[seen].corners[k];
        const std::uint32_t end = faces_[seen].corners[(k + 1) % 3];
        const Triangle& back = faces_[other].corners;
        const std::size_t side = static_cast<std::size_t>(
            std::find(back.begin(), back.end(), end) - back.begin());
        horizon_.push_back({begin, end, other, side});
      }
  }

  /** False when rounding has left the new faces without a closed border. */
  bool
  add(std::uint32_t point, std::uint32_t f)
  {
    findVisible(point, f);
    findHorizon();
    const std::size_t begin = faces_.size();
    for (const HorizonSide& side : horizon_) {
      if (side.side_of_beyond == 3)
        return false;
      const std::uint32_t made =
          addFace({side.begin, side.end, point}, {side.beyond, none, none});
      faces_[side.beyond].neighbors[side.side_of_beyond] = made;
    }
    if (!linkFrom(begin))
      return false;
    for (const std::uint32_t seen : visible_)
      shareAllOf(seen, begin, point);
    return true;
  }

  /** Make neighbors of the new faces, which have a point in common; false when one
   *  lacks a neighbor. */
  bool
  linkFrom(std::size_t begin)
  {
    for (std::size_t i = begin; i < faces_.size(); ++i)
      for (std::size_t j = begin; j < faces_.size(); ++j)
        if (faces_[i].corners[1] == faces_[j].corners[0]) {
          faces_[i].neighbors[1] = static_cast<std::uint32_t>(j);
          faces_[j].neighbors[2] = static_cast<std::uint32_t>(i);
        }
    return std::all_of(faces_.begin() + static_cast<std::ptrdiff_t>(begin),
                       faces_.end(),
                       [](const GrowingFace& face) {
                         return face.neighbors[1] != none && face.neighbors[2] != none;
                       });
  }

  /** Share the points of a face that is gone among the new ones. The point that was
   *  added is a corner now, even where rounding lifts it off a sliver of a face; each
   *  point is added once, so this ends. */
  void
  shareAllOf(std::uint32_t gone, std::size_t begin, std::uint32_t added)
  {
    for (std::uint32_t p = faces_[gone].first; p != none;) {
      const std::uint32_t following = next_[p];
      if (p != added)
        share(p, begin);
      p = following;
    }
  }

  const Corners& points_;
  double tolerance_;
  std::vector<GrowingFace> faces_;
  std::vector<std::uint32_t> next_; ///< for each point, the one after it in its chain
  std::vector<std::uint32_t> visible_;
  std::vector<HorizonSide> horizon_;
};

/** Whether each side is the other way around in the neighbor, so that the triangles
 *  close, and are those of one sphere. */
bool
isClosed(const FastHull& hull)
{
  for (std::size_t f = 0; f < hull.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = hull.neighbors[f][k];
      if (other >= hull.triangles.size())
        return false;
      const Triangle& back = hull.triangles[other];
      bool is_mutual = false;
      for (std::size_t j = 0; j < 3; ++j)
        is_mutual = is_mutual || (hull.neighbors[other][j] == f &&
                                  back[j] == hull.triangles[f][(k + 1) % 3] &&
                                  back[(j + 1) % 3] == hull.triangles[f][k]);
      if (!is_mutual)
        return false;
    }
  // V - E + F = 2, and E = 3/2 F
  return 2 * hull.vertices.size() == hull.triangles.size() + 4;
}

/** Asks all faces at once, which is faster than to end at the first that says no. */
bool
holdsAll(const FastHull& hull, const Corners& points)
{
  const auto count = static_cast<Eigen::Index>(hull.faces.size());
  Eigen::ArrayX3d normals(count, 3);
  Eigen::ArrayXd offsets(count);
  for (Eigen::Index f = 0; f < count; ++f) {
    const HalfSpace& face = hull.faces[static_cast<std::size_t>(f)];
    normals.row(f) = face.normal;
    offsets[f] = face.offset;
  }
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points)
    box.extend(p);
  const double tolerance = 1e-8 * box.diagonal().norm();
  return std::all_of(points.begin(), points.end(), [&](const Eigen::Vector3d& p) {
    return (normals.col(0) * p.x() + normals.col(1) * p.y() + normals.col(2) * p.z() -
            offsets)
               .maxCoeff() <= tolerance;
  });
}

/** A hull that was made in another way, as one of these. */
FastHull
asFastHull(TriangleMesh mesh)
{
  FastHull hull;
  static_cast<TriangleMesh&>(hull) = std::move(mesh);
  hull.faces = halfSpacesOf(hull);
  hull.volume = volumeOf(hull);
  hull.neighbors.resize(hull.triangles.size());
  const auto sideFrom = [&](std::uint32_t triangle, std::uint32_t begin) {
    const Triangle& corners = hull.triangles[triangle];
    return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), begin) -
                                    corners.begin());
  };
  for (const HullEdge& edge : edgesOf(hull)) {
    hull.neighbors[edge.triangle][sideFrom(edge.triangle, edge.begin)] = edge.neighbor;
    hull.neighbors[edge.neighbor][sideFrom(edge.neighbor, edge.end)] = edge.triangle;
  }
  return hull;
}

} // namespace

FastHull
fastHull(const std::vector<Eigen::Vector3d>& points)
{
  GrowingHull growing(points);
  if (!growing.begin())
    return {};
  if (growing.grow())
    if (FastHull hull = growing.result(); isClosed(hull) && holdsAll(hull, points))
      return hull;
  TriangleMesh exact = convexHull(points);
  return asFastHull(exact.triangles.empty() ? boxMesh(principalBox(points), 0)
                                            : std::move(exact));
}

double
hullVolume(const std::vector<Eigen::Vector3d>& points)
{
  GrowingHull growing(points);
  if (!growing.begin())
    return 0.0;
  return growing.grow() ? growing.result().volume : fastHull(points).volume;
}

} // namespace pcl_cid
