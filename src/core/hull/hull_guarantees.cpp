/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The guarantees of a hull, checked on its mesh alone.
 */

#include "base/sentence.h"
#include "surface_check.h"

#include <pcl_cid/core/hull_guarantees.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

using Verdict = std::optional<std::string>;
using Triangle = std::array<std::uint32_t, 3>;

/** A face, with what it takes to extrapolate its plane. */
struct Face {
  Eigen::Vector3d origin;     ///< its first corner
  Eigen::Vector3d normal;     ///< outward, of length 1
  Eigen::Vector3d gradient_1; ///< how the weight of the second corner grows,
  Eigen::Vector3d gradient_2; ///< and that of the third, away from the first

  double
  excess(const Eigen::Vector3d& p) const
  {
    return normal.dot(p - origin);
  }

  /** How far rounded coordinates may change the excess of p: the plane is extrapolated
   *  from the corners to p by their weights, which are large where the triangle is
   *  narrow and p is far off. */
  double
  doubt(const Eigen::Vector3d& p, double rounding) const
  {
    const double second = gradient_1.dot(p - origin);
    const double third = gradient_2.dot(p - origin);
    const double weights =
        std::abs(1.0 - second - third) + std::abs(second) + std::abs(third);
    return std::sqrt(3.0) * rounding * (1.0 + weights);
  }
};

std::vector<Face>
facesOf(const TriangleMesh& hull)
{
  std::vector<Face> faces;
  for (const auto& [first, second, third] : hull.triangles) {
    const Eigen::Vector3d& origin = hull.vertices[first];
    const Eigen::Vector3d a = hull.vertices[second] - origin;
    const Eigen::Vector3d b = hull.vertices[third] - origin;
    const Eigen::Vector3d normal = a.cross(b);
    faces.push_back({origin,
                     normal.normalized(),
                     b.cross(normal) / normal.squaredNorm(),
                     normal.cross(a) / normal.squaredNorm()});
  }
  return faces;
}

/** \brief Examines one hull, whose surface has passed its check. */
class Examination {
public:
  Examination(const TriangleMesh& hull,
              const ConvexPartOptions& options,
              double rounding)
  : hull_(hull), options_(options), faces_(facesOf(hull))
  {
    Eigen::AlignedBox3d box;
    double largest = 0.0;
    for (const Eigen::Vector3d& v : hull.vertices) {
      box.extend(v);
      largest = std::max(largest, v.cwiseAbs().maxCoeff());
    }
    diagonal_ = box.isEmpty() ? 0.0 : box.diagonal().norm();
    rounding_ = rounding + std::numeric_limits<double>::epsilon() * largest;
  }

  Verdict
  findTooManyVertices() const
  {
    const std::size_t most = options_.max_vertices;
    if (most == 0 || hull_.vertices.size() <= most)
      return {};
    return sentence("too many vertices: there are ",
                    hull_.vertices.size(),
                    "; at most ",
                    most,
                    " were asked for");
  }

  Verdict
  findHollow() const
  {
    for (std::size_t v = 0; v < hull_.vertices.size(); ++v)
      if (const double excess = excessOf(hull_.vertices[v]); excess > tolerance())
        return sentence("not convex: vertex ",
                        v,
                        " is ",
                        excess,
                        " metres outside the plane of a face; the tolerance is ",
                        tolerance());
    return {};
  }

  std::optional<PointOutside>
  findPointOutside(const std::vector<Eigen::Vector3d>& points) const
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      if (const double excess = excessOf(points[i]) + options_.padding;
          excess > tolerance())
        return PointOutside{i, excess, options_.padding, tolerance()};
    return {};
  }

  Verdict
  findThinDirection() const
  {
    const double least = options_.min_thickness * (1.0 - hull_tolerance) -
                         2.0 * std::sqrt(3.0) * rounding_;
    if (holdsBall(0.5 * least))
      return {};
    for (const Face& face : faces_)
      if (const double width = widthAlong(face.normal); width < least)
        return thinSentence(width);
    return findThinBetweenEdges(least);
  }

