/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID of a set, by branch and bound over its hull.
 */

#include "base/sentence.h"
#include "hull_excess.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace pcl_cid {
namespace {

/** A piece of the hull: a tetrahedron, or less where the hull is flat. */
struct Simplex {
  std::array<Eigen::Vector3d, 4> corners;
  double most; ///< no place in it is farther from the surface

  bool
  operator<(const Simplex& other) const
  {
    return most < other.most;
  }
};

/** Certified bounds of the pieces of a hull, the most promising piece first. */
class HullSearch {
public:
  HullSearch(const DistanceField& field, double tolerance, double enough)
  : field_(field), tolerance_(tolerance), enough_(enough)
  {
  }

  void
  add(const std::array<Eigen::Vector3d, 4>& corners)
  {
    const Eigen::Vector3d center =
        0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    double radius = 0.0;
    for (const Eigen::Vector3d& corner : corners)
      radius = std::max(radius, (corner - center).norm());
    if (upper(center) + radius <= low_ + tolerance_) {
      high_ = std::max(high_, upper(center) + radius);
      return;
    }
    const double distance = at(center);
    low_ = std::max(low_, distance);
    pieces_.push({corners, distance + radius + slack_});
  }

  HullCID
  run()
  {
    while (!pieces_.empty() && low_ <= enough_) {
      const Simplex piece = pieces_.top();
      if (piece.most <= low_ + tolerance_) {
        high_ = std::max(high_, piece.most);
        break;
      }
      pieces_.pop();
      halve(piece);
    }
    return {low_, std::max(low_, high_)};
  }

  void
  startFrom(const Eigen::Vector3d& place)
  {
    low_ = std::max(low_, at(place));
    // Places are rounded to float before they are looked up.
    slack_ = std::max(slack_, 1e-6 * place.cwiseAbs().maxCoeff());
  }

private:
  double
  at(const Eigen::Vector3d& place) const
  {
    return static_cast<double>(field_.distance(place.cast<float>()));
  }

  double
  upper(const Eigen::Vector3d& place) const
  {
    return static_cast<double>(field_.bounds(place.cast<float>()).high) + slack_;
  }

  void
  halve(const Simplex& piece)
  {
    std::size_t first = 0;
    std::size_t second = 1;
    double longest = -1.0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (const double length = (piece.corners[i] - piece.corners[j]).squaredNorm();
            length > longest) {
          longest = length;
          first = i;
          second = j;
        }
    const Eigen::Vector3d middle = 0.5 * (piece.corners[first] + piece.corners[second]);
    std::array<Eigen::Vector3d, 4> half = piece.corners;
    half[first] = middle;
    add(half);
    half = piece.corners;
    half[second] = middle;
    add(half);
  }

  const DistanceField& field_;
  double tolerance_;
  double enough_;
  double low_ = 0.0;
  double high_ = 0.0;
  double slack_ = 0.0;
  std::priority_queue<Simplex> pieces_;
};

/** The point, segment, triangles or tetrahedra that make up the hull of some points. */
std::vector<std::array<Eigen::Vector3d, 4>>
piecesOf(const FastHull& hull)
{
  Eigen::Vector3d inside = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : hull.vertices)
    inside += v / static_cast<double>(hull.vertices.size());
  std::vector<std::array<Eigen::Vector3d, 4>> pieces;
  for (const Triangle& t : hull.triangles)
    pieces.push_back(
        {inside, hull.vertices[t[0]], hull.vertices[t[1]], hull.vertices[t[2]]});
  return pieces;
}

/** All tetrahedra of four of the points, for points that are flat: they cover the hull,
 *  by Caratheodory's theorem, even with three of them. */
std::vector<std::array<Eigen::Vector3d, 4>>
flatPieces(const std::vector<Eigen::Vector3d>& points)
{
  std::vector<std::array<Eigen::Vector3d, 4>> pieces;
  const Eigen::Vector3d& apex = points.front();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i; j < points.size(); ++j)
      pieces.push_back({apex, apex, points[i], points[j]});
  return pieces;
}

void
requireHullInput(const std::vector<Eigen::Vector3d>& points, double tolerance)
{
  if (points.empty())
    throw CIDException("a hull needs at least 1 point");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!points[i].allFinite())
      throw CIDException(sentence("point ", i, " of the hull is not finite"));
  if (!(tolerance > 0.0))
    throw CIDException(
        sentence("the tolerance is ", tolerance, "; it must be above 0 metres"));
}

} // namespace

HullCID
searchHull(const FastHull& hull,
           const DistanceField& field,
           double tolerance,
           double enough)
{
  HullSearch search(field, tolerance, enough);
  for (const Eigen::Vector3d& v : hull.vertices)
    search.startFrom(v);
  for (const auto& piece : piecesOf(hull))
    search.add(piece);
  return search.run();
}

bool
strayFrom(const FastHull& hull, const DistanceField& field, double most)
{
  constexpr double share = 0.05;
  const HullCID cid = searchHull(hull, field, share * most, most);
  return cid.high > most;
}

HullCID
hullCID(const std::vector<Eigen::Vector3d>& points,
        const DistanceField& field,
        double tolerance)
{
  requireHullInput(points, tolerance);
  const FastHull hull = fastHull(points);
  if (!hull.faces.empty())
    return searchHull(hull, field, tolerance, std::numeric_limits<double>::infinity());
  HullSearch search(field, tolerance, std::numeric_limits<double>::infinity());
  for (const Eigen::Vector3d& p : points)
    search.startFrom(p);
  for (const auto& piece : flatPieces(points))
    search.add(piece);
  return search.run();
}

} // namespace pcl_cid
