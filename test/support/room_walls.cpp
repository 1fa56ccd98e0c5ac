/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The four walls of a test room.
 */

#include "room_walls.h"

#include <algorithm>

namespace pcl_cid::test {
namespace {

/// Things on one wall keep at least twice this far apart along it.
constexpr double margin_on_wall = 0.12;

} // namespace

std::optional<double>
Wall::takeStretch(RandomGenerator& generator, double width)
{
  const double half = width / 2 + margin_on_wall;
  if (2 * half > length_)
    return std::nullopt;
  const double middle = drawWithin(generator, {half, length_ - half});
  const Stretch wanted{middle - half, middle + half};
  for (const Stretch& other : taken_)
    if (wanted.begin < other.end && other.begin < wanted.end)
      return std::nullopt;
  taken_.push_back(wanted);
  return middle;
}

Piece
Wall::makePiece(double height) const
{
  std::vector<Opening> openings = openings_;
  std::sort(openings.begin(), openings.end(), [](const Opening& a, const Opening& b) {
    return a.left < b.left;
  });
  Piece wall;
  const auto addStrip = [&](double left, double right, double bottom, double top) {
    if (top > bottom)
      wall.primitives.push_back(makeBox(left, right, 0.0, 0.0, bottom, top));
  };
  double left = 0.0;
  for (const Opening& opening : openings) {
    addStrip(left, opening.left, 0.0, height);
    addStrip(opening.left, opening.right, 0.0, opening.bottom);
    addStrip(opening.left, opening.right, opening.top, height);
    left = opening.right;
  }
  addStrip(left, length_, 0.0, height);
  return moved(wall, pose_);
}

std::array<Wall, 4>
makeWalls(double width, double depth)
{
  return {Wall{{{0.0, 0.0}, {1.0, 0.0}}, width},
          Wall{{{width, 0.0}, {0.0, 1.0}}, depth},
          Wall{{{width, depth}, {-1.0, 0.0}}, width},
          Wall{{{0.0, depth}, {0.0, -1.0}}, depth}};
}

} // namespace pcl_cid::test
