/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Free places against brute force, and what was seen against rays.
 */

#include "clouds.h"
#include "free_places.h"
#include "portable_draw.h"
#include "primitive_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

FreeSpace
freeSpaceOf(const Points& points,
            double clearance,
            const std::vector<Eigen::Vector3d>& viewpoints = {})
{
  Progress progress({});
  return FreeSpace(points, DistanceField(points), clearance, viewpoints, 1, progress);
}

double
distanceByLoop(const Points& points, const Eigen::Vector3d& x)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3f& p : points)
    nearest = std::min(nearest, (p.cast<double>() - x).squaredNorm());
  return std::sqrt(nearest);
}

Eigen::AlignedBox3d
boxOfPoints(const Points& points)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& p : points)
    box.extend(p.cast<double>());
  return box;
}

/** Calls \a visit(place, number along x, y, z) for the places of the endless grid that
 *  are well inside of the box. */
template <typename Visit>
void
forEachPlaceInBox(const FreeSpace& space,
                  const Eigen::AlignedBox3d& box,
                  const Visit& visit)
{
  Eigen::AlignedBox3d turned;
  for (int corner = 0; corner < 8; ++corner)
    turned.extend(
        space.toGrid(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner))));
  const Eigen::Matrix3d steps = gridSteps(space);
  const Eigen::Vector3d first = placeAt(space, Eigen::Vector3d::Zero());
  const Eigen::Array3i low = turned.min().array().floor().cast<int>() - 1;
  const Eigen::Array3i high = turned.max().array().ceil().cast<int>() + 1;
  const double border = 1e-6 * box.diagonal().norm();
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(border);
  const Eigen::AlignedBox3d inside(box.min() + margin, box.max() - margin);
  for (int x = low.x(); x <= high.x(); ++x)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int z = low.z(); z <= high.z(); ++z) {
        const Eigen::Vector3i at(x, y, z);
        const Eigen::Vector3d place = first + steps * at.cast<double>();
        if (inside.contains(place))
          visit(place, at);
      }
}

bool
isOnGrid(const FreeSpace& space, const Eigen::Vector3i& at)
{
  return (at.array() >= 0).all() && (at.array() < space.places()).all();
}

bool
isFreePlace(const FreeSpace& space, const Eigen::Vector3i& at)
{
  bool any = false;
  space.forEachRange(
      at.x(), at.y(), at.z(), at.z() + 1, [&](const PlaceRange&) { any = true; });
  return any;
}

/** Free are exactly the places of the box that are far enough from all points. */
void
expectExactPlaces(const Points& points, double clearance, const std::string& what)
{
  const FreeSpace space = freeSpaceOf(points, clearance);
  const double rounding = 1e-5 * boxOfPoints(points).diagonal().norm();
  std::size_t free = 0, unsure = 0;
  bool covers_box = true, agrees = true;
  forEachPlaceInBox(space,
                    boxOfPoints(points),
                    [&](const Eigen::Vector3d& place, const Eigen::Vector3i& at) {
                      covers_box = covers_box && isOnGrid(space, at);
                      if (!covers_box)
                        return;
                      const double distance = distanceByLoop(points, place);
                      const bool is_free = isFreePlace(space, at);
                      free += is_free ? 1 : 0;
                      if (std::abs(distance - clearance) < rounding)
                        ++unsure;
                      else
                        agrees = agrees && is_free == (distance > clearance);
                    });
  EXPECT_TRUE(covers_box) << what;
  EXPECT_TRUE(agrees) << what;
  // The rest are at the border of the box.
  EXPECT_LE(free, space.size()) << what;
  EXPECT_LE(space.size() - free, 1000u) << what;
  EXPECT_LT(unsure, 1000u) << what;
}

TEST(FreeSpace, IsEveryPlaceFarFromThePoints)
{
  expectExactPlaces(randomCube(60, 41), 0.15, "cube");
  expectExactPlaces(twoBoxes(100, 42), 0.3, "boxes");
  Points far = randomCube(20, 43);
  for (Eigen::Vector3f& p : far)
    p = 64.0f * p + Eigen::Vector3f(512.0f, -256.0f, 1024.0f);
  expectExactPlaces(far, 10.0, "far");
}

