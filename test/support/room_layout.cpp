/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A furnished room: pieces placed one by one, by trial and collision test.
 */

#include "room_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include <pcl_cid/exceptions.h>

#include "furniture.h"
#include "room_builder.h"
#include "room_walls.h"

namespace pcl_cid::test {
namespace {

/// Places to try for a piece before the room counts as too small.
constexpr int placement_attempts = 400;
/// Solids at the same height keep at least this far apart in plan.
constexpr double furniture_gap = 0.03;
constexpr double clutter_gap = 0.01;
/// A bookcase or sofa stands this far from its wall.
constexpr double wall_gap = 0.02;
/// No furniture this far in front of a door.
constexpr double door_clearance = 0.9;
/// Doors and windows end below the beams of the lowest room.
constexpr double opening_top = 2.05;
constexpr double beam_depth = 0.25;

/// Braces, because the order of evaluation within parentheses is not fixed.
Eigen::Vector3d
drawSize(const RoomOptions& options, RandomGenerator& generator)
{
  return {drawWithin(generator, options.width),
          drawWithin(generator, options.depth),
          drawWithin(generator, options.height)};
}

Eigen::Vector2d
drawQuarterTurn(RandomGenerator& generator)
{
  constexpr std::array<double, 5> around{1.0, 0.0, -1.0, 0.0, 1.0};
  const std::size_t turn = drawBelow(generator, 4);
  return {around[turn], around[(turn + 3) % 4]};
}

/// Length of a piece along its x axis.
double
widthOf(const Piece& piece)
{
  double half_width = 0.0;
  for (const Primitive& primitive : piece.primitives)
    half_width =
        std::max(half_width, std::abs(primitive.center.x()) + primitive.half.x());
  return 2 * half_width;
}

/** One attempt at a room. A step that finds no place says so with false. */
class RoomLayout {
public:
  RoomLayout(const RoomOptions& options, RandomGenerator& generator)
  : options_(options)
  , generator_(generator)
  , size_(drawSize(options, generator))
  , walls_(makeWalls(size_.x(), size_.y()))
  , room_(size_)
  {
  }

  std::optional<RoomScene>
  draw()
  {
    const bool is_complete =
        repeat(options_.doors, [&] { return placeDoor(); }) &&
        repeat(options_.windows, [&] { return placeWindow(); }) && addShell() &&
        placeBeams() && repeat(options_.columns, [&] { return placeColumn(); }) &&
        repeat(options_.bookcases, [&] { return placeBookcase(); }) &&
        repeat(options_.boards, [&] { return placeBoard(); }) &&
        repeat(options_.pictures, [&] { return placePicture(); }) &&
        repeat(options_.sofas, [&] { return placeSofa(); }) &&
        repeat(options_.tables, [&] { return placeTable(); }) &&
        repeat(options_.chairs, [&] { return placeChair(); }) &&
        repeat(options_.clutter, [&] { return placeClutter(); });
    return is_complete ? std::optional<RoomScene>(room_.scene()) : std::nullopt;
  }

private:
  template <typename Step>
  static bool
  repeat(unsigned count, const Step& step)
  {
    for (unsigned done = 0; done < count; ++done)
      if (!step())
        return false;
    return true;
  }

  /// Runs \a place until it succeeds, but not for ever.
  template <typename Place>
  static bool
  tryPlaces(const Place& place)
  {
    for (int attempt = 0; attempt < placement_attempts; ++attempt)
      if (place())
        return true;
    return false;
  }

  Wall&
  drawWall()
  {
    return walls_[drawBelow(generator_, walls_.size())];
  }

  /// Anywhere in the room, square to the walls or slightly turned.
  Pose
  drawFloorPose()
  {
    const double x = drawWithin(generator_, {0.0, size_.x()});
    const double y = drawWithin(generator_, {0.0, size_.y()});
    const Eigen::Vector2d quarter = drawQuarterTurn(generator_);
    return composed({{x, y}, quarter},
                    {{0.0, 0.0}, drawTurn(generator_, options_.turn)});
  }

  /// A hole of \a width in some wall.
  std::optional<Opening>
  placeOpening(Wall& wall, double width, double bottom)
  {
    const std::optional<double> middle = wall.takeStretch(generator_, width);
    if (!middle)
      return std::nullopt;
    const Opening opening{
        *middle - width / 2, *middle + width / 2, bottom, opening_top};
    wall.addOpening(opening);
    return opening;
  }

