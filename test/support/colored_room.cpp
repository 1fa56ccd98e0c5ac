/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Furnished rooms with colors: the furniture is painted, then more is put among it.
 */

#include "colored_room.h"

#include <array>
#include <utility>

#include "furniture_paint.h"
#include "painted_pieces.h"
#include "room_builder.h"
#include "room_layout.h"
#include "room_walls.h"

namespace pcl_cid::test {
namespace {

/** Places to try for a thing before the room goes without it. */
constexpr int place_attempts = 200;
/** Nothing stands nearer than this before what is on a wall, which would be hidden. */
constexpr double free_before_wall = 0.25;
constexpr double free_before_door = 0.70;
/** Gaps in plan. Books touch, up to rounding. */
constexpr double person_gap = 0.05;
constexpr double rug_gap = 0.01;
constexpr double curtain_gap = 0.02;
constexpr double book_gap = -1e-7;
/** Curtains end below the beams of the lowest room. */
constexpr double curtain_top = 2.25;
constexpr unsigned most_books_of_a_shelf = 8;

/** Fewer things than in a room of makeVariousRoom(): the walls must show. */
RoomOptions
drawFurnishing(RandomGenerator& generator)
{
  RoomOptions room;
  room.width = drawMeasure(generator, {4.0, 5.5});
  room.depth = drawMeasure(generator, {3.0, 4.5});
  room.height = drawMeasure(generator, {2.6, 3.0});
  room.turn = drawWithin(generator, {0.02, 0.3});
  room.doors = drawCount(generator, 0, 1);
  room.windows = drawCount(generator, 1, 2);
  room.beams = drawCount(generator, 0, 1);
  room.columns = drawCount(generator, 0, 1);
  room.bookcases = drawCount(generator, 1, 2);
  room.boards = drawCount(generator, 0, 1);
  room.sofas = drawCount(generator, 0, 1);
  room.tables = drawCount(generator, 1, 2);
  room.chairs = drawCount(generator, 2, 4);
  room.clutter = drawCount(generator, 3, 8);
  return room;
}

/** Adds thing after thing; what finds no place is left out. */
class RoomDecorator {
public:
  RoomDecorator(RoomScene scene, RandomGenerator& generator)
  : generator_(generator)
  , size_(scene.size)
  , walls_(makeWalls(size_.x(), size_.y()))
  , materials_(paintFurniture(scene, generator))
  , room_(std::move(scene))
  {
    for (const RoomClass room_class : room_.scene().class_of_instance)
      names_.push_back(roomClassNames()[static_cast<std::size_t>(room_class)]);
  }

  ColoredRoom
  decorate()
  {
    keepOpeningsFree(RoomClass::door, free_before_door);
    repeat(1, 1, [&] { placeFlushDoor(); });
    repeat(1, 2, [&] { placeCurtain(); });
    keepOpeningsFree(RoomClass::window, free_before_wall);
    repeat(2, 4, [&] { placePoster(); });
    repeat(2, 4, [&] { placePaper(); });
    repeat(1, 2, [&] { placeRug(); });
    repeat(1, 2, [&] { placePerson(); });
    repeat(2, 3, [&] { fillShelf(); });
    return {room_.scene(), materials_, names_, drawLamps()};
  }

private:
  template <typename Step>
  void
  repeat(unsigned least, unsigned most, const Step& step)
  {
    for (unsigned left = drawCount(generator_, least, most); left > 0; --left)
      step();
  }

  /// No later thing covers a door or window, or stands close before it.
  void
  keepOpeningsFree(RoomClass room_class, double depth)
  {
    const RoomScene& scene = room_.scene();
    for (const Primitive& primitive : scene.primitives) {
      const bool closes_opening = primitive.half.y() == 0.0 &&
                                  primitive.half.x() > 0.0 && primitive.half.z() > 0.0;
      if (scene.class_of_instance[primitive.instance] != room_class || !closes_opening)
        continue;
      Primitive area = primitive;
      area.half.y() =
          depth + 0.15;      // the opening is closed up to 0.15 m behind the wall
      area.half.z() -= 0.01; // a rug may lie there
      room_.keepFree(area);
    }
  }

  /// Adds \a thing, in its place already, as an instance of this name.
  bool
  addIfFree(const PaintedPiece& thing,
            const Pose& pose,
            double z,
            RoomClass room_class,
            const std::string& name,
            double gap)
  {
    if (!room_.addIfFree(moved(thing.piece, pose, z), room_class, gap))
      return false;
    materials_.insert(materials_.end(), thing.materials.begin(), thing.materials.end());
    names_.push_back(name);
    return true;
  }

