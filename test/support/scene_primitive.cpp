/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Upright boxes, cylinders and capsules: geometry with + - * / and sqrt only.
 */

#include "scene_primitive.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_cid::test {
namespace {

/// Solids that touch, as a cup and its table, differ by rounding only.
constexpr double contact_tolerance = 1e-6;

struct Interval {
  double enter;
  double leave;
};

/** Cuts \a interval to where a ray lies between -half and half along one axis. */
bool
cutToSlab(double origin, double direction, double half, Interval& interval)
{
  if (direction == 0.0)
    return std::abs(origin) <= half;
  const double first = (-half - origin) / direction;
  const double second = (half - origin) / direction;
  interval.enter = std::max(interval.enter, std::min(first, second));
  interval.leave = std::min(interval.leave, std::max(first, second));
  return interval.enter <= interval.leave;
}

bool
intersectBox(const Eigen::Vector3d& half,
             const Eigen::Vector3d& origin,
             const Eigen::Vector3d& direction,
             SurfaceHit& hit)
{
  Interval interval{0.0, std::numeric_limits<double>::infinity()};
  double cosine = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double before = interval.enter;
    if (!cutToSlab(origin[axis], direction[axis], half[axis], interval))
      return false;
    if (interval.enter > before)
      cosine = std::abs(direction[axis]);
  }
  hit = {interval.enter, cosine};
  return interval.enter > 0.0;
}

bool
intersectCylinder(const Eigen::Vector3d& half,
                  const Eigen::Vector3d& origin,
                  const Eigen::Vector3d& direction,
                  SurfaceHit& hit)
{
  Interval interval{0.0, std::numeric_limits<double>::infinity()};
  if (!cutToSlab(origin.z(), direction.z(), half.z(), interval))
    return false;
  double cosine = std::abs(direction.z());

  const double a = direction.x() * direction.x() + direction.y() * direction.y();
  const double b = origin.x() * direction.x() + origin.y() * direction.y();
  const double radius = half.x();
  const double c = origin.x() * origin.x() + origin.y() * origin.y() - radius * radius;
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0 || (a == 0.0 && c > 0.0))
    return false;
  if (a > 0.0) {
    const double root = std::sqrt(discriminant);
    if ((-b - root) / a > interval.enter) {
      interval.enter = (-b - root) / a;
      cosine = root / radius; // direction times the normal at the point of entry
    }
    interval.leave = std::min(interval.leave, (-b + root) / a);
  }
  hit = {interval.enter, cosine};
  return interval.enter > 0.0 && interval.enter <= interval.leave;
}

/** Lowers \a hit to where a ray enters the ball around \a center, if that is nearer. */
void
lowerToBall(const Eigen::Vector3d& center,
            double radius,
            const Eigen::Vector3d& origin,
            const Eigen::Vector3d& direction,
            SurfaceHit& hit)
{
  const Eigen::Vector3d offset = origin - center;
  const double b = dot(offset, direction);
  const double discriminant = b * b - dot(offset, offset) + radius * radius;
  if (discriminant < 0.0)
    return;
  const double root = std::sqrt(discriminant);
  if (-b - root > 0.0 && -b - root < hit.range)
    hit = {-b - root, root / radius};
}

/** A capsule is the union of a tube and two balls: the ray enters it where it first
 *  enters one of them. */
bool
intersectCapsule(const Eigen::Vector3d& half,
                 const Eigen::Vector3d& origin,
                 const Eigen::Vector3d& direction,
                 SurfaceHit& hit)
{
  const double radius = half.x();
  const double straight = half.z() - radius;
  SurfaceHit tube;
  hit = {std::numeric_limits<double>::infinity(), 0.0};
  if (intersectCylinder({radius, radius, straight}, origin, direction, tube))
    hit = tube;
  lowerToBall({0.0, 0.0, straight}, radius, origin, direction, hit);
  lowerToBall({0.0, 0.0, -straight}, radius, origin, direction, hit);
  return hit.range < std::numeric_limits<double>::infinity();
}

double
reachInPlan(const Primitive& primitive, const Eigen::Vector2d& direction)
{
  const Eigen::Vector2d& axis = primitive.axis;
  const double along = axis.x() * direction.x() + axis.y() * direction.y();
  const double across = axis.x() * direction.y() - axis.y() * direction.x();
  return primitive.half.x() * std::abs(along) + primitive.half.y() * std::abs(across);
}

bool
separatedAlong(const Primitive& a,
               const Primitive& b,
               const Eigen::Vector2d& direction,
               double gap)
{
  const Eigen::Vector3d offset = b.center - a.center;
  const double distance =
      std::abs(offset.x() * direction.x() + offset.y() * direction.y());
  return distance >= reachInPlan(a, direction) + reachInPlan(b, direction) + gap;
}

} // namespace

