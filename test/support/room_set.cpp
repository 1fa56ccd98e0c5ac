/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A sequence of furnished rooms that differ.
 */

#include "room_set.h"

#include "depth_sensor.h"
#include "room_layout.h"

namespace pcl_cid::test {
namespace {

/** Tangent of half of 45 degrees: with quarter turns, furniture looks anywhere. */
constexpr double any_turn = 0.4142;

RoomOptions
drawOptions(RandomGenerator& generator)
{
  RoomOptions room;
  room.width = drawMeasure(generator, {3.5, 9.0});
  room.depth = drawMeasure(generator, {3.0, 6.5});
  room.height = drawMeasure(generator, {2.6, 3.4});
  room.turn = drawWithin(generator, {0.02, any_turn});
  const double area = room.width.low * room.depth.low;
  const auto countFor = [&](double square_metres_each) {
    return static_cast<unsigned>(area / square_metres_each);
  };
  room.doors = drawCount(generator, 1, 2);
  room.windows = drawCount(generator, 0, 3);
  room.beams = drawCount(generator, 0, 2);
  room.columns = drawCount(generator, 0, 2);
  room.bookcases = drawCount(generator, 0, 3);
  room.boards = drawCount(generator, 0, 2);
  room.pictures = drawCount(generator, 0, 3);
  room.sofas = drawCount(generator, 0, 2);
  room.tables = drawCount(generator, 1, countFor(8.0));
  room.chairs = drawCount(generator, 1, countFor(4.0));
  room.clutter = drawCount(generator, 5, 5 + countFor(2.0));
  return room;
}

} // namespace

RoomScene
makeVariousRoom(std::uint64_t seed)
{
  RandomGenerator generator(seed);
  return drawRoom(drawOptions, generator, seed);
}

LabelledScan
scanVariousRoom(const RoomScene& scene, std::size_t points, std::uint64_t seed)
{
  RandomGenerator generator(seed);
  SensorOptions sensor;
  sensor.seed = seed;
  sensor.points = points;
  sensor.positions = drawCount(generator, 3, 6);
  return scanRoom(scene, sensor);
}

std::uint64_t
seedOfRoom(std::uint64_t random_seed, unsigned number)
{
  RandomGenerator generator(random_seed);
  generator.discard(number);
  return generator();
}

} // namespace pcl_cid::test