  bool
  tryOnWalls(const PaintedPiece& thing,
             RoomClass room_class,
             const std::string& name,
             double gap)
  {
    for (int attempt = 0; attempt < place_attempts; ++attempt) {
      const Wall& wall = walls_[drawBelow(generator_, walls_.size())];
      const double x = drawWithin(generator_, {0.0, wall.length()});
      if (addIfFree(
              thing, composed(wall.pose(), {{x, 0.0}}), 0.0, room_class, name, gap))
        return true;
    }
    return false;
  }

  /// Anywhere on the floor; \a turn is the tangent of half the greatest angle.
  void
  tryOnFloor(const PaintedPiece& thing,
             const std::string& name,
             double gap,
             double turn)
  {
    for (int attempt = 0; attempt < place_attempts; ++attempt) {
      const double x = drawWithin(generator_, {0.0, size_.x()});
      const double y = drawWithin(generator_, {0.0, size_.y()});
      const Pose pose{{x, y}, drawTurn(generator_, turn)};
      if (addIfFree(thing, pose, 0.0, RoomClass::clutter, name, gap))
        return;
    }
  }

  void
  placeFlushDoor()
  {
    const PaintedPiece door = makeFlushDoor(generator_);
    if (!tryOnWalls(door, RoomClass::door, "flush door", free_before_door))
      return;
    const std::vector<Primitive>& all = room_.scene().primitives;
    Primitive way_in = all[all.size() - door.piece.primitives.size()]; // the leaf
    way_in.half.y() = free_before_door;
    way_in.half.z() -= 0.01;
    room_.keepFree(way_in);
  }

  void
  placeCurtain()
  {
    tryOnWalls(makeCurtain(generator_, curtain_top),
               RoomClass::clutter,
               "curtain",
               curtain_gap);
  }

  void
  placePoster()
  {
    tryOnWalls(makePoster(generator_), RoomClass::clutter, "poster", free_before_wall);
  }

  void
  placePaper()
  {
    tryOnWalls(makePaper(generator_), RoomClass::clutter, "paper", free_before_wall);
  }

  void
  placeRug()
  {
    tryOnFloor(makeRug(generator_), "rug", rug_gap, 0.1);
  }

  void
  placePerson()
  {
    tryOnFloor(makePerson(generator_), "person", person_gap, 1.0);
  }

  /// Books side by side from the left, until one does not fit.
  void
  fillShelf()
  {
    const std::vector<Support>& shelves = room_.scene().shelves;
    if (shelves.empty())
      return;
    const Support shelf = shelves[drawBelow(generator_, shelves.size())];
    double x = drawWithin(generator_, {-0.5, -0.2}) * shelf.width;
    for (unsigned count = 0; count < most_books_of_a_shelf; ++count) {
      const PaintedPiece book = makeBook(generator_);
      const double front = shelf.depth / 2 - drawWithin(generator_, {0.010, 0.025});
      const Primitive& box = book.piece.primitives.front();
      const double end = x + 2 * box.half.x();
      if (end > shelf.width / 2 || 2 * box.half.z() > shelf.headroom ||
          !addIfFree(book,
                     composed(shelf.pose, {{x, front}}),
                     shelf.z,
                     RoomClass::clutter,
                     "book",
                     book_gap))
        return;
      x = end;
    }
  }

  /// Two below the ceiling, in the two halves of the room.
  std::vector<Eigen::Vector3d>
  drawLamps()
  {
    std::vector<Eigen::Vector3d> lamps;
    for (const double part : {0.25, 0.75}) { // one by one: arguments have no order
      const double y = size_.y() * drawWithin(generator_, {0.3, 0.7});
      const double x = size_.x() * (part + drawWithin(generator_, {-0.1, 0.1}));
      lamps.emplace_back(x, y, size_.z() - 0.3);
    }
    return lamps;
  }

  RandomGenerator& generator_;
  Eigen::Vector3d size_;
  std::array<Wall, 4> walls_;
  std::vector<Material> materials_;
  RoomBuilder room_;
  std::vector<std::string> names_;
};

} // namespace

ColoredRoom
makeColoredRoom(std::uint64_t seed)
{
  RandomGenerator generator(seed);
  return RoomDecorator(drawRoom(drawFurnishing, generator, seed), generator).decorate();
}

} // namespace pcl_cid::test
