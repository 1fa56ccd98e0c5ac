/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Colors for the furniture of a test room.
 */

#include "furniture_paint.h"

#include <algorithm>
#include <array>

namespace pcl_cid::test {
namespace {

/// What a piece is made of: its large parts, and its legs, bars and handles.
struct Finish {
  Material main;
  Material small;
};

Material
drawFloor(RandomGenerator& generator)
{
  switch (drawBelow(generator, 3)) {
  case 0:
    return striped(drawWood(generator), 0.18);
  case 1: {
    const Rgb tile = drawPale(generator);
    return {tile, 0.88 * tile, Pattern::checks, 0.40};
  }
  default:
    return {0.7 * drawPale(generator)};
  }
}

Material
drawThing(RandomGenerator& generator)
{
  const Rgb color =
      drawBelow(generator, 3) == 0 ? drawPale(generator) : drawVivid(generator);
  return {color, drawPale(generator), Pattern::bands, 0.15};
}

Finish
drawFinish(RoomClass room_class, const Material& walls, RandomGenerator& generator)
{
  switch (room_class) {
  case RoomClass::ceiling:
    return {{drawWhite(generator)}, {}};
  case RoomClass::floor:
    return {drawFloor(generator), {}};
  case RoomClass::wall:
  case RoomClass::beam:
  case RoomClass::column:
    return {walls, walls};
  case RoomClass::window:
    return {{{185.0, 205.0, 225.0}}, {drawWhite(generator)}};
  case RoomClass::door:
  case RoomClass::table:
  case RoomClass::bookcase: {
    const Material wood = striped(drawWood(generator), 0.12);
    return {wood,
            room_class == RoomClass::bookcase ? wood : Material{drawDark(generator)}};
  }
  case RoomClass::chair:
    return {{drawVivid(generator)}, {drawDark(generator)}};
  case RoomClass::sofa: {
    const Rgb cloth = 0.8 * drawVivid(generator) + Rgb::Constant(30.0);
    return {{cloth, 0.9 * cloth, Pattern::checks, 0.05}, {drawDark(generator)}};
  }
  case RoomClass::board:
    return {{drawWhite(generator)}, {drawDark(generator)}};
  default:
    return {drawThing(generator), {drawDark(generator)}};
  }
}

/// Whether it is thin in two directions, as legs, bars and handles are.
bool
isSmallPart(const Primitive& primitive)
{
  std::array<double, 3> half{
      primitive.half.x(), primitive.half.y(), primitive.half.z()};
  std::sort(half.begin(), half.end());
  return half[1] <= 0.03;
}

} // namespace

std::vector<Material>
paintFurniture(const RoomScene& scene, RandomGenerator& generator)
{
  const Material walls{drawPale(generator)};
  std::vector<Finish> finishes;
  for (const RoomClass room_class : scene.class_of_instance)
    finishes.push_back(drawFinish(room_class, walls, generator));
  std::vector<Material> materials;
  for (const Primitive& primitive : scene.primitives) {
    const Finish& finish = finishes[primitive.instance];
    const RoomClass room_class = scene.class_of_instance[primitive.instance];
    const bool is_frame =
        room_class == RoomClass::window && primitive.half.minCoeff() > 0.0;
    materials.push_back(isSmallPart(primitive) || is_frame ? finish.small
                                                           : finish.main);
  }
  return materials;
}

} // namespace pcl_cid::test
