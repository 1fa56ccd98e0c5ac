/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The pieces that furnish a test room, each of random measures.
 */

#pragma once

#include <vector>

#include "portable_draw.h"
#include "scene_primitive.h"

namespace pcl_cid::test {

/** \brief A horizontal rectangle that small things can stand on. */
struct Support {
  Pose pose;    ///< its center and direction in plan
  double width; ///< along its x axis
  double depth; ///< along its y axis
  double z;
  double headroom; ///< free height above it
};

/** \brief One piece of furniture: the primitives of one instance, in a frame whose
 *  z = 0 is what it stands on. */
struct Piece {
  std::vector<Primitive> primitives;
  std::vector<Support> supports;
};

/** \brief \a piece, given in the frame \a pose raised by \a z, in the outer frame. */
Piece
moved(const Piece& piece, const Pose& pose, double z = 0.0);

/** \brief Centered on the origin: a top with four legs or, one time in three, a round
 *  top on a column. */
Piece
makeTable(RandomGenerator& generator);

/** \brief Centered on the origin, looking along +y: seat, back and four legs. */
Piece
makeChair(RandomGenerator& generator);

/** \brief Its back on y = 0, its front towards +y: base, feet, back, arms, cushions. */
Piece
makeSofa(RandomGenerator& generator);

/** \brief Its back on y = 0, open towards +y: sides, back and boards. */
Piece
makeBookcase(RandomGenerator& generator);

/** \brief A whiteboard with a tray, fixed to the wall y = 0. */
Piece
makeBoard(RandomGenerator& generator);

/** \brief A framed picture, hung on the wall y = 0. */
Piece
makePicture(RandomGenerator& generator);

/** \brief A thing to stand about, centered on the origin: box, can or screen. */
Piece
makeClutter(RandomGenerator& generator);

/** \brief A hole in a wall, in the wall's frame (x along it, z up). */
struct Opening {
  double left;
  double right;
  double bottom;
  double top;
};

/** \brief What closes an \a opening in the wall y = 0, set back from it: reveals, leaf
 *  and handle of a door; reveals, pane and bars of a window. */
Piece
makeDoor(const Opening& opening);
Piece
makeWindow(const Opening& opening);

} // namespace pcl_cid::test
