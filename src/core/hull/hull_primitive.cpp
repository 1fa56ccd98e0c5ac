/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Boxes, balls and rods in the place of hulls.
 */

#include "base/parallel_for.h"
#include "base/sentence.h"
#include "box_mesh.h"
#include "clean_hull.h"
#include "enclosing_ball.h"
#include "hull_mesh.h"

#include <pcl_cid/core/hull_primitive.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

using Kind = HullPrimitive::Kind;
using Vertices = std::vector<Eigen::Vector3d>;

constexpr double pi = 3.14159265358979323846;

/** The smallest box with these axes. */
HullPrimitive
boxAlong(const Eigen::Matrix3d& axes, const Vertices& vertices)
{
  Eigen::AlignedBox3d local;
  for (const Eigen::Vector3d& v : vertices)
    local.extend(axes.transpose() * v);
  return {Kind::box, axes * local.center(), axes, local.sizes()};
}

HullPrimitive
sphereAround(const Vertices& vertices)
{
  constexpr int steps = 1000;
  const Ball<3> ball = enclosingBall<3>(vertices, steps);
  return {Kind::sphere,
          ball.center,
          Eigen::Matrix3d::Identity(),
          Eigen::Vector3d::Constant(2.0 * ball.radius)};
}

/** How a rod along an axis may be: its circle, and the vertices seen along it. */
struct RodSearch {
  RodSearch(const Eigen::Matrix3d& axes, const Vertices& vertices)
  {
    constexpr int steps = 200;
    for (const Eigen::Vector3d& v : vertices) {
      const Eigen::Vector3d local = axes.transpose() * v;
      across.emplace_back(local.head<2>());
      along.push_back(local.z());
    }
    circle = enclosingBall<2>(across, steps);
  }

  HullPrimitive
  from(Kind kind, const Eigen::Matrix3d& axes, double low, double high) const
  {
    const Eigen::Vector3d center(
        circle.center.x(), circle.center.y(), 0.5 * (low + high));
    return {kind,
            axes * center,
            axes,
            {2.0 * circle.radius, 2.0 * circle.radius, high - low}};
  }

  std::vector<Eigen::Vector2d> across;
  std::vector<double> along;
  Ball<2> circle;
};

HullPrimitive
cylinderAlong(const Eigen::Matrix3d& axes, const Vertices& vertices)
{
  const RodSearch rod(axes, vertices);
  const auto [low, high] = std::minmax_element(rod.along.begin(), rod.along.end());
  return rod.from(Kind::cylinder, axes, *low, *high);
}

/** A vertex that is off the axis is held by the end of a capsule, too: the centers of
 *  the ends need not go as far as it. */
HullPrimitive
capsuleAlong(const Eigen::Matrix3d& axes, const Vertices& vertices)
{
  const RodSearch rod(axes, vertices);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const double off = (rod.across[i] - rod.circle.center).norm();
    const double reach =
        std::sqrt(std::max(0.0, rod.circle.radius * rod.circle.radius - off * off));
    low = std::min(low, rod.along[i] + reach);
    high = std::max(high, rod.along[i] - reach);
  }
  if (low > high) // any ball between holds all
    low = high = 0.5 * (low + high);
  return rod.from(
      Kind::capsule, axes, low - rod.circle.radius, high + rod.circle.radius);
}

HullPrimitive
along(Kind kind, const Eigen::Matrix3d& axes, const Vertices& vertices)
{
  switch (kind) {
  case Kind::box:
    return boxAlong(axes, vertices);
  case Kind::cylinder:
    return cylinderAlong(axes, vertices);
  case Kind::capsule:
    return capsuleAlong(axes, vertices);
  default:
    return sphereAround(vertices);
  }
}

/** The same axes, turned so that another one is the third. */
Eigen::Matrix3d
withThird(const Eigen::Matrix3d& axes, int third)
{
  Eigen::Matrix3d turned;
  for (int i = 0; i < 3; ++i)
    turned.col(i) = axes.col((third + 1 + i) % 3);
  return turned;
}

/** The box with a side of a face and its normal among its axes that is the smallest. A
 *  smallest box touches the hull in such places. */
HullPrimitive
boxOnFaces(const TriangleMesh& hull, HullPrimitive best)
{
  for (const Triangle& triangle : hull.triangles) {
    const Eigen::Vector3d normal = doubleAreaNormal(hull, triangle).normalized();
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d side =
          (hull.vertices[triangle[(i + 1) % 3]] - hull.vertices[triangle[i]])
              .normalized();
      Eigen::Matrix3d axes;
      axes << side, normal.cross(side), normal;
      const HullPrimitive box = boxAlong(axes, hull.vertices);
      if (volumeOf(box) < volumeOf(best))
        best = box;
    }
  }
  return best;
}

/** Turn a primitive this way and that, by ever smaller angles, as long as it shrinks.
 */
HullPrimitive
turnedToFit(HullPrimitive best, const Vertices& vertices)
{
  constexpr double largest_turn = 0.1;
  constexpr double smallest_turn = 1e-4;
  for (double turn = largest_turn; turn > smallest_turn; turn *= 0.5)
    for (int axis = 0; axis < 3; ++axis)
      for (const double angle : {turn, -turn}) {
        const Eigen::Matrix3d axes =
            best.axes *
            Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
        const HullPrimitive turned = along(best.kind, axes, vertices);
        if (volumeOf(turned) < volumeOf(best))
          best = turned;
      }
  return best;
}

