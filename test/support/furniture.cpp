/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The pieces that furnish a test room: measures in metres, solids that only touch.
 */

#include "furniture.h"

#include <algorithm>

namespace pcl_cid::test {
namespace {

void
addLegs(Piece& piece, double half_width, double half_depth, double side, double top)
{
  for (const double x : {-half_width, half_width - side})
    for (const double y : {-half_depth, half_depth - side})
      piece.primitives.push_back(makeBox(x, x + side, y, y + side, 0.0, top));
}

Piece
makeRectangularTable(RandomGenerator& generator)
{
  const double half_width = drawWithin(generator, {0.60, 0.90});
  const double half_depth = drawWithin(generator, {0.32, 0.45});
  const double height = drawWithin(generator, {0.71, 0.76});
  const double underside = height - 0.03;
  Piece table;
  table.primitives.push_back(
      makeBox(-half_width, half_width, -half_depth, half_depth, underside, height));
  addLegs(table, half_width - 0.03, half_depth - 0.03, 0.05, underside);
  table.supports.push_back({{}, 2 * half_width, 2 * half_depth, height, 0.8});
  return table;
}

Piece
makeRoundTable(RandomGenerator& generator)
{
  const double radius = drawWithin(generator, {0.45, 0.60});
  const double height = drawWithin(generator, {0.71, 0.76});
  const double underside = height - 0.03;
  const double inscribed_side = 1.4 * radius;
  Piece table;
  table.primitives.push_back(makeCylinder(0.0, 0.0, radius, underside, height));
  table.primitives.push_back(makeCylinder(0.0, 0.0, 0.045, 0.03, underside));
  table.primitives.push_back(makeCylinder(0.0, 0.0, 0.25, 0.0, 0.03));
  table.supports.push_back({{}, inscribed_side, inscribed_side, height, 0.8});
  return table;
}

Piece
makeCarton(RandomGenerator& generator)
{
  const double half_width = drawWithin(generator, {0.04, 0.16});
  const double half_depth = drawWithin(generator, {0.04, 0.12});
  const double height = drawWithin(generator, {0.04, 0.28});
  Piece carton;
  carton.primitives.push_back(
      makeBox(-half_width, half_width, -half_depth, half_depth, 0.0, height));
  return carton;
}

Piece
makeCan(RandomGenerator& generator)
{
  const double radius = drawWithin(generator, {0.035, 0.10});
  const double height = drawWithin(generator, {0.09, 0.28});
  Piece can;
  can.primitives.push_back(makeCylinder(0.0, 0.0, radius, 0.0, height));
  return can;
}

Piece
makeScreen(RandomGenerator& generator)
{
  const double half_width = drawWithin(generator, {0.22, 0.30});
  const double height = drawWithin(generator, {0.26, 0.34});
  Piece screen;
  screen.primitives.push_back(makeCylinder(0.0, 0.0, 0.10, 0.0, 0.015));
  screen.primitives.push_back(makeBox(-0.02, 0.02, -0.015, 0.005, 0.015, 0.25));
  screen.primitives.push_back(
      makeBox(-half_width, half_width, 0.005, 0.035, 0.10, 0.10 + height));
  return screen;
}

/// The four sides of a hole, from the wall to the depth at which it is closed.
void
addReveals(Piece& piece, const Opening& o, double depth)
{
  piece.primitives.push_back(makeBox(o.left, o.left, -depth, 0.0, o.bottom, o.top));
  piece.primitives.push_back(makeBox(o.right, o.right, -depth, 0.0, o.bottom, o.top));
  piece.primitives.push_back(makeBox(o.left, o.right, -depth, 0.0, o.top, o.top));
  piece.primitives.push_back(makeBox(o.left, o.right, -depth, 0.0, o.bottom, o.bottom));
}

} // namespace

Piece
moved(const Piece& piece, const Pose& pose, double z)
{
  Piece result;
  for (const Primitive& primitive : piece.primitives)
    result.primitives.push_back(moved(primitive, pose, z));
  for (Support support : piece.supports) {
    support.pose = composed(pose, support.pose);
    support.z += z;
    result.supports.push_back(support);
  }
  return result;
}

Piece
makeTable(RandomGenerator& generator)
{
  return drawBelow(generator, 3) == 0 ? makeRoundTable(generator)
                                      : makeRectangularTable(generator);
}

Piece
makeChair(RandomGenerator& generator)
{
  const double half_width = drawWithin(generator, {0.20, 0.24});
  const double half_depth = drawWithin(generator, {0.20, 0.23});
  const double seat = drawWithin(generator, {0.43, 0.47});
  const double back = drawWithin(generator, {0.82, 0.95});
  Piece chair;
  chair.primitives.push_back(
      makeBox(-half_width, half_width, -half_depth, half_depth, seat - 0.04, seat));
  chair.primitives.push_back(
      makeBox(-half_width, half_width, -half_depth, 0.03 - half_depth, seat, back));
  addLegs(chair, half_width, half_depth, 0.035, seat - 0.04);
  return chair;
}

Piece
makeSofa(RandomGenerator& generator)
{
  const double half_width = drawWithin(generator, {0.75, 1.05});
  const double depth = drawWithin(generator, {0.78, 0.90});
  const double inner = half_width - 0.16;
  Piece sofa;
  const auto add =
      [&](double x0, double x1, double y0, double y1, double z0, double z1) {
        sofa.primitives.push_back(makeBox(x0, x1, y0, y1, z0, z1));
      };
  add(-half_width, half_width, 0.0, depth, 0.08, 0.30);
  add(-half_width, half_width, 0.0, 0.20, 0.30, 0.80);
  add(-half_width, -inner, 0.20, depth, 0.30, 0.60);
  add(inner, half_width, 0.20, depth, 0.30, 0.60);
  add(-inner, -0.005, 0.20, depth, 0.30, 0.43);
  add(0.005, inner, 0.20, depth, 0.30, 0.43);
  for (const double x : {-half_width + 0.08, half_width - 0.08})
    for (const double y : {0.08, depth - 0.08})
      sofa.primitives.push_back(makeCylinder(x, y, 0.03, 0.0, 0.08));
  return sofa;
}

Piece
makeBookcase(RandomGenerator& generator)
{
  const double half_width = drawWithin(generator, {0.40, 0.60});
  const double depth = drawWithin(generator, {0.28, 0.36});
  const double height = drawWithin(generator, {1.50, 2.00});
  const double thickness = 0.025;
  const double inner = half_width - thickness;
  const int compartments = 4 + static_cast<int>(drawBelow(generator, 2));
  const double plinth = 0.06;
  const double spacing = (height - plinth - thickness) / compartments;

  Piece bookcase;
  bookcase.primitives.push_back(makeBox(-half_width, -inner, 0.0, depth, 0.0, height));
  bookcase.primitives.push_back(makeBox(inner, half_width, 0.0, depth, 0.0, height));
  bookcase.primitives.push_back(makeBox(-inner, inner, 0.0, 0.01, plinth, height));
  for (int board = 0; board <= compartments; ++board) {
    const double z = plinth + board * spacing;
    bookcase.primitives.push_back(
        makeBox(-inner, inner, 0.01, depth, z, z + thickness));
    const double headroom = board < compartments ? spacing - thickness : 0.4;
    bookcase.supports.push_back({{{0.0, 0.005 + depth / 2}, {1.0, 0.0}},
                                 2 * inner,
                                 depth - 0.01,
                                 z + thickness,
                                 headroom});
  }
  return bookcase;
}

Piece
makeBoard(RandomGenerator& generator)
{
  const double half_width = drawWithin(generator, {0.60, 1.00});
  const double bottom = drawWithin(generator, {0.85, 0.95});
  const double top = bottom + drawWithin(generator, {0.90, 1.15});
  Piece board;
  board.primitives.push_back(makeBox(-half_width, half_width, 0.0, 0.03, bottom, top));
  board.primitives.push_back(
      makeBox(-half_width / 2, half_width / 2, 0.03, 0.10, bottom, bottom + 0.02));
  return board;
}

Piece
makePicture(RandomGenerator& generator)
{
  const double half_width = drawWithin(generator, {0.20, 0.50});
  const double bottom = drawWithin(generator, {1.20, 1.45});
  const double top = bottom + drawWithin(generator, {0.30, 0.60});
  const double thickness = drawWithin(generator, {0.02, 0.05});
  Piece picture;
  picture.primitives.push_back(
      makeBox(-half_width, half_width, 0.0, thickness, bottom, top));
  return picture;
}

Piece
makeClutter(RandomGenerator& generator)
{
  switch (drawBelow(generator, 5)) {
  case 0:
    return makeScreen(generator);
  case 1:
  case 2:
    return makeCan(generator);
  default:
    return makeCarton(generator);
  }
}

Piece
makeDoor(const Opening& opening)
{
  const double depth = 0.10;
  const double handle = opening.left + 0.08;
  Piece door;
  addReveals(door, opening, depth);
  door.primitives.push_back(makeBox(
      opening.left, opening.right, -depth, -depth, opening.bottom, opening.top));
  door.primitives.push_back(
      makeBox(handle, handle + 0.12, -depth, -depth + 0.06, 1.03, 1.06));
  return door;
}

Piece
makeWindow(const Opening& opening)
{
  const double depth = 0.15;
  const double bar = 0.05;
  const double inside = -depth + 0.04;
  const double middle = (opening.left + opening.right) / 2;
  Piece window;
  addReveals(window, opening, depth);
  const auto addBar = [&](double x0, double x1, double z0, double z1) {
    window.primitives.push_back(makeBox(x0, x1, -depth, inside, z0, z1));
  };
  window.primitives.push_back(makeBox(
      opening.left, opening.right, -depth, -depth, opening.bottom, opening.top));
  addBar(opening.left, opening.right, opening.bottom, opening.bottom + bar);
  addBar(opening.left, opening.right, opening.top - bar, opening.top);
  for (const double x : {opening.left, middle - bar / 2, opening.right - bar})
    addBar(x, x + bar, opening.bottom + bar, opening.top - bar);
  return window;
}

} // namespace pcl_cid::test
