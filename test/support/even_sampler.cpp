/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points drawn evenly from all surfaces of a test room.
 */

#include "even_sampler.h"

#include <algorithm>
#include <cmath>

#include "primitive_tree.h"

namespace pcl_cid::test {
namespace {

constexpr double pi = 3.14159265358979323846;

enum class PatchShape { rectangle, disc, tube, ball };

/// A part of a primitive's surface, in the primitive's own frame: the points
/// center + a u + b v (a, b from -1 to 1; a disc within a^2 + b^2 <= 1), the round
/// side of a cylinder, or the two half balls of a capsule.
struct Patch {
  std::size_t primitive;
  PatchShape shape;
  Eigen::Vector3d center;
  Eigen::Vector3d u;
  Eigen::Vector3d v;
  double area_end; ///< area of this patch and all before it
};

class PatchList {
public:
  explicit PatchList(const std::vector<Primitive>& primitives)
  {
    for (std::size_t i = 0; i < primitives.size(); ++i)
      switch (primitives[i].shape) {
      case Shape::box:
        addBox(i, primitives[i].half);
        break;
      case Shape::cylinder:
        addCylinder(i, primitives[i].half);
        break;
      case Shape::capsule:
        addCapsule(i, primitives[i].half);
      }
  }

  /// A patch drawn with a probability proportional to its area.
  const Patch&
  draw(RandomGenerator& generator) const
  {
    const double area = drawUnit(generator) * patches_.back().area_end;
    return *std::upper_bound(
        patches_.begin(),
        patches_.end() - 1,
        area,
        [](double value, const Patch& patch) { return value < patch.area_end; });
  }

private:
  void
  add(Patch patch, double area)
  {
    if (area <= 0.0)
      return;
    patch.area_end = area + (patches_.empty() ? 0.0 : patches_.back().area_end);
    patches_.push_back(patch);
  }

  /// A rectangle (no extent along one axis) has one side only.
  void
  addBox(std::size_t primitive, const Eigen::Vector3d& half)
  {
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d out = Eigen::Vector3d::Unit(axis) * half[axis];
      const int next = (axis + 1) % 3;
      const int last = (axis + 2) % 3;
      const Eigen::Vector3d u = Eigen::Vector3d::Unit(next) * half[next];
      const Eigen::Vector3d v = Eigen::Vector3d::Unit(last) * half[last];
      const double area = 4.0 * half[next] * half[last];
      add({primitive, PatchShape::rectangle, out, u, v, 0.0}, area);
      if (half[axis] > 0.0)
        add({primitive, PatchShape::rectangle, -out, u, v, 0.0}, area);
    }
  }

  void
  addCylinder(std::size_t primitive, const Eigen::Vector3d& half)
  {
    const double radius = half.x();
    const Eigen::Vector3d u = Eigen::Vector3d::UnitX() * radius;
    const Eigen::Vector3d v = Eigen::Vector3d::UnitY() * radius;
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ() * half.z();
    add({primitive, PatchShape::disc, up, u, v, 0.0}, pi * radius * radius);
    add({primitive, PatchShape::disc, -up, u, v, 0.0}, pi * radius * radius);
    add({primitive, PatchShape::tube, up, u, v, 0.0}, 4.0 * pi * radius * half.z());
  }

  void
  addCapsule(std::size_t primitive, const Eigen::Vector3d& half)
  {
    const double radius = half.x();
    const Eigen::Vector3d u = Eigen::Vector3d::UnitX() * radius;
    const Eigen::Vector3d v = Eigen::Vector3d::UnitY() * radius;
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ() * (half.z() - radius);
    add({primitive, PatchShape::tube, up, u, v, 0.0}, 4.0 * pi * radius * up.z());
    add({primitive, PatchShape::ball, up, u, v, 0.0}, 4.0 * pi * radius * radius);
  }

  std::vector<Patch> patches_;
};

struct PlanePoint {
  double a;
  double b;
  double squared_norm;
};

/// Uniform in the unit disc, away from its very center.
PlanePoint
drawInDisc(RandomGenerator& generator)
{
  PlanePoint point{0.0, 0.0, 0.0};
  while (point.squared_norm < 1e-12 || point.squared_norm > 1.0) {
    point.a = drawWithin(generator, {-1.0, 1.0});
    point.b = drawWithin(generator, {-1.0, 1.0});
    point.squared_norm = point.a * point.a + point.b * point.b;
  }
  return point;
}

Eigen::Vector3d
drawOnPatch(const Patch& patch, RandomGenerator& generator)
{
  if (patch.shape == PatchShape::rectangle) {
    const double a = drawWithin(generator, {-1.0, 1.0});
    const double b = drawWithin(generator, {-1.0, 1.0});
    return patch.center + a * patch.u + b * patch.v;
  }
  const PlanePoint point = drawInDisc(generator);
  if (patch.shape == PatchShape::disc)
    return patch.center + point.a * patch.u + point.b * patch.v;
  const double scale = 1.0 / std::sqrt(point.squared_norm);
  const double height = drawWithin(generator, {-1.0, 1.0});
  if (patch.shape == PatchShape::ball) { // all heights of a ball have equal areas
    const double ring = std::sqrt(1.0 - height * height) * scale;
    const Eigen::Vector3d center = height < 0.0 ? -patch.center : patch.center;
    return center + ring * (point.a * patch.u + point.b * patch.v) +
           height * patch.u.x() * Eigen::Vector3d::UnitZ();
  }
  return height * patch.center + point.a * scale * patch.u + point.b * scale * patch.v;
}

} // namespace

LabelledScan
sampleRoomEvenly(const RoomScene& scene, std::size_t count, std::uint64_t seed)
{
  RandomGenerator generator(seed);
  const PatchList patches(scene.primitives);
  const PrimitiveTree tree(scene.primitives);
  LabelledScan scan;
  scan.class_names = roomClassNames();
  while (scan.points.size() < count) {
    const Patch& patch = patches.draw(generator);
    const Primitive& primitive = scene.primitives[patch.primitive];
    const Eigen::Vector3d point = toWorld(primitive, drawOnPatch(patch, generator));
    if (tree.isCovered(point, patch.primitive))
      continue;
    const RoomClass room_class = scene.class_of_instance[primitive.instance];
    scan.points.push_back(point.cast<float>());
    scan.instance.push_back(primitive.instance);
    scan.primitive.push_back(static_cast<std::uint32_t>(patch.primitive));
    scan.semantic.push_back(static_cast<std::uint8_t>(room_class));
  }
  return scan;
}

} // namespace pcl_cid::test
