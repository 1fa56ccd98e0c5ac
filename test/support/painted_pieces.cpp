/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Things of a test room that color or thin geometry tells apart.
 */

#include "painted_pieces.h"

#include <cmath>

namespace pcl_cid::test {
namespace {

constexpr double print_thickness = 0.001;

void
addPart(PaintedPiece& painted, const Primitive& primitive, const Material& material)
{
  painted.piece.primitives.push_back(primitive);
  painted.materials.push_back(material);
}

/// On the wall, with its middle at eye level.
Primitive
makeSheetOnWall(RandomGenerator& generator, double half_width, double half_height)
{
  const double middle = drawWithin(generator, {1.35, 1.65});
  return makeBox(-half_width,
                 half_width,
                 0.0,
                 print_thickness,
                 middle - half_height,
                 middle + half_height);
}

/// A vertical rectangle between two places in plan.
Primitive
makeFold(const Eigen::Vector2d& begin,
         const Eigen::Vector2d& end,
         double bottom,
         double top)
{
  const Eigen::Vector2d along = end - begin;
  const double length = std::sqrt(along.x() * along.x() + along.y() * along.y());
  const Primitive flat = makeBox(-length / 2, length / 2, 0.0, 0.0, bottom, top);
  return moved(flat, {(begin + end) / 2, along / length});
}

/// One wave from 0 to 1 and back over a length of 1, of parabolas.
double
softWave(double x)
{
  const double t = 2.0 * (x - std::floor(x)) - 1.0;
  return std::abs(t) < 0.5 ? 1.0 - 2.0 * t * t
                           : 2.0 * (1.0 - std::abs(t)) * (1.0 - std::abs(t));
}

/// Left and right.
void
addPair(PaintedPiece& painted,
        double x,
        double radius,
        const Range& height,
        const Material& material)
{
  for (const double side : {-x, x})
    addPart(painted, makeCapsule(side, 0.0, radius, height.low, height.high), material);
}

} // namespace

PaintedPiece
makePoster(RandomGenerator& generator)
{
  const double half_width = drawWithin(generator, {0.20, 0.55});
  const double half_height = drawWithin(generator, {0.25, 0.45});
  PaintedPiece poster;
  const Primitive sheet = makeSheetOnWall(generator, half_width, half_height);
  const Rgb first = drawVivid(generator);
  addPart(poster, sheet, {first, drawVivid(generator), Pattern::blocks, 0.11});
  return poster;
}

PaintedPiece
makePaper(RandomGenerator& generator)
{
  const bool is_upright = drawBelow(generator, 2) == 0;
  PaintedPiece paper;
  const Primitive sheet = makeSheetOnWall(
      generator, is_upright ? 0.105 : 0.1485, is_upright ? 0.1485 : 0.105);
  const Rgb color =
      drawBelow(generator, 3) == 0 ? drawVivid(generator) : drawWhite(generator);
  addPart(paper, sheet, {color, drawDark(generator), Pattern::bands, 0.5});
  return paper;
}

PaintedPiece
makeFlushDoor(RandomGenerator& generator)
{
  const Rgb color =
      drawBelow(generator, 2) == 0 ? drawWood(generator) : drawVivid(generator);
  PaintedPiece door;
  addPart(door, makeBox(-0.45, 0.45, 0.0, 0.002, 0.0, 2.05), striped(color, 0.15));
  addPart(door, makeBox(-0.38, -0.26, 0.002, 0.06, 1.03, 1.06), {drawDark(generator)});
  return door;
}

PaintedPiece
makeCurtain(RandomGenerator& generator, double top)
{
  constexpr int steps = 8; // of a fold
  constexpr double fold = 0.16;
  const int folds = 4 + static_cast<int>(drawBelow(generator, 5));
  const double depth = drawWithin(generator, {0.05, 0.09});
  const double bottom = drawWithin(generator, {0.01, 0.06});
  const double half_width = folds * fold / 2;
  const Rgb color = drawVivid(generator);
  const Material cloth{color, 0.7 * color, Pattern::bands, 0.30};
  PaintedPiece curtain;
  const auto placeOf = [&](int step) {
    const double along = static_cast<double>(step) / steps;
    return Eigen::Vector2d(along * fold - half_width, 0.04 + depth * softWave(along));
  };
  for (int step = 0; step < folds * steps; ++step)
    addPart(curtain, makeFold(placeOf(step), placeOf(step + 1), bottom, top), cloth);
  const Primitive rod =
      makeBox(-half_width - 0.1, half_width + 0.1, 0.07, 0.09, top, top + 0.02);
  addPart(curtain, rod, {drawDark(generator)});
  for (const double x : {-half_width - 0.05, half_width + 0.05})
    addPart(curtain,
            makeBox(x - 0.01, x + 0.01, 0.0, 0.07, top, top + 0.02),
            curtain.materials.back());
  return curtain;
}

PaintedPiece
makeRug(RandomGenerator& generator)
{
  const double half_width = drawWithin(generator, {0.40, 1.00});
  const double half_depth = drawWithin(generator, {0.30, 0.60});
  const Rgb color = drawVivid(generator);
  const Pattern pattern =
      drawBelow(generator, 2) == 0 ? Pattern::checks : Pattern::stripes;
  PaintedPiece rug;
  addPart(rug,
          makeBox(-half_width, half_width, -half_depth, half_depth, 0.0, 0.006),
          {color, 0.6 * color + 0.4 * drawVivid(generator), pattern, 0.20});
  return rug;
}

PaintedPiece
makeBook(RandomGenerator& generator)
{
  const double thickness = drawWithin(generator, {0.03, 0.08});
  const double height = drawWithin(generator, {0.20, 0.30});
  const double depth = drawWithin(generator, {0.17, 0.23});
  const Rgb color =
      drawBelow(generator, 4) == 0 ? drawDark(generator) : drawVivid(generator);
  PaintedPiece book;
  addPart(book,
          makeBox(0.0, thickness, -depth, 0.0, 0.0, height),
          {color, drawPale(generator), Pattern::bands, 0.22});
  return book;
}

PaintedPiece
makePerson(RandomGenerator& generator)
{
  const double size = drawWithin(generator, {0.93, 1.08});
  const Material shirt{drawVivid(generator), drawPale(generator), Pattern::bands, 0.25};
  const Material trousers{drawDark(generator)};
  const Material skin{drawSkin(generator)};
  const Material hair{drawDark(generator)};
  const auto heights = [&](double low, double high) {
    return Range{size * low, size * high};
  };
  PaintedPiece person;
  addPair(person, 0.10, 0.08, heights(0.0, 0.92), trousers);
  addPair(person, 0.09, 0.12, heights(0.80, 1.46), shirt);
  addPair(person, 0.25, 0.05, heights(0.95, 1.44), shirt);
  addPair(person, 0.25, 0.04, heights(0.75, 1.00), skin);
  addPart(person, makeCylinder(0.0, 0.0, 0.05, size * 1.40, size * 1.56), skin);
  addPart(person, makeCapsule(0.0, 0.0, 0.09, size * 1.48, size * 1.74), skin);
  addPart(person, makeCapsule(0.0, -0.02, 0.10, size * 1.55, size * 1.77), hair);
  return person;
}

} // namespace pcl_cid::test
