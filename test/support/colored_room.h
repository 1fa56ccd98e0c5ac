/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Furnished rooms with colors, and things in them that color or thin geometry tells
 * apart.
 */

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "material.h"
#include "room_scene.h"

namespace pcl_cid::test {

/** \brief A room, and what it looks like. */
struct ColoredRoom {
  RoomScene scene;
  /// A material for each primitive of the scene.
  std::vector<Material> materials;
  /// What instance i is: the name of its class or, where that says less, "poster",
  /// "paper", "rug", "curtain", "book", "person" or "flush door"; entry 0 is "none".
  std::vector<std::string> names;
  /// Where light comes from.
  std::vector<Eigen::Vector3d> lamps;
};

/** \brief A furnished room of 12 to 25 square metres with posters and papers on its
 *  walls, rugs on its floor, doors flush with walls, curtains, books side by side in
 *  its bookcases, and people: as many of what is drawn as find a free place, each an
 *  instance of its own. As in makeRoom(), nothing interpenetrates; but a flush door may
 *  cover a part of a window.
 *  \return the same for the same seed, on every machine
 *  \throw CIDException when no draw was a room with place for its furniture */
ColoredRoom
makeColoredRoom(std::uint64_t seed);

} // namespace pcl_cid::test
