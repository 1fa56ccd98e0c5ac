/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The places near a hull against the exact distance of every place.
 */

#include "fitting/hull_cover.h"
#include "free_places.h"
#include "hulls.h"
#include "portable_draw.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** Distance from a place to a triangle, by its sides and its inside. */
double
distanceToTriangle(const Eigen::Vector3d& x,
                   const Eigen::Vector3d& a,
                   const Eigen::Vector3d& b,
                   const Eigen::Vector3d& c)
{
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const auto isBeyond = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return normal.cross(to - from).dot(x - from) < 0.0;
  };
  if (!isBeyond(a, b) && !isBeyond(b, c) && !isBeyond(c, a))
    return std::abs(normal.normalized().dot(x - a));
  const auto toSegment = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Eigen::Vector3d along = to - from;
    const double share =
        std::clamp(along.dot(x - from) / along.squaredNorm(), 0.0, 1.0);
    return (x - from - share * along).norm();
  };
  return std::min({toSegment(a, b), toSegment(b, c), toSegment(c, a)});
}

/** 0 inside. */
double
distanceToHull(const FastHull& hull, const Eigen::Vector3d& x)
{
  double excess = -std::numeric_limits<double>::infinity();
  for (const HalfSpace& face : hull.faces)
    excess = std::max(excess, face.excess(x));
  if (excess <= 0.0)
    return 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Triangle& t : hull.triangles)
    nearest =
        std::min(nearest,
                 distanceToTriangle(
                     x, hull.vertices[t[0]], hull.vertices[t[1]], hull.vertices[t[2]]));
  return nearest;
}

/** Few points at the corners of a room, so that nearly all of it is free. */
struct EmptyRoom {
  Points points = {{0, 0, 0},
                   {2, 0, 0},
                   {0, 1.5f, 0},
                   {2, 1.5f, 0},
                   {0, 0, 1},
                   {2, 0, 1},
                   {0, 1.5f, 1},
                   {2, 1.5f, 1}};
  DistanceField field{points};
  Progress progress{{}};
  FreeSpace space{points, field, 0.15, {}, 1, progress};
  std::vector<Eigen::Vector3d> places = freePlaces(space);
};

const EmptyRoom&
emptyRoom()
{
  static const EmptyRoom room;
  return room;
}

class CoverOfHulls : public testing::Test {
protected:
  /** Fails unless what is visited ascends, holds all places nearer than the radius, and
   *  none that are much farther. */
  void
  expectCovers(const FastHull& hull,
               double radius,
               double most,
               const std::string& what)
  {
    std::vector<bool> visited(space_.size());
    std::uint32_t next = 0;
    for (const PlaceRange& range : placesNear(hull, space_, radius)) {
      ASSERT_LT(range.begin, range.end) << what;
      ASSERT_GE(range.begin, next) << what;
      ASSERT_LE(range.end, space_.size()) << what;
      std::fill(visited.begin() + range.begin, visited.begin() + range.end, true);
      next = range.end;
    }
    const double rounding = 1e-3 * space_.step();
    // Faces that turn by less than this, in radians, count as one.
    const double bend = std::acos(1.0 - 1e-4) * diagonalOf(hull);
    // Other places each time, as there are a million.
    constexpr std::size_t looked_at = 29;
    for (std::size_t i = ++calls_ % looked_at; i < space_.size(); i += looked_at) {
      const double distance = distanceToHull(hull, places_[i]);
      if (distance < radius - rounding) {
        ASSERT_TRUE(visited[i]) << what << ": missed at " << distance;
      }
      else if (distance > most + bend + rounding) {
        ASSERT_FALSE(visited[i]) << what << ": too far, at " << distance;
      }
    }
  }

  const FreeSpace& space_ = emptyRoom().space;
  const std::vector<Eigen::Vector3d>& places_ = emptyRoom().places;
  std::size_t calls_ = 0;
};

std::vector<Eigen::Vector3d>
cornersOfBox(const Eigen::Vector3d& low, const Eigen::Vector3d& size)
{
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(low + Eigen::Vector3d(i & 1 ? size.x() : 0.0,
                                            i & 2 ? size.y() : 0.0,
                                            i & 4 ? size.z() : 0.0));
  return corners;
}

TEST_F(CoverOfHulls, BoxesTurnedAnyWay)
{
  RandomGenerator generator(31);
  for (int round = 0; round < 40; ++round) {
    const Eigen::Vector3d low(2.2 * drawUnit(generator) - 0.3,
                              1.6 * drawUnit(generator) - 0.3,
                              1.2 * drawUnit(generator) - 0.3);
    const Eigen::Vector3d size(0.005 + drawUnit(generator),
                               0.005 + drawUnit(generator),
                               round % 4 == 0 ? 0.005 : drawUnit(generator));
    std::vector<Eigen::Vector3d> corners = cornersOfBox(low, size);
    if (round % 2 == 1) {
      const Eigen::AngleAxisd turn(3.0 * drawUnit(generator),
                                   Eigen::Vector3d(drawUnit(generator) - 0.5,
                                                   drawUnit(generator) - 0.5,
                                                   drawUnit(generator) - 0.5)
                                       .normalized());
      for (Eigen::Vector3d& corner : corners)
        corner = low + turn * (corner - low);
    }
    const double radius = round % 5 == 0 ? 0.0 : 0.3 * drawUnit(generator);
    expectCovers(fastHull(corners),
                 radius,
                 std::sqrt(3.0) * radius,
                 "round " + std::to_string(round));
    if (HasFailure())
      return;
  }
}