/** About the smallest of its kind that holds a hull. */
HullPrimitive
smallest(Kind kind, const TriangleMesh& hull, const HullPrimitive& box)
{
  if (kind == Kind::box)
    return box;
  if (kind == Kind::sphere)
    return sphereAround(hull.vertices);
  HullPrimitive best = along(kind, withThird(box.axes, 0), hull.vertices);
  for (const Eigen::Matrix3d& axes : {box.axes, principalBox(hull.vertices).axes})
    for (int third = 0; third < 3; ++third)
      if (const HullPrimitive rod = along(kind, withThird(axes, third), hull.vertices);
          volumeOf(rod) < volumeOf(best))
        best = rod;
  return turnedToFit(best, hull.vertices);
}

/** The smallest primitive that may stand for a hull. */
std::optional<HullPrimitive>
fitPrimitive(const TriangleMesh& hull,
             const Eigen::Vector3d& origin,
             const PrimitiveOptions& options)
{
  const double margin = hull_tolerance * diagonalOf(hull);
  const HullPrimitive box = turnedToFit(
      boxOnFaces(hull, boxAlong(principalBox(hull.vertices).axes, hull.vertices)),
      hull.vertices);
  std::vector<HullPrimitive> primitives;
  for (const Kind kind : options.kinds) {
    HullPrimitive primitive = smallest(kind, hull, box);
    primitive.extents.array() += 2.0 * margin;
    primitives.push_back(primitive);
  }
  std::stable_sort(primitives.begin(),
                   primitives.end(),
                   [](const HullPrimitive& a, const HullPrimitive& b) {
                     return volumeOf(a) < volumeOf(b);
                   });
  const double most = (1.0 + options.share) * volumeOf(hull);
  for (const HullPrimitive& primitive : primitives)
    if (volumeOf(primitive) <= most &&
        (!options.may_replace ||
         options.may_replace(moved(meshAround(primitive), origin))))
      return primitive;
  return std::nullopt;
}

/** The corners of a polygon around a circle about the third axis. */
void
addRing(double radius, double height, Vertices& points)
{
  constexpr int corners = 32;
  const double outside = 1.0 / std::cos(pi / corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * pi * i / corners;
    points.emplace_back(
        outside * radius * std::cos(angle), outside * radius * std::sin(angle), height);
  }
}

/** Rings around half a ball.
 *  \param[in] side 1 for the upper half, -1 for the lower */
void
addEnd(double radius, double middle, double side, Vertices& points)
{
  constexpr int rings = 8;
  const double outside = radius / std::cos(0.25 * pi / rings);
  points.emplace_back(0.0, 0.0, middle + side * outside);
  for (int i = 1; i <= rings; ++i) {
    const double angle = 0.5 * pi * i / rings;
    addRing(
        outside * std::sin(angle), middle + side * outside * std::cos(angle), points);
  }
}

} // namespace

const char*
nameOf(HullPrimitive::Kind kind)
{
  switch (kind) {
  case Kind::box:
    return "box";
  case Kind::sphere:
    return "sphere";
  case Kind::cylinder:
    return "cylinder";
  default:
    return "capsule";
  }
}

double
volumeOf(const HullPrimitive& primitive)
{
  const double r = primitive.radius();
  const double ball = 4.0 / 3.0 * pi * r * r * r;
  switch (primitive.kind) {
  case Kind::box:
    return primitive.extents.prod();
  case Kind::sphere:
    return ball;
  case Kind::cylinder:
    return pi * r * r * primitive.extents.z();
  default:
    return ball + pi * r * r * primitive.straightLength();
  }
}

TriangleMesh
meshAround(const HullPrimitive& primitive)
{
  const PrincipalBox box = {primitive.center, primitive.axes, primitive.extents};
  if (primitive.kind == Kind::box)
    return boxMesh(box, 0);
  Vertices points;
  const double half = 0.5 * primitive.extents.z();
  for (const double side : {-1.0, 1.0})
    if (primitive.kind == Kind::cylinder)
      addRing(primitive.radius(), side * half, points);
    else
      addEnd(primitive.radius(), side * (half - primitive.radius()), side, points);
  for (Eigen::Vector3d& p : points)
    p = box.fromLocal(p);
  return convexHull(points);
}

std::vector<std::optional<HullPrimitive>>
fitPrimitives(const std::vector<ConvexPart>& parts,
              const Frame& frame,
              const PrimitiveOptions& options,
              const ExecutionOptions& execution)
{
  if (!(options.share >= 0.0))
    throw CIDException(sentence("the share that primitives may be larger by is ",
                                options.share,
                                "; it must be at least 0"));
  std::vector<std::optional<HullPrimitive>> primitives(parts.size());
  Progress progress(execution.progress);
  parallelForEach(parts.size(),
                  threadCount(execution.threads),
                  progress,
                  {0.0, 1.0},
                  [&](std::size_t k) {
                    primitives[k] = fitPrimitive(
                        moved(parts[k].hull, -frame.origin), frame.origin, options);
                    if (primitives[k])
                      primitives[k]->center += frame.origin;
                  });
  return primitives;
}

} // namespace pcl_cid