  bool
  placeDoor()
  {
    return tryPlaces([&] {
      Wall& wall = drawWall();
      const std::optional<Opening> opening = placeOpening(wall, 0.90, 0.0);
      if (!opening)
        return false;
      room_.add(moved(makeDoor(*opening), wall.pose()), RoomClass::door);
      const Primitive way_in = makeBox(
          opening->left, opening->right, 0.0, door_clearance, 0.01, opening_top);
      room_.keepFree(moved(way_in, wall.pose()));
      return true;
    });
  }

  bool
  placeWindow()
  {
    const double width = drawWithin(generator_, {1.0, 1.7});
    const double bottom = drawWithin(generator_, {0.85, 1.0});
    return tryPlaces([&] {
      Wall& wall = drawWall();
      const std::optional<Opening> opening = placeOpening(wall, width, bottom);
      if (opening)
        room_.add(moved(makeWindow(*opening), wall.pose()), RoomClass::window);
      return opening.has_value();
    });
  }

  bool
  addShell()
  {
    Piece plane;
    plane.primitives = {makeBox(0.0, size_.x(), 0.0, size_.y(), size_.z(), size_.z())};
    room_.add(plane, RoomClass::ceiling);
    plane.primitives = {makeBox(0.0, size_.x(), 0.0, size_.y(), 0.0, 0.0)};
    room_.add(plane, RoomClass::floor);
    for (const Wall& wall : walls_)
      room_.add(wall.makePiece(size_.z()), RoomClass::wall);
    room_.closeShell();
    return true;
  }

  /// Beams cross the room along y, evenly spaced but for a little play.
  bool
  placeBeams()
  {
    const double spacing = size_.x() / (options_.beams + 1);
    for (unsigned i = 1; i <= options_.beams; ++i) {
      const double x = (i + drawWithin(generator_, {-0.2, 0.2})) * spacing;
      const double half = drawWithin(generator_, {0.10, 0.16});
      Piece beam;
      beam.primitives = {makeBox(
          x - half, x + half, 0.0, size_.y(), size_.z() - beam_depth, size_.z())};
      if (!room_.addIfFree(beam, RoomClass::beam, furniture_gap))
        return false;
      beam_positions_.push_back(x);
    }
    return true;
  }

  /// A column carries a beam where there is one, and reaches the ceiling otherwise.
  bool
  placeColumn()
  {
    const double half = drawWithin(generator_, {0.15, 0.20});
    const bool has_beam = !beam_positions_.empty();
    const double top = has_beam ? size_.z() - beam_depth : size_.z();
    Piece column;
    column.primitives = {makeBox(-half, half, -half, half, 0.0, top)};
    return tryPlaces([&] {
      Pose pose{drawFloorPose().origin};
      if (has_beam)
        pose.origin.x() =
            beam_positions_[drawBelow(generator_, beam_positions_.size())];
      return room_.addIfFree(moved(column, pose), RoomClass::column, furniture_gap);
    });
  }

  /// On a stretch of a wall that nothing else uses, so that nothing hides behind it.
  bool
  placeOnWall(const Piece& piece, RoomClass room_class, double gap)
  {
    return tryPlaces([&] {
      Wall& wall = drawWall();
      const std::optional<double> middle = wall.takeStretch(generator_, widthOf(piece));
      if (!middle)
        return false;
      const Pose pose = composed(wall.pose(), {{*middle, gap}});
      last_placed_ = moved(piece, pose);
      const bool is_placed = room_.addIfFree(last_placed_, room_class, furniture_gap);
      if (!is_placed)
        wall.releaseStretch();
      return is_placed;
    });
  }

  bool
  placeBookcase()
  {
    if (!placeOnWall(makeBookcase(generator_), RoomClass::bookcase, wall_gap))
      return false;
    room_.addShelves(last_placed_.supports);
    return true;
  }

  bool
  placeBoard()
  {
    return placeOnWall(makeBoard(generator_), RoomClass::board, 0.0);
  }

  bool
  placePicture()
  {
    return placeOnWall(makePicture(generator_), RoomClass::clutter, 0.0);
  }

  /// At a wall; a low sofa may stand below a window or board.
  bool
  placeSofa()
  {
    const Piece sofa = makeSofa(generator_);
    return tryPlaces([&] {
      const Wall& wall = drawWall();
      const double x = drawWithin(generator_, {0.0, wall.length()});
      const Pose pose = composed(wall.pose(), {{x, wall_gap}});
      return room_.addIfFree(moved(sofa, pose), RoomClass::sofa, furniture_gap);
    });
  }