TEST(FreeSpace, VisitsAllPlacesInAscendingNumbers)
{
  const FreeSpace space = freeSpaceOf(twoBoxes(400, 44), 0.1);
  ASSERT_GT(space.size(), 1000u);
  std::uint32_t next = 0;
  const Eigen::Array3i places = space.places();
  for (int y = 0; y < places.y(); ++y)
    for (int x = 0; x < places.x(); ++x)
      space.forEachRange(x, y, 0, places.z(), [&](const PlaceRange& range) {
        ASSERT_EQ(range.begin, next);
        ASSERT_LT(range.begin, range.end);
        next = range.end;
      });
  EXPECT_EQ(next, space.size());
}

/** A column by halves is the column. */
TEST(FreeSpace, RangesEndWhereTheyAreTold)
{
  const FreeSpace space = freeSpaceOf(twoBoxes(400, 45), 0.1);
  const Eigen::Array3i places = space.places();
  RandomGenerator generator(46);
  for (int round = 0; round < 20000; ++round) {
    const auto drawn = [&](int below) {
      return static_cast<int>(drawBelow(generator, static_cast<std::uint64_t>(below)));
    };
    const int x = drawn(places.x()), y = drawn(places.y()), cut = drawn(places.z());
    std::vector<std::uint32_t> whole, halves;
    const auto listIn = [](std::vector<std::uint32_t>& list) {
      return [&list](const PlaceRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i)
          list.push_back(i);
      };
    };
    space.forEachRange(x, y, 0, places.z(), listIn(whole));
    space.forEachRange(x, y, 0, cut, listIn(halves));
    space.forEachRange(x, y, cut, places.z(), listIn(halves));
    ASSERT_EQ(whole, halves);
  }
}

/** A room with a box in it, seen from one corner. */
struct RoomWithBox {
  std::vector<Primitive> walls = {makeBox(0, 4, 0, 3, 0, 0),
                                  makeBox(0, 4, 0, 3, 2.5, 2.5),
                                  makeBox(0, 0, 0, 3, 0, 2.5),
                                  makeBox(4, 4, 0, 3, 0, 2.5),
                                  makeBox(0, 4, 0, 0, 0, 2.5),
                                  makeBox(0, 4, 3, 3, 0, 2.5),
                                  makeBox(1.8, 2.6, 1.0, 1.9, 0.5, 1.6)};
  PrimitiveTree tree{walls};
  Eigen::Vector3d viewpoint{0.7, 0.6, 1.1};

  /** How far one sees. */
  double
  rangeAlong(const Eigen::Vector3d& direction) const
  {
    RayHit hit{};
    return tree.firstHit(viewpoint, direction, hit) ? hit.surface.range : 0.0;
  }

  Points
  scan(std::size_t rays) const
  {
    RandomGenerator generator(48);
    Points points;
    while (points.size() < rays) {
      const double x = 2.0 * drawUnit(generator) - 1.0;
      const double y = 2.0 * drawUnit(generator) - 1.0;
      const double z = 2.0 * drawUnit(generator) - 1.0;
      const Eigen::Vector3d direction(x, y, z);
      if (direction.norm() > 1.0 || direction.norm() < 0.1)
        continue;
      const double range = rangeAlong(direction.normalized());
      points.push_back((viewpoint + range * direction.normalized()).cast<float>());
    }
    return points;
  }

  /** Whether something is before a place in all directions within some degrees. */
  bool
  isHiddenWell(const Eigen::Vector3d& place, double degrees) const
  {
    const Eigen::Vector3d to_place = place - viewpoint;
    const Eigen::Vector3d side = to_place.unitOrthogonal();
    const Eigen::Vector3d other = to_place.normalized().cross(side);
    const double off = std::tan(degrees * M_PI / 180.0);
    for (int k = 0; k < 16; ++k) {
      const double angle = 2.0 * M_PI * k / 16.0;
      const Eigen::Vector3d direction =
          (to_place.normalized() +
           off * (std::cos(angle) * side + std::sin(angle) * other))
              .normalized();
      if (rangeAlong(direction) > 0.98 * to_place.norm())
        return false;
    }
    return rangeAlong(to_place.normalized()) < to_place.norm();
  }
};