TEST_F(CoverOfHulls, HullsOfRandomPoints)
{
  RandomGenerator generator(32);
  const double any = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 40; ++round) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 4 + round % 9; ++i)
      points.emplace_back(2.4 * drawUnit(generator) - 0.2,
                          1.9 * drawUnit(generator) - 0.2,
                          1.4 * drawUnit(generator) - 0.2);
    const double radius = round % 5 == 0 ? 0.0 : 0.3 * drawUnit(generator);
    expectCovers(fastHull(points),
                 radius,
                 radius == 0.0 ? 0.0 : any,
                 "round " + std::to_string(round));
    if (HasFailure())
      return;
  }
}

/** Faces that a column of places runs along, nearly or exactly. */
TEST_F(CoverOfHulls, FacesAlongTheColumns)
{
  const Eigen::Matrix3d to_scan = gridAxes(space_);
  RandomGenerator generator(33);
  for (const double tilt : {0.0, 1e-7, 1e-5, 9e-5, -9e-5, 1.1e-4, 1e-3}) {
    const Eigen::AngleAxisd lean(tilt, Eigen::Vector3d(0.8, 0.6, 0.0));
    for (int round = 0; round < 4; ++round) {
      std::vector<Eigen::Vector3d> corners = cornersOfBox(
          -0.5 * Eigen::Vector3d(0.9, 0.7, 3.0), Eigen::Vector3d(0.9, 0.7, 3.0));
      const Eigen::Vector3d center(1.0 + 0.1 * drawUnit(generator), 0.7, 0.5);
      for (Eigen::Vector3d& corner : corners)
        corner = center + to_scan * (lean * corner);
      const double radius = 0.05 * round;
      expectCovers(fastHull(corners),
                   radius,
                   std::sqrt(3.0) * radius,
                   "tilt " + std::to_string(tilt));
    }
  }
}

TEST_F(CoverOfHulls, HullAroundEverythingTakesAllPlaces)
{
  const FastHull hull =
      fastHull(cornersOfBox({-1.0, -1.0, -1.0}, Eigen::Vector3d(9.0, 9.0, 9.0)));
  std::size_t count = 0;
  for (const PlaceRange& range : placesNear(hull, space_, 0.0))
    count += range.end - range.begin;
  EXPECT_EQ(count, space_.size());
  const FastHull small = fastHull(cornersOfBox({1, 1, 0}, {0.1, 0.1, 0.1}));
  count = 0;
  for (const PlaceRange& range : placesNear(small, space_, 1e12))
    count += range.end - range.begin;
  EXPECT_EQ(count, space_.size());
}

TEST_F(CoverOfHulls, NothingNearHullsThatAreFarOrFlat)
{
  const FastHull far = fastHull(cornersOfBox({50.0, 0.0, 0.0}, {1.0, 1.0, 1.0}));
  EXPECT_TRUE(placesNear(far, space_, 1.0).empty());
  const FastHull farther = fastHull(cornersOfBox({1e12, 0.0, 0.0}, {1e6, 1e6, 1e6}));
  EXPECT_TRUE(placesNear(farther, space_, 1.0).empty());
  EXPECT_TRUE(placesNear(FastHull(), space_, 1.0).empty());
}

TEST_F(CoverOfHulls, EndsWhenTheVisitorSaysSo)
{
  const FastHull hull = fastHull(cornersOfBox({0.3, 0.3, 0.2}, {1.2, 0.8, 0.5}));
  const std::vector<PlaceRange> all = placesNear(hull, space_, 0.1);
  ASSERT_GT(all.size(), 10u);
  EXPECT_TRUE(
      visitPlacesNear(hull, space_, 0.1, [](const PlaceRange&) { return true; }));
  for (const std::size_t last : {std::size_t{1}, std::size_t{7}, all.size()}) {
    std::vector<PlaceRange> visited;
    EXPECT_FALSE(visitPlacesNear(hull, space_, 0.1, [&](const PlaceRange& range) {
      visited.push_back(range);
      return visited.size() < last;
    }));
    ASSERT_EQ(visited.size(), last);
    for (std::size_t i = 0; i < last; ++i)
      EXPECT_EQ(visited[i].begin, all[i].begin);
  }
}

} // namespace
} // namespace pcl_cid::test
