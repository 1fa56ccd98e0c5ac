/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A furnished room: checked options, and attempts until a layout works.
 */

#include "room_scene.h"

#include <optional>

#include <pcl_cid/exceptions.h>

#include "room_layout.h"

namespace pcl_cid::test {
namespace {

/// Layouts to try before the room counts as too small.
constexpr int layout_attempts = 50;

const Range allowed_measure{2.0, 1000.0};
const Range allowed_height{2.4, 100.0};

void
checkMeasure(const std::string& name, const Range& range, const Range& allowed)
{
  if (range.low >= allowed.low && range.low <= range.high && range.high <= allowed.high)
    return;
  throw CIDException("room " + name + " from " + std::to_string(range.low) + " to " +
                     std::to_string(range.high) + " m is out of range; allowed is " +
                     std::to_string(allowed.low) + " to " +
                     std::to_string(allowed.high) + " m, low end first");
}

} // namespace

const std::vector<std::string>&
roomClassNames()
{
  static const std::vector<std::string> names{"none",
                                              "ceiling",
                                              "floor",
                                              "wall",
                                              "beam",
                                              "column",
                                              "window",
                                              "door",
                                              "table",
                                              "chair",
                                              "sofa",
                                              "bookcase",
                                              "board",
                                              "clutter"};
  return names;
}

RoomScene
makeRoom(const RoomOptions& options)
{
  checkMeasure("width", options.width, allowed_measure);
  checkMeasure("depth", options.depth, allowed_measure);
  checkMeasure("height", options.height, allowed_height);
  RandomGenerator generator(options.seed);
  for (int attempt = 0; attempt < layout_attempts; ++attempt)
    if (const std::optional<RoomScene> scene = drawLayout(options, generator))
      return *scene;
  throw CIDException("the room has no place for all the furniture asked for; allowed "
                     "are a larger room or smaller counts");
}

} // namespace pcl_cid::test