  bool
  placeTable()
  {
    const Piece table = makeTable(generator_);
    return tryPlaces([&] {
      const Piece placed = moved(table, drawFloorPose());
      if (!room_.addIfFree(placed, RoomClass::table, furniture_gap))
        return false;
      table_tops_.push_back(placed.supports.front());
      return true;
    });
  }

  /// At a table, more or less pushed under it; anywhere when there is no table.
  Pose
  drawChairPose()
  {
    if (table_tops_.empty())
      return drawFloorPose();
    const Support& top = table_tops_[drawBelow(generator_, table_tops_.size())];
    const Eigen::Vector2d side = drawQuarterTurn(generator_);
    const bool is_long_side = side.y() == 0.0;
    const double half_width = (is_long_side ? top.width : top.depth) / 2;
    const double half_depth = (is_long_side ? top.depth : top.width) / 2;
    const double x = drawWithin(generator_, {-half_width, half_width});
    const double from_edge = drawWithin(generator_, {0.05, 0.45});
    const Pose at_side = composed(
        {{0.0, 0.0}, side}, {{x, -half_depth - from_edge}, drawTurn(generator_, 0.20)});
    return composed(top.pose, at_side);
  }

  bool
  placeChair()
  {
    const Piece chair = makeChair(generator_);
    const auto placeAtTable = [&] {
      return room_.addIfFree(
          moved(chair, drawChairPose()), RoomClass::chair, furniture_gap);
    };
    const auto placeAnywhere = [&] {
      return room_.addIfFree(
          moved(chair, drawFloorPose()), RoomClass::chair, furniture_gap);
    };
    return tryPlaces(placeAtTable) || tryPlaces(placeAnywhere);
  }

  /// Three of five things go to a table, one to a shelf, one to the floor.
  std::optional<Support>
  drawSupport()
  {
    const std::uint64_t choice = drawBelow(generator_, 5);
    if (choice == 0)
      return Support{{size_.head<2>() / 2}, size_.x(), size_.y(), 0.0, size_.z()};
    const std::vector<Support>& supports =
        choice == 1 ? room_.scene().shelves : table_tops_;
    if (supports.empty())
      return std::nullopt;
    return supports[drawBelow(generator_, supports.size())];
  }

  static bool
  fits(const Piece& piece, const Support& support)
  {
    for (const Primitive& primitive : piece.primitives) {
      const Eigen::Vector3d reach =
          primitive.center.cwiseAbs() + boundingHalf(primitive);
      if (reach.x() > support.width / 2 || reach.y() > support.depth / 2 ||
          primitive.center.z() + primitive.half.z() > support.headroom)
        return false;
    }
    return true;
  }

  bool
  placeClutter()
  {
    const Piece thing = makeClutter(generator_);
    return tryPlaces([&] {
      const std::optional<Support> support = drawSupport();
      if (!support)
        return false;
      const double x = drawWithin(generator_, {-0.5, 0.5}) * support->width;
      const double y = drawWithin(generator_, {-0.5, 0.5}) * support->depth;
      const Piece on_support = moved(thing, {{x, y}, drawTurn(generator_, 0.3)});
      return fits(on_support, *support) &&
             room_.addIfFree(moved(on_support, support->pose, support->z),
                             RoomClass::clutter,
                             clutter_gap);
    });
  }

  const RoomOptions& options_;
  RandomGenerator& generator_;
  Eigen::Vector3d size_;
  std::array<Wall, 4> walls_;
  RoomBuilder room_;
  std::vector<double> beam_positions_;
  std::vector<Support> table_tops_;
  Piece last_placed_;
};

} // namespace

std::optional<RoomScene>
drawLayout(const RoomOptions& options, RandomGenerator& generator)
{
  return RoomLayout(options, generator).draw();
}

RoomScene
drawRoom(RoomOptions (*draw_options)(RandomGenerator&),
         RandomGenerator& generator,
         std::uint64_t seed)
{
  constexpr int attempts = 100;
  for (int attempt = 0; attempt < attempts; ++attempt)
    if (const std::optional<RoomScene> scene =
            drawLayout(draw_options(generator), generator))
      return *scene;
  throw CIDException("none of the rooms drawn from seed " + std::to_string(seed) +
                     " has place for what is in it; allowed is any other seed");
}

} // namespace pcl_cid::test
