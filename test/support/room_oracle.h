/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * An oracle for tests of rooms and scans: geometry written a second time, plainly.
 */

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include "room_scene.h"

namespace pcl_cid::test {

/** \brief Distance from \a point to the surface of \a primitive, negative inside. */
inline double
signedDistance(const Primitive& primitive, const Eigen::Vector3d& point)
{
  const double turn = std::atan2(primitive.axis.y(), primitive.axis.x());
  const Eigen::Vector3d local =
      Eigen::AngleAxisd(-turn, Eigen::Vector3d::UnitZ()) * (point - primitive.center);
  const Eigen::Vector3d over = local.cwiseAbs() - primitive.half;
  if (primitive.shape == Shape::box)
    return over.cwiseMax(0.0).norm() + std::min(over.maxCoeff(), 0.0);
  if (primitive.shape == Shape::capsule) {
    const double straight = primitive.half.z() - primitive.half.x();
    const double over_end = std::max(std::abs(local.z()) - straight, 0.0);
    return std::hypot(local.x(), local.y(), over_end) - primitive.half.x();
  }
  const Eigen::Vector2d beyond(local.head<2>().norm() - primitive.half.x(), over.z());
  return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

/** \brief A grid over all of the surface of \a primitive, in the room. Each point
 *  stands for \a area, about \a step squared. */
struct SurfacePoint {
  Eigen::Vector3d position;
  double area;
};

inline std::vector<SurfacePoint>
surfaceGrid(const Primitive& primitive, double step)
{
  std::vector<SurfacePoint> points;
  const Eigen::Rotation2Dd turn(std::atan2(primitive.axis.y(), primitive.axis.x()));
  const auto add = [&](double x, double y, double z, double area) {
    const Eigen::Vector2d plan = turn * Eigen::Vector2d(x, y);
    points.push_back({primitive.center + Eigen::Vector3d(plan.x(), plan.y(), z), area});
  };
  const auto cells = [&](double length) {
    return std::max(1, static_cast<int>(std::ceil(length / step)));
  };
  const Eigen::Vector3d& half = primitive.half;
  if (primitive.shape == Shape::box) {
    for (int axis = 0; axis < 3; ++axis) {
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      const int columns = cells(2 * half[u]);
      const int rows = cells(2 * half[v]);
      const double area = 4 * half[u] * half[v] / columns / rows;
      for (int i = 0; area > 0.0 && i < columns * rows; ++i) {
        Eigen::Vector3d local;
        local[u] = half[u] * ((2.0 * (i % columns) + 1.0) / columns - 1.0);
        local[v] = half[v] * ((2.0 * (i / columns) + 1.0) / rows - 1.0);
        local[axis] = half[axis];
        add(local.x(), local.y(), local.z(), area);
        local[axis] = -half[axis];
        if (half[axis] > 0.0)
          add(local.x(), local.y(), local.z(), area);
      }
    }
    return points;
  }
  const double radius = half.x();
  const int slices = cells(2 * M_PI * radius);
  if (primitive.shape ==
      Shape::capsule) { // equal shares of the height have equal areas
    const double straight = half.z() - radius;
    const int layers = cells(2 * half.z());
    for (int i = 0; i < slices * layers; ++i) {
      const double angle = 2 * M_PI * (i % slices + 0.5) / slices;
      const double z = half.z() * ((2.0 * (i / slices) + 1.0) / layers - 1.0);
      const double up = std::max(std::abs(z) - straight, 0.0);
      const double out = std::sqrt(radius * radius - up * up);
      add(out * std::cos(angle),
          out * std::sin(angle),
          z,
          4 * M_PI * radius * half.z() / slices / layers);
    }
    return points;
  }
  const int layers = cells(2 * half.z());
  const int rings = cells(radius);
  for (int slice = 0; slice < slices; ++slice) {
    const double angle = 2 * M_PI * (slice + 0.5) / slices;
    for (int layer = 0; layer < layers; ++layer)
      add(radius * std::cos(angle),
          radius * std::sin(angle),
          half.z() * ((2.0 * layer + 1.0) / layers - 1.0),
          4 * M_PI * radius * half.z() / slices / layers);
    for (int ring = 0; ring < rings; ++ring) {
      const double r = radius * (ring + 0.5) / rings;
      const double area = 2 * M_PI * r * radius / rings / slices;
      for (const double z : {-half.z(), half.z()})
        add(r * std::cos(angle), r * std::sin(angle), z, area);
    }
  }
  return points;
}

/** \brief The deepest that any surface lies inside a solid of another instance. */
inline double
deepestPenetration(const RoomScene& scene, double step)
{
  const auto areFarApart = [](const Primitive& a, const Primitive& b) {
    return (a.center - b.center).norm() > a.half.norm() + b.half.norm();
  };
  double deepest = 0.0;
  for (const Primitive& surface : scene.primitives) {
    const std::vector<SurfacePoint> grid = surfaceGrid(surface, step);
    for (const Primitive& solid : scene.primitives)
      if (solid.instance != surface.instance && !areFarApart(solid, surface))
        for (const SurfacePoint& point : grid)
          deepest = std::max(deepest, -signedDistance(solid, point.position));
  }
  return deepest;
}

/** \brief Distance from \a point to the nearest surface of \a instance. */
inline double
distanceToInstance(const RoomScene& scene,
                   std::uint32_t instance,
                   const Eigen::Vector3d& point)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const Primitive& primitive : scene.primitives)
    if (primitive.instance == instance)
      nearest = std::min(nearest, std::abs(signedDistance(primitive, point)));
  return nearest;
}

/** \brief Whether nothing stands between \a eye and \a point: steps along the segment
 *  that are never longer than the way to the nearest solid. */
inline bool
isVisible(const RoomScene& scene,
          const Eigen::Vector3d& eye,
          const Eigen::Vector3d& point)
{
  constexpr double arrived = 1e-3;
  const double length = (point - eye).norm();
  double travelled = 0.0;
  while (travelled < length - arrived) {
    const Eigen::Vector3d here = eye + (point - eye) * (travelled / length);
    double free = std::numeric_limits<double>::infinity();
    for (const Primitive& primitive : scene.primitives)
      free = std::min(free, signedDistance(primitive, here));
    if (free < 1e-7)
      return false;
    travelled += std::max(free, 1e-5);
  }
  return true;
}

} // namespace pcl_cid::test
