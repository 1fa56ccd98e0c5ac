/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The colors of a scan: materials under lamps.
 */

#include "scan_paint.h"

#include <algorithm>
#include <cmath>

namespace pcl_cid::test {
namespace {

/// What a lamp adds close by, and the range at which that is halved.
constexpr double lamp_light = 0.5;
constexpr double lamp_range = 3.0;

/// A place of a surface, in the primitive's own frame.
struct SurfacePlace {
  Eigen::Vector3d normal;
  double u; ///< along the surface, in metres
  double v;
};

SurfacePlace
placeOnBox(const Eigen::Vector3d& half, const Eigen::Vector3d& local)
{
  int axis = 0;
  (local.cwiseAbs() - half).maxCoeff(&axis);
  const double side = local[axis] < 0.0 ? -1.0 : 1.0;
  return {
      side * Eigen::Vector3d::Unit(axis), local[(axis + 1) % 3], local[(axis + 2) % 3]};
}

SurfacePlace
placeOnRound(const Primitive& primitive, const Eigen::Vector3d& local)
{
  const bool is_capsule = primitive.shape == Shape::capsule;
  const double out = std::sqrt(local.x() * local.x() + local.y() * local.y());
  const double over_end = std::abs(local.z()) - primitive.half.z();
  if (!is_capsule && over_end > out - primitive.half.x())
    return {{0.0, 0.0, local.z() < 0.0 ? -1.0 : 1.0}, local.x(), local.y()};
  const Eigen::Vector3d from_core =
      is_capsule ? Eigen::Vector3d(local - nearestOfCore(primitive, local))
                 : Eigen::Vector3d(local.x(), local.y(), 0.0);
  return {from_core / std::sqrt(dot(from_core, from_core)), local.z(), 0.0};
}

/// A rectangle has no inner side: it is lit from both.
double
facing(const Primitive& primitive, double cosine)
{
  const bool has_one_side = primitive.half.minCoeff() > 0.0;
  return has_one_side ? std::max(cosine, 0.0) : std::abs(cosine);
}

double
lightAt(const ColoredRoom& room,
        const Primitive& primitive,
        const Eigen::Vector3d& point,
        const Eigen::Vector3d& normal)
{
  double light = least_light;
  for (const Eigen::Vector3d& lamp : room.lamps) {
    const Eigen::Vector3d ray = lamp - point;
    const double squared = dot(ray, ray);
    const double cosine = dot(ray, normal) / std::sqrt(squared);
    light += lamp_light * facing(primitive, cosine) /
             (1.0 + squared / (lamp_range * lamp_range));
  }
  return std::min(light, 1.0);
}

std::uint8_t
levelOf(double value)
{
  return static_cast<std::uint8_t>(std::floor(value + 0.5));
}

} // namespace

void
paintScan(const ColoredRoom& room, LabelledScan& scan)
{
  scan.colors.clear();
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const std::uint32_t number = scan.primitive[i];
    const Primitive& primitive = room.scene.primitives[number];
    const Eigen::Vector3d point = scan.points[i].cast<double>();
    const Eigen::Vector3d local = toLocal(primitive, point);
    const SurfacePlace place = primitive.shape == Shape::box
                                   ? placeOnBox(primitive.half, local)
                                   : placeOnRound(primitive, local);
    const Eigen::Vector3d normal = toWorld(primitive, place.normal) - primitive.center;
    const Rgb color = lightAt(room, primitive, point, normal) *
                      colorAt(room.materials[number], place.u, place.v);
    scan.colors.push_back({levelOf(color.x()), levelOf(color.y()), levelOf(color.z())});
  }
}

} // namespace pcl_cid::test
