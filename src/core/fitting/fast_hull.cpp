/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex hulls of few points, to compare hulls by.
 */

#include "fast_hull.h"

#include "hull/box_mesh.h"
#include "hull/clean_hull.h"
#include "hull/principal_box.h"

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

constexpr std::uint32_t no_face = static_cast<std::uint32_t>(-1);

/** A face while the hull grows. */
struct GrowingFace {
  Triangle corners; ///< counter-clockwise from outside
  std::array<std::uint32_t, 3>
      neighbors; ///< across the side from each corner to the next
  HalfSpace half_space;
  std::vector<std::uint32_t> outside{}; ///< points that only this face is asked about
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
      while (faces_[f].is_alive && !faces_[f].outside.empty())
        if (!add(farthestOutside(f), f))
          return false;
    return true;
  }

  FastHull
  result() const
  {
    FastHull hull;
    std::vector<std::uint32_t> number(points_.size(), no_face);
    std::vector<std::uint32_t> face_number(faces_.size(), no_face);
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
        if (known == no_face) {
          known = static_cast<std::uint32_t>(hull.vertices.size());
          hull.vertices.push_back(points_[face.corners[k]]);
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
    std::vector<std::uint32_t> all(points_.size());
    for (std::uint32_t i = 0; i < all.size(); ++i)
      all[i] = i;
    share(all, 0);
  }

  std::uint32_t
  addFace(const Triangle& corners, const std::array<std::uint32_t, 3>& neighbors)
  {
    const Eigen::Vector3d& a = at(corners[0]);
    const Eigen::Vector3d normal =
        (at(corners[1]) - a).cross(at(corners[2]) - a).normalized();
    faces_.push_back({corners, neighbors, {normal, normal.dot(a)}});
    return static_cast<std::uint32_t>(faces_.size() - 1);
  }

  /** Give points to the first of the faces from \a first on that they are outside of.
   */
  void
  share(const std::vector<std::uint32_t>& points, std::size_t first)
  {
    for (const std::uint32_t p : points)
      for (std::size_t f = first; f < faces_.size(); ++f)
        if (faces_[f].half_space.excess(at(p)) > tolerance_) {
          faces_[f].outside.push_back(p);
          break;
        }
  }

  std::uint32_t
  farthestOutside(std::uint32_t f) const
  {
    const GrowingFace& face = faces_[f];
    return *std::max_element(face.outside.begin(),
                             face.outside.end(),
                             [&](std::uint32_t p, std::uint32_t q) {
                               return face.half_space.excess(at(p)) <
                                      face.half_space.excess(at(q));
                             });
  }

  /** Remove the faces that see a point, from \a f on; what is beyond their border. */
  void
  removeVisible(std::uint32_t point,
                std::uint32_t f,
                std::vector<HorizonSide>& horizon,
                std::vector<std::uint32_t>& orphans)
  {
    std::vector<std::uint32_t> visible = {f};
    faces_[f].is_alive = false;
    for (std::size_t i = 0; i < visible.size(); ++i) {
      const std::uint32_t seen = visible[i];
      orphans.insert(
          orphans.end(), faces_[seen].outside.begin(), faces_[seen].outside.end());
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = faces_[seen].neighbors[k];
        if (faces_[other].is_alive &&
            faces_[other].half_space.excess(at(point)) > -tolerance_) {
          faces_[other].is_alive = false;
          visible.push_back(other);
        }
      }
    }
    for (const std::uint32_t seen : visible)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = faces_[seen].neighbors[k];
        if (!faces_[other].is_alive)
          continue;
        const std::uint32_t begin = faces_[seen].corners[k];
        const std::uint32_t end = faces_[seen].corners[(k + 1) % 3];
        const Triangle& back = faces_[other].corners;
        const std::size_t side = static_cast<std::size_t>(
            std::find(back.begin(), back.end(), end) - back.begin());
        horizon.push_back({begin, end, other, side});
      }
  }

  /** False when rounding has left the new faces without a closed border. */
  bool
  add(std::uint32_t point, std::uint32_t f)
  {
    std::vector<HorizonSide> horizon;
    std::vector<std::uint32_t> orphans;
    removeVisible(point, f, horizon, orphans);
    const std::size_t first = faces_.size();
    for (const HorizonSide& side : horizon) {
      if (side.side_of_beyond == 3)
        return false;
      const std::uint32_t made =
          addFace({side.begin, side.end, point}, {side.beyond, no_face, no_face});
      faces_[side.beyond].neighbors[side.side_of_beyond] = made;
    }
    for (std::size_t i = first; i < faces_.size(); ++i)
      for (std::size_t j = first; j < faces_.size(); ++j)
        if (faces_[i].corners[1] == faces_[j].corners[0]) {
          faces_[i].neighbors[1] = static_cast<std::uint32_t>(j);
          faces_[j].neighbors[2] = static_cast<std::uint32_t>(i);
        }
    // It is a corner now, even where rounding lifts it off a sliver of a face; each
    // point is added once, so this ends.
    orphans.erase(std::remove(orphans.begin(), orphans.end(), point), orphans.end());
    share(orphans, first);
    return std::all_of(faces_.begin() + static_cast<std::ptrdiff_t>(first),
                       faces_.end(),
                       [](const GrowingFace& face) {
                         return face.neighbors[1] != no_face &&
                                face.neighbors[2] != no_face;
                       });
  }

  const Corners& points_;
  double tolerance_;
  std::vector<GrowingFace> faces_;
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

bool
holdsAll(const FastHull& hull, const Corners& points)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points)
    box.extend(p);
  const double tolerance = 1e-8 * box.diagonal().norm();
  return std::all_of(points.begin(), points.end(), [&](const Eigen::Vector3d& p) {
    return isInside(hull.faces, p, tolerance);
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

} // namespace pcl_cid
