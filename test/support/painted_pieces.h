/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Things of a test room that color or thin geometry tells apart, with their materials.
 */

#pragma once

#include <vector>

#include "furniture.h"
#include "material.h"

namespace pcl_cid::test {

/** \brief A piece, and a material for each of its primitives. */
struct PaintedPiece {
  Piece piece;
  std::vector<Material> materials;
};

/** \brief A print of 0.4 to 1.1 m or a sheet of A4, 1 mm thick, on the wall y = 0. */
PaintedPiece
makePoster(RandomGenerator& generator);
PaintedPiece
makePaper(RandomGenerator& generator);

/** \brief A door in the plane of the wall y = 0 but for 2 mm and its handle. */
PaintedPiece
makeFlushDoor(RandomGenerator& generator);

/** \brief A sheet in folds, 0.04 to 0.13 m before the wall y = 0, that hangs from a rod
 *  at \a top almost to the floor. */
PaintedPiece
makeCurtain(RandomGenerator& generator, double top);

/** \brief 6 mm of cloth on the floor, centered on the origin. */
PaintedPiece
makeRug(RandomGenerator& generator);

/** \brief A book or binder that stands: its left side at x = 0, its spine at y = 0,
 *  its other edges towards -y. */
PaintedPiece
makeBook(RandomGenerator& generator);

/** \brief Someone who stands at the origin and looks along +y. */
PaintedPiece
makePerson(RandomGenerator& generator);

} // namespace pcl_cid::test
