/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Collects the pieces of a test room and refuses those that collide.
 */

#include "room_builder.h"

#include <algorithm>
#include <utility>

namespace pcl_cid::test {
namespace {

/// Rounding that may carry a piece on a wall out of the room.
constexpr double inside_tolerance = 1e-6;

/** Shell and openings, which are a room's first instances. */
bool
isOfShell(RoomClass room_class)
{
  return room_class == RoomClass::ceiling || room_class == RoomClass::floor ||
         room_class == RoomClass::wall || room_class == RoomClass::window ||
         room_class == RoomClass::door;
}

} // namespace

RoomBuilder::RoomBuilder(const Eigen::Vector3d& size)
{
  scene_.size = size;
  scene_.class_of_instance.push_back(RoomClass::none);
}

RoomBuilder::RoomBuilder(RoomScene scene) : scene_(std::move(scene))
{
  const auto furniture = std::find_if(
      scene_.primitives.begin(), scene_.primitives.end(), [&](const Primitive& p) {
        return !isOfShell(scene_.class_of_instance[p.instance]);
      });
  shell_end_ = static_cast<std::size_t>(furniture - scene_.primitives.begin());
}

void
RoomBuilder::add(const Piece& piece, RoomClass room_class)
{
  const auto instance = static_cast<std::uint32_t>(scene_.class_of_instance.size());
  scene_.class_of_instance.push_back(room_class);
  for (Primitive primitive : piece.primitives) {
    primitive.instance = instance;
    scene_.primitives.push_back(primitive);
  }
}

bool
RoomBuilder::addIfFree(const Piece& piece, RoomClass room_class, double gap)
{
  for (const Primitive& primitive : piece.primitives)
    if (!isInRoom(primitive) || !isFree(primitive, gap))
      return false;
  add(piece, room_class);
  return true;
}

bool
RoomBuilder::isInRoom(const Primitive& primitive) const
{
  const Eigen::Vector3d half = boundingHalf(primitive).array() - inside_tolerance;
  return ((primitive.center - half).array() >= 0.0).all() &&
         ((primitive.center + half).array() <= scene_.size.array()).all();
}

bool
RoomBuilder::isFree(const Primitive& primitive, double gap) const
{
  for (const Primitive& area : kept_free_)
    if (overlap(primitive, area, 0.0))
      return false;
  for (std::size_t other = shell_end_; other < scene_.primitives.size(); ++other)
    if (overlap(primitive, scene_.primitives[other], gap))
      return false;
  return true;
}

} // namespace pcl_cid::test