TEST(FreeSpace, SeenPlacesAreThoseThatRaysCross)
{
  const RoomWithBox room;
  const Points points = room.scan(200000);
  const FreeSpace space = freeSpaceOf(points, 0.15, {room.viewpoint});
  const Eigen::Matrix3d steps = gridSteps(space);
  const Eigen::Vector3d first = placeAt(space, Eigen::Vector3d::Zero());
  // The diagonal of a cell of directions.
  constexpr double degrees = 1.9;
  std::size_t visible = 0, visible_and_free = 0, hidden = 0, hidden_but_free = 0;
  for (int x = 0; x < space.places().x(); x += 3)
    for (int y = 0; y < space.places().y(); y += 3)
      for (int z = 0; z < space.places().z(); z += 3) {
        const Eigen::Vector3i at(x, y, z);
        const Eigen::Vector3d place = first + steps * at.cast<double>();
        const Eigen::Vector3d to_place = place - room.viewpoint;
        double nearest = std::numeric_limits<double>::infinity();
        for (const Primitive& wall : room.walls)
          nearest = std::min(nearest, distanceTo(wall, place));
        const bool is_in_room = (place.array() > 0.0).all() && place.x() < 4.0 &&
                                place.y() < 3.0 && place.z() < 2.5;
        if (!is_in_room || nearest < 0.2)
          continue;
        if (room.isHiddenWell(place, degrees)) {
          ++hidden;
          hidden_but_free += isFreePlace(space, at) ? 1 : 0;
        }
        else if (room.rangeAlong(to_place.normalized()) > to_place.norm()) {
          ++visible;
          visible_and_free += isFreePlace(space, at) ? 1 : 0;
        }
      }
  EXPECT_GT(visible, 5000u);
  EXPECT_GT(hidden, 500u);
  EXPECT_EQ(hidden_but_free, 0u) << "of " << hidden;
  EXPECT_GT(static_cast<double>(visible_and_free), 0.9 * static_cast<double>(visible));
}

TEST(FreeSpace, SeenPlacesAreAmongThoseThatAreFar)
{
  const Points points = twoBoxes(500, 49);
  const FreeSpace all = freeSpaceOf(points, 0.2);
  const Eigen::Vector3d inside(0.5, 0.5, 0.5);
  const FreeSpace seen = freeSpaceOf(points, 0.2, {inside});
  const FreeSpace by_two = freeSpaceOf(points, 0.2, {inside, {3.0, 0.5, 0.8}});
  ASSERT_TRUE((all.places() == seen.places()).all());
  EXPECT_LT(seen.size(), all.size());
  EXPECT_LT(by_two.size(), all.size());
  EXPECT_GT(by_two.size(), 0u);
  for (int y = 0; y < all.places().y(); y += 2)
    for (int x = 0; x < all.places().x(); x += 2)
      for (int z = 0; z < all.places().z(); z += 2)
        if (isFreePlace(seen, {x, y, z}) || isFreePlace(by_two, {x, y, z})) {
          ASSERT_TRUE(isFreePlace(all, {x, y, z}));
        }
}

TEST(FreeSpace, ViewpointsAnywhere)
{
  const Points points = twoBoxes(200, 50);
  for (const Eigen::Vector3d& viewpoint : {Eigen::Vector3d(1e6, 0.0, 0.0),
                                           Eigen::Vector3d(-1e15, 1e15, 1e15),
                                           Eigen::Vector3d(points[7].cast<double>())})
    EXPECT_LE(freeSpaceOf(points, 0.2, {viewpoint}).size(),
              freeSpaceOf(points, 0.2).size());
  // Exactly at a place of the grid.
  const FreeSpace all = freeSpaceOf(points, 0.2);
  const Eigen::Vector3d place =
      placeAt(all, (0.5 * all.places().cast<double>()).floor().matrix());
  EXPECT_LE(freeSpaceOf(points, 0.2, {place}).size(), all.size());
}

TEST(FreeSpace, PointsThatFillNoSpaceHaveNone)
{
  for (const NamedPoints& cloud : degenerateClouds()) {
    const FreeSpace space = freeSpaceOf(cloud.points, 0.05);
    EXPECT_GT(space.step(), 0.0) << cloud.name;
    EXPECT_TRUE(space.toGrid(cloud.points.front().cast<double>()).allFinite())
        << cloud.name;
    EXPECT_TRUE((space.places() >= 1).all()) << cloud.name;
    if (boxOfPoints(cloud.points).volume() == 0.0) {
      EXPECT_EQ(space.size(), 0u) << cloud.name;
    }
  }
}

} // namespace
} // namespace pcl_cid::test
