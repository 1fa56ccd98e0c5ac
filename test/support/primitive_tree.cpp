/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A bounding volume tree over primitives, split at the median of the widest axis.
 */

#include "primitive_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace pcl_cid::test {
namespace {

constexpr std::size_t leaf_size = 2;
/// Boxes are widened, so that rounding never hides a primitive from a ray.
constexpr double box_margin = 1e-6;
/// A point this close to a primitive touches it.
constexpr double touch_tolerance = 1e-6;

/// A node still to visit and the range at which the ray enters it.
struct Visit {
  std::size_t node;
  double range;
};

/// Median splits keep the tree shallow: 64 levels are more than memory can fill.
class Pending {
public:
  bool
  empty() const
  {
    return count_ == 0;
  }
  void
  push(const Visit& visit)
  {
    visits_[count_++] = visit;
  }
  Visit
  pop()
  {
    return visits_[--count_];
  }

private:
  std::array<Visit, 64> visits_;
  std::size_t count_ = 0;
};

/** Range at which a ray enters a box, or infinity when it misses. */
double
entryRange(const Eigen::Vector3d& low,
           const Eigen::Vector3d& high,
           const Eigen::Vector3d& origin,
           const Eigen::Vector3d& inverse_direction)
{
  double enter = 0.0;
  double leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double first = (low[axis] - origin[axis]) * inverse_direction[axis];
    const double second = (high[axis] - origin[axis]) * inverse_direction[axis];
    enter = std::max(enter, std::min(first, second));
    leave = std::min(leave, std::max(first, second));
  }
  return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

/** 1 / direction, with a huge finite number for 0, so that 0 * infinity cannot occur.
 */
Eigen::Vector3d
invert(const Eigen::Vector3d& direction)
{
  Eigen::Vector3d inverse;
  for (int axis = 0; axis < 3; ++axis)
    inverse[axis] = direction[axis] == 0.0 ? 1e300 : 1.0 / direction[axis];
  return inverse;
}

} // namespace

PrimitiveTree::PrimitiveTree(const std::vector<Primitive>& primitives)
: primitives_(primitives), order_(primitives.size())
{
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (!order_.empty())
    build(0, order_.size());
}

void
PrimitiveTree::build(std::size_t begin, std::size_t end)
{
  const double infinity = std::numeric_limits<double>::infinity();
  Node node{Eigen::Vector3d::Constant(infinity),
            Eigen::Vector3d::Constant(-infinity),
            begin,
            end,
            0};
  for (std::size_t i = begin; i < end; ++i) {
    const Primitive& primitive = primitives_[order_[i]];
    const Eigen::Vector3d half = boundingHalf(primitive).array() + box_margin;
    node.low = node.low.cwiseMin(primitive.center - half);
    node.high = node.high.cwiseMax(primitive.center + half);
  }
  const std::size_t index = nodes_.size();
  nodes_.push_back(node);
  if (end - begin <= leaf_size)
    return;

  int widest = 0;
  (node.high - node.low).maxCoeff(&widest);
  std::stable_sort(order_.begin() + static_cast<std::ptrdiff_t>(begin),
                   order_.begin() + static_cast<std::ptrdiff_t>(end),
                   [&](std::size_t a, std::size_t b) {
                     return primitives_[a].center[widest] <
                            primitives_[b].center[widest];
                   });
  const std::size_t middle = begin + (end - begin) / 2;
  build(begin, middle);
  nodes_[index].second_child = nodes_.size();
  build(middle, end);
}

bool
PrimitiveTree::firstHit(const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& direction,
                        RayHit& hit) const
{
  const Eigen::Vector3d inverse = invert(direction);
  hit = {primitives_.size(), {std::numeric_limits<double>::infinity(), 0.0}};
  Pending pending;
  const auto visitLater = [&](std::size_t node, double range) {
    if (range < std::numeric_limits<double>::infinity())
      pending.push({node, range});
  };
  const auto enter = [&](std::size_t node) {
    return entryRange(nodes_[node].low, nodes_[node].high, origin, inverse);
  };
  if (!nodes_.empty())
    visitLater(0, enter(0));
  while (!pending.empty()) {
    const Visit visit = pending.pop();
    if (visit.range > hit.surface.range)
      continue;
    const Node& node = nodes_[visit.node];
    if (node.second_child != 0) {
      const std::size_t first = visit.node + 1;
      const std::size_t second = node.second_child;
      const double first_range = enter(first);
      const double second_range = enter(second);
      const bool second_is_nearer = second_range < first_range;
      visitLater(second_is_nearer ? first : second,
                 second_is_nearer ? first_range : second_range);
      visitLater(second_is_nearer ? second : first,
                 second_is_nearer ? second_range : first_range);
      continue;
    }
    for (std::size_t i = node.begin; i < node.end; ++i) {
      SurfaceHit surface;
      if (!intersect(primitives_[order_[i]], origin, direction, surface))
        continue;
      const bool nearer = surface.range < hit.surface.range;
      const bool earlier =
          surface.range == hit.surface.range && order_[i] < hit.primitive;
      if (nearer || earlier)
        hit = {order_[i], surface};
    }
  }
  return hit.primitive < primitives_.size();
}

bool
PrimitiveTree::isCovered(const Eigen::Vector3d& point, std::size_t self) const
{
  Pending pending;
  if (!nodes_.empty())
    pending.push({0, 0.0});
  while (!pending.empty()) {
    const std::size_t index = pending.pop().node;
    const Node& node = nodes_[index];
    const bool is_outside = (point.array() < node.low.array()).any() ||
                            (point.array() > node.high.array()).any();
    if (is_outside)
      continue;
    if (node.second_child != 0) {
      pending.push({node.second_child, 0.0});
      pending.push({index + 1, 0.0});
      continue;
    }
    for (std::size_t i = node.begin; i < node.end; ++i)
      if (order_[i] != self &&
          distanceTo(primitives_[order_[i]], point) <= touch_tolerance)
        return true;
  }
  return false;
}

} // namespace pcl_cid::test
