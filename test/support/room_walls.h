/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The four walls of a test room: what is taken along each, and its openings.
 */

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "furniture.h"

namespace pcl_cid::test {

/** \brief One wall of a room: a frame with x along it and y into the room, and what
 *  its length is used for. */
class Wall {
public:
  Wall(const Pose& pose, double length) : pose_(pose), length_(length) {}

  const Pose&
  pose() const
  {
    return pose_;
  }
  double
  length() const
  {
    return length_;
  }

  /** \brief Draws a stretch of \a width that nothing else on this wall uses, and takes
   *  it.
   *  \return its middle, or nothing when the drawn place was not free */
  std::optional<double>
  takeStretch(RandomGenerator& generator, double width);

  /** \brief Gives back the stretch taken last. */
  void
  releaseStretch()
  {
    taken_.pop_back();
  }

  void
  addOpening(const Opening& opening)
  {
    openings_.push_back(opening);
  }

  /** \brief The wall up to \a height: rectangles around its openings, in the room. */
  Piece
  makePiece(double height) const;

private:
  struct Stretch {
    double begin;
    double end;
  };

  Pose pose_;
  double length_;
  std::vector<Stretch> taken_;
  std::vector<Opening> openings_;
};

/** \brief The walls of a rectangular room, counter-clockwise from the one on y = 0. */
std::array<Wall, 4>
makeWalls(double width, double depth);

} // namespace pcl_cid::test