private:
  double
  tolerance() const
  {
    return hull_tolerance * diagonal_;
  }

  /** How far outside the hull a point is (negative: inside), less what rounding may
   *  explain. */
  double
  excessOf(const Eigen::Vector3d& p) const
  {
    double most = -std::numeric_limits<double>::infinity();
    for (const Face& face : faces_)
      if (const double excess = face.excess(p); excess > most)
        most = std::max(most, excess - face.doubt(p, rounding_));
    return most;
  }

  /** Whether a ball about the centroid is inside: no direction is thinner then. */
  bool
  holdsBall(double radius) const
  {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& v : hull_.vertices)
      center += v / static_cast<double>(hull_.vertices.size());
    return std::all_of(faces_.begin(), faces_.end(), [&](const Face& face) {
      return -face.excess(center) >= radius;
    });
  }

  double
  widthAlong(const Eigen::Vector3d& direction) const
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Eigen::Vector3d& v : hull_.vertices) {
      low = std::min(low, direction.dot(v));
      high = std::max(high, direction.dot(v));
    }
    return high - low;
  }

  Verdict
  thinSentence(double width) const
  {
    return sentence("too thin: the hull is ",
                    width,
                    " metres thick in one direction; at least ",
                    options_.min_thickness,
                    " was asked for");
  }

  /** An edge, with the normals of its two faces. */
  struct Edge {
    Eigen::Vector3d begin;
    Eigen::Vector3d direction;
    Eigen::Vector3d first;
    Eigen::Vector3d second;
  };

  std::vector<Edge>
  edges() const
  {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> face_of_edge;
    for (std::size_t t = 0; t < hull_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        face_of_edge[{hull_.triangles[t][k], hull_.triangles[t][(k + 1) % 3]}] = t;
    std::vector<Edge> edges;
    for (const auto& [ends, face] : face_of_edge) {
      if (ends.first > ends.second)
        continue;
      const Eigen::Vector3d& begin = hull_.vertices[ends.first];
      const std::size_t neighbor = face_of_edge.at({ends.second, ends.first});
      edges.push_back({begin,
                       hull_.vertices[ends.second] - begin,
                       faces_[face].normal,
                       faces_[neighbor].normal});
    }
    return edges;
  }

  /** Whether two edges may touch parallel planes that hold the body between them: on
   *  the sphere of directions, the arc between the normals of one crosses that of the
   *  other, or its mirror image. */
  static bool
  areAntipodal(const Edge& a, const Edge& b)
  {
    const auto separates = [](const Edge& arc, const Edge& other) {
      return arc.direction.dot(other.first) * arc.direction.dot(other.second) <= 0.0;
    };
    return separates(a, b) && separates(b, a);
  }

  /** The least width is along the normal of a face, or across two antipodal edges. */
  Verdict
  findThinBetweenEdges(double least) const
  {
    const std::vector<Edge> all = edges();
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = i + 1; j < all.size(); ++j) {
        if (!areAntipodal(all[i], all[j]))
          continue;
        const Eigen::Vector3d across = all[i].direction.cross(all[j].direction);
        if (!(std::abs(across.dot(all[i].begin - all[j].begin)) <
              least * across.norm()))
          continue;
        if (const double width = widthAlong(across.normalized()); width < least)
          return thinSentence(width);
      }
    return {};
  }

  const TriangleMesh& hull_;
  const ConvexPartOptions& options_;
  double diagonal_ = 0.0;
  double rounding_ = 0.0;
  std::vector<Face> faces_;
};

void
requireRounding(double rounding)
{
  if (!(rounding >= 0.0) || std::isinf(rounding))
    throw CIDException(sentence(
        "the rounding is ", rounding, "; it must be a number of metres, 0 or more"));
}

} // namespace

std::string
PointOutside::sentenceAbout(std::size_t name) const
{
  return sentence("point ",
                  name,
                  " is not contained: it is ",
                  excess,
                  " metres too far out, with a padding of ",
                  padding,
                  "; the tolerance is ",
                  tolerance);
}

double
floatRounding(const TriangleMesh& mesh)
{
  double largest = 0.0;
  for (const Eigen::Vector3d& v : mesh.vertices)
    largest = std::max(largest, v.cwiseAbs().maxCoeff());
  return floatRounding(largest);
}

double
floatRounding(double size)
{
  return 0.5 * static_cast<double>(std::numeric_limits<float>::epsilon()) * size;
}

std::optional<std::string>
findBrokenGuarantee(const TriangleMesh& hull,
                    const std::vector<Eigen::Vector3d>& points,
                    const ConvexPartOptions& options,
                    double rounding)
{
  requireValid(options);
  requireRounding(rounding);
  if (Verdict broken = findBrokenSurface(hull))
    return broken;
  const Examination examination(hull, options, rounding);
  if (Verdict broken = examination.findHollow())
    return broken;
  if (const auto outside = examination.findPointOutside(points))
    return outside->sentenceAbout(outside->point);
  if (Verdict broken = examination.findThinDirection())
    return broken;
  return examination.findTooManyVertices();
}

std::optional<PointOutside>
findPointOutside(const TriangleMesh& hull,
                 const std::vector<Eigen::Vector3d>& points,
                 const ConvexPartOptions& options,
                 double rounding)
{
  requireValid(options);
  requireRounding(rounding);
  return Examination(hull, options, rounding).findPointOutside(points);
}

} // namespace pcl_cid
