/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A furnished room drawn from a seed, with the true instance and class of each solid.
 */

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "furniture.h"
#include "portable_draw.h"
#include "scene_primitive.h"

namespace pcl_cid::test {

/** \brief What room to draw. Lengths in metres. */
struct RoomOptions {
  std::uint64_t seed = 0;
  /// Inner measures; the width lies along x, the depth along y.
  Range width{5.5, 6.5};
  Range depth{4.5, 5.5};
  Range height{2.6, 3.0};
  /// How far furniture is turned from the walls: tangent of half the greatest angle.
  double turn = 0.15;
  unsigned doors = 1;
  unsigned windows = 2;
  unsigned beams = 1;
  unsigned columns = 1;
  unsigned bookcases = 2;
  unsigned boards = 1;
  /// Panels on walls; clutter, as in S3DIS.
  unsigned pictures = 0;
  unsigned sofas = 1;
  unsigned tables = 4;
  unsigned chairs = 9;
  unsigned clutter = 20;
};

/** \brief The classes of S3DIS, as indices into roomClassNames(). */
enum class RoomClass : std::uint8_t {
  none,
  ceiling,
  floor,
  wall,
  beam,
  column,
  window,
  door,
  table,
  chair,
  sofa,
  bookcase,
  board,
  clutter
};

/** \brief "none" and the names of the 13 classes of S3DIS. */
const std::vector<std::string>&
roomClassNames();

/** \brief A room in its own frame: the floor is z = 0, one of its corners the origin.
 */
struct RoomScene {
  Eigen::Vector3d size{0.0, 0.0, 0.0};
  std::vector<Primitive> primitives;
  /// The class of instance i; instances count from 1, entry 0 is none.
  std::vector<RoomClass> class_of_instance;
  /// What small things can stand on in its bookcases.
  std::vector<Support> shelves;
};

/** \brief Draws a furnished room. Pieces touch where they stand on each other, and
 *  never interpenetrate; floor, ceiling and each of the four walls are instances.
 *  \param[in] options measures, counts and the seed
 *  \return the same scene for the same options, on every machine
 *  \throw CIDException when a measure is out of range, or when the room has no place
 *  for what is asked for */
RoomScene
makeRoom(const RoomOptions& options);

} // namespace pcl_cid::test
