/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID of a set, by branch and bound over its hull.
 */

#include "base/sentence.h"
#include "hull_search.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
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
    const double distance = at(place);
    low_ = std::max(low_, distance);
    // Places are rounded to float before they are looked up, and so are distances; to
    // ask for more would never end.
    slack_ = std::max({slack_, 1e-6 * place.cwiseAbs().maxCoeff(), 1e-6 * distance});
    tolerance_ = std::max(tolerance_, 2.0 * slack_);
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

/** The farthest of some points by a measure. */
template <typename Measure>
const Eigen::Vector3d&
farthest(const std::vector<Eigen::Vector3d>& points, const Measure& measure)
{
  return *std::max_element(points.begin(),
                           points.end(),
                           [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                             return measure(a) < measure(b);
                           });
}

/** The corners of the polygon around points that are flat, in order; of those on a line
 *  its ends (Andrew's monotone chain). */
std::vector<Eigen::Vector3d>
outlineOf(const std::vector<Eigen::Vector3d>& points)
{
  const Eigen::Vector3d& first = points.front();
  const Eigen::Vector3d x =
      (farthest(points, [&](const auto& p) { return (p - first).squaredNorm(); }) -
       first)
          .normalized();
  const auto offLine = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return p - first - x.dot(p - first) * x;
  };
  const Eigen::Vector3d y = offLine(farthest(points, [&](const auto& p) {
                              return offLine(p).squaredNorm();
                            })).normalized();

  struct OnPlane {
    double u;
    double v;
    std::size_t index;

    bool
    operator<(const OnPlane& other) const
    {
      return std::tie(u, v, index) < std::tie(other.u, other.v, other.index);
    }
  };
  std::vector<OnPlane> sorted;
  for (std::size_t i = 0; i < points.size(); ++i)
    sorted.push_back({x.dot(points[i] - first), y.dot(points[i] - first), i});
  std::sort(sorted.begin(), sorted.end());
  const auto turnsLeft = [](const OnPlane& a, const OnPlane& b, const OnPlane& c) {
    return (b.u - a.u) * (c.v - a.v) > (b.v - a.v) * (c.u - a.u);
  };
  std::vector<Eigen::Vector3d> outline;
  for (int half = 0; half < 2; ++half) {
    std::vector<OnPlane> chain;
    for (const OnPlane& p : sorted) {
      while (chain.size() > 1 && !turnsLeft(chain[chain.size() - 2], chain.back(), p))
        chain.pop_back();
      chain.push_back(p);
    }
    // The end of each half is the beginning of the other.
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      outline.push_back(points[chain[i].index]);
    std::reverse(sorted.begin(), sorted.end());
  }
  return outline.empty() ? std::vector<Eigen::Vector3d>{first} : outline;
}

/** The triangles of that polygon. */
std::vector<std::array<Eigen::Vector3d, 4>>
flatPieces(const std::vector<Eigen::Vector3d>& points)
{
  const std::vector<Eigen::Vector3d> outline = outlineOf(points);
  std::vector<std::array<Eigen::Vector3d, 4>> pieces;
  for (std::size_t i = 0; i < outline.size(); ++i)
    pieces.push_back({outline.front(),
                      outline.front(),
                      outline[i],
                      outline[(i + 1) % outline.size()]});
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
straysFarther(const FastHull& hull, const DistanceField& field, double most)
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