Eigen::Vector2d
rotated(const Eigen::Vector2d& vector, const Eigen::Vector2d& axis)
{
  return {axis.x() * vector.x() - axis.y() * vector.y(),
          axis.y() * vector.x() + axis.x() * vector.y()};
}

Pose
composed(const Pose& outer, const Pose& inner)
{
  return {outer.origin + rotated(inner.origin, outer.axis),
          rotated(inner.axis, outer.axis)};
}

Primitive
makeBox(double x0, double x1, double y0, double y1, double z0, double z1)
{
  Primitive box;
  box.center = {(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2};
  box.half = {(x1 - x0) / 2, (y1 - y0) / 2, (z1 - z0) / 2};
  return box;
}

Primitive
makeCylinder(double x, double y, double radius, double z0, double z1)
{
  Primitive cylinder = makeBox(x - radius, x + radius, y - radius, y + radius, z0, z1);
  cylinder.shape = Shape::cylinder;
  cylinder.half.x() = cylinder.half.y() = radius;
  return cylinder;
}

Primitive
makeCapsule(double x, double y, double radius, double z0, double z1)
{
  Primitive capsule = makeCylinder(x, y, radius, z0, z1);
  capsule.shape = Shape::capsule;
  return capsule;
}

Primitive
moved(Primitive primitive, const Pose& pose, double z)
{
  const Pose own{{primitive.center.x(), primitive.center.y()}, primitive.axis};
  const Pose outer = composed(pose, own);
  primitive.center = {outer.origin.x(), outer.origin.y(), primitive.center.z() + z};
  primitive.axis = outer.axis;
  return primitive;
}

Eigen::Vector3d
directionToLocal(const Primitive& primitive, const Eigen::Vector3d& direction)
{
  const Eigen::Vector2d& axis = primitive.axis;
  return {axis.x() * direction.x() + axis.y() * direction.y(),
          axis.x() * direction.y() - axis.y() * direction.x(),
          direction.z()};
}

Eigen::Vector3d
toLocal(const Primitive& primitive, const Eigen::Vector3d& point)
{
  return directionToLocal(primitive, point - primitive.center);
}

Eigen::Vector3d
toWorld(const Primitive& primitive, const Eigen::Vector3d& local)
{
  const Eigen::Vector2d plan = rotated({local.x(), local.y()}, primitive.axis);
  return primitive.center + Eigen::Vector3d(plan.x(), plan.y(), local.z());
}

Eigen::Vector3d
nearestOfCore(const Primitive& capsule, const Eigen::Vector3d& local)
{
  const double straight = capsule.half.z() - capsule.half.x();
  return {0.0, 0.0, std::clamp(local.z(), -straight, straight)};
}

double
distanceTo(const Primitive& primitive, const Eigen::Vector3d& point)
{
  const Eigen::Vector3d local = toLocal(primitive, point);
  Eigen::Vector3d outside = local.cwiseAbs() - primitive.half;
  if (primitive.shape == Shape::capsule) {
    const Eigen::Vector3d from_core = local - nearestOfCore(primitive, local);
    return std::max(0.0, std::sqrt(dot(from_core, from_core)) - primitive.half.x());
  }
  if (primitive.shape == Shape::cylinder) {
    outside.x() =
        std::sqrt(local.x() * local.x() + local.y() * local.y()) - primitive.half.x();
    outside.y() = 0.0;
  }
  outside = outside.cwiseMax(0.0);
  return std::sqrt(dot(outside, outside));
}

bool
overlap(const Primitive& a, const Primitive& b, double gap)
{
  const double height_apart =
      std::abs(a.center.z() - b.center.z()) - a.half.z() - b.half.z();
  if (height_apart >= -contact_tolerance)
    return false;
  for (const Eigen::Vector2d& axis : {a.axis, b.axis}) {
    const Eigen::Vector2d across(-axis.y(), axis.x());
    if (separatedAlong(a, b, axis, gap) || separatedAlong(a, b, across, gap))
      return false;
  }
  return true;
}

Eigen::Vector3d
boundingHalf(const Primitive& primitive)
{
  if (primitive.shape != Shape::box)
    return primitive.half;
  return {reachInPlan(primitive, {1.0, 0.0}),
          reachInPlan(primitive, {0.0, 1.0}),
          primitive.half.z()};
}

bool
intersect(const Primitive& primitive,
          const Eigen::Vector3d& origin,
          const Eigen::Vector3d& direction,
          SurfaceHit& hit)
{
  const Eigen::Vector3d local_origin = toLocal(primitive, origin);
  const Eigen::Vector3d local_direction = directionToLocal(primitive, direction);
  switch (primitive.shape) {
  case Shape::box:
    return intersectBox(primitive.half, local_origin, local_direction, hit);
  case Shape::cylinder:
    return intersectCylinder(primitive.half, local_origin, local_direction, hit);
  default:
    return intersectCapsule(primitive.half, local_origin, local_direction, hit);
  }
}

} // namespace pcl_cid::test
