/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The furnished rooms: what was asked for stands there, on something, in free air.
 */

#include <algorithm>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include <pcl_cid/exceptions.h>

#include "furniture.h"
#include "primitive_tree.h"
#include "room_oracle.h"
#include "room_scene.h"

namespace pcl_cid::test {
namespace {

constexpr std::uint64_t seeds = 8;

RoomScene
makeSeededRoom(std::uint64_t seed)
{
  RoomOptions options;
  options.seed = seed;
  return makeRoom(options);
}

bool
sameRoom(const RoomScene& a, const RoomScene& b)
{
  const auto same = [](const Primitive& p, const Primitive& q) {
    return p.shape == q.shape && p.center == q.center && p.half == q.half &&
           p.axis == q.axis && p.instance == q.instance;
  };
  return a.size == b.size && a.class_of_instance == b.class_of_instance &&
         std::equal(a.primitives.begin(),
                    a.primitives.end(),
                    b.primitives.begin(),
                    b.primitives.end(),
                    same);
}

std::ptrdiff_t
countOf(const RoomScene& scene, RoomClass room_class)
{
  return std::count(
      scene.class_of_instance.begin(), scene.class_of_instance.end(), room_class);
}

RoomClass
classOf(const RoomScene& scene, const Primitive& primitive)
{
  return scene.class_of_instance[primitive.instance];
}

double
bottomOf(const RoomScene& scene, std::uint32_t instance)
{
  double bottom = scene.size.z();
  for (const Primitive& primitive : scene.primitives)
    if (primitive.instance == instance)
      bottom = std::min(bottom, primitive.center.z() - primitive.half.z());
  return bottom;
}

/// Whether a lowest primitive of \a instance rests on a solid of another one.
bool
standsOnSomething(const RoomScene& scene, std::uint32_t instance)
{
  const double bottom = bottomOf(scene, instance);
  for (const Primitive& foot : scene.primitives) {
    if (foot.instance != instance || foot.center.z() - foot.half.z() > bottom + 1e-9)
      continue;
    const Eigen::Vector3d sole(foot.center.x(), foot.center.y(), bottom);
    for (const Primitive& ground : scene.primitives)
      if (ground.instance != instance &&
          std::abs(signedDistance(ground, sole)) < 1e-9 && ground.center.z() <= bottom)
        return true;
  }
  return false;
}

TEST(RoomScene, IsTheSameForTheSameSeedOnly)
{
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    EXPECT_TRUE(sameRoom(makeSeededRoom(seed), makeSeededRoom(seed)));
    EXPECT_FALSE(sameRoom(makeSeededRoom(seed), makeSeededRoom(seed + 1)));
  }
}

TEST(RoomScene, HasEverythingAskedFor)
{
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    RoomOptions options;
    options.seed = seed;
    options.doors = 2;
    options.boards = 2;
    options.chairs = 7;
    const RoomScene scene = makeRoom(options);
    EXPECT_EQ(countOf(scene, RoomClass::ceiling), 1);
    EXPECT_EQ(countOf(scene, RoomClass::floor), 1);
    EXPECT_EQ(countOf(scene, RoomClass::wall), 4);
    EXPECT_EQ(countOf(scene, RoomClass::door), options.doors);
    EXPECT_EQ(countOf(scene, RoomClass::window), options.windows);
    EXPECT_EQ(countOf(scene, RoomClass::beam), options.beams);
    EXPECT_EQ(countOf(scene, RoomClass::column), options.columns);
    EXPECT_EQ(countOf(scene, RoomClass::bookcase), options.bookcases);
    EXPECT_EQ(countOf(scene, RoomClass::board), options.boards);
    EXPECT_EQ(countOf(scene, RoomClass::sofa), options.sofas);
    EXPECT_EQ(countOf(scene, RoomClass::table), options.tables);
    EXPECT_EQ(countOf(scene, RoomClass::chair), options.chairs);
    EXPECT_EQ(countOf(scene, RoomClass::clutter), options.clutter);
  }
}

TEST(RoomScene, EveryInstanceHasPrimitives)
{
  const RoomScene scene = makeSeededRoom(1);
  for (std::uint32_t i = 1; i < scene.class_of_instance.size(); ++i)
    EXPECT_TRUE(std::any_of(scene.primitives.begin(),
                            scene.primitives.end(),
                            [i](const Primitive& p) { return p.instance == i; }))
        << "instance " << i;
}

TEST(RoomScene, NothingInterpenetrates)
{
  for (std::uint64_t seed = 0; seed < seeds; ++seed)
    EXPECT_LT(deepestPenetration(makeSeededRoom(seed), 0.06), 1e-6) << "seed " << seed;
}

TEST(RoomScene, PushedFurnitureWouldBeNoticed)
{
  RoomScene scene = makeSeededRoom(0);
  const auto isSofa = [&](const Primitive& primitive) {
    return classOf(scene, primitive) == RoomClass::sofa;
  };
  const auto sofa =
      std::find_if(scene.primitives.begin(), scene.primitives.end(), isSofa);
  ASSERT_NE(sofa, scene.primitives.end());
  Primitive intruder = makeBox(-0.2, 0.2, -0.2, 0.2, -0.2, 0.2);
  intruder.center = sofa->center;
  intruder.instance = 1;
  scene.primitives.push_back(intruder);
  EXPECT_GT(deepestPenetration(scene, 0.04), 0.05);
}

TEST(RoomScene, FurnitureStandsOnTheFloorAndClutterOnSomething)
{
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const RoomScene scene = makeSeededRoom(seed);
    for (std::uint32_t i = 1; i < scene.class_of_instance.size(); ++i)
      switch (scene.class_of_instance[i]) {
      case RoomClass::column:
      case RoomClass::table:
      case RoomClass::chair:
      case RoomClass::sofa:
      case RoomClass::bookcase:
        EXPECT_NEAR(bottomOf(scene, i), 0.0, 1e-9) << "seed " << seed;
        EXPECT_TRUE(standsOnSomething(scene, i)) << "seed " << seed;
        break;
      case RoomClass::clutter:
        EXPECT_TRUE(standsOnSomething(scene, i)) << "seed " << seed;
        break;
      default:
        break;
      }
  }
}

TEST(RoomScene, LiesWithinItsWallsButForTheOpenings)
{
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const RoomScene scene = makeSeededRoom(seed);
    for (const Primitive& primitive : scene.primitives) {
      const bool is_opening = classOf(scene, primitive) == RoomClass::door ||
                              classOf(scene, primitive) == RoomClass::window;
      const double recess = is_opening ? 0.2 : 1e-6;
      for (const SurfacePoint& point : surfaceGrid(primitive, 0.2)) {
        EXPECT_GE(point.position.minCoeff(), -recess);
        EXPECT_LE((point.position - scene.size).maxCoeff(), recess);
      }
    }
  }
}

TEST(RoomScene, MayBeEmpty)
{
  RoomOptions options;
  options.doors = options.windows = options.beams = options.columns = 0;
  options.bookcases = options.boards = options.sofas = 0;
  options.tables = options.chairs = options.clutter = 0;
  const RoomScene scene = makeRoom(options);
  EXPECT_EQ(scene.primitives.size(), 6u);
  EXPECT_EQ(scene.class_of_instance.size(), 7u);
}

TEST(RoomScene, RefusesWhatIsOutOfRange)
{
  RoomOptions too_much;
  too_much.tables = 200;
  EXPECT_THROW(makeRoom(too_much), CIDException);
  RoomOptions too_low;
  too_low.height = {2.0, 2.2};
  EXPECT_THROW(makeRoom(too_low), CIDException);
  RoomOptions reversed;
  reversed.width = {7.0, 6.0};
  EXPECT_THROW(makeRoom(reversed), CIDException);
  RoomOptions not_a_number;
  not_a_number.depth.high = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(makeRoom(not_a_number), CIDException);
}

TEST(RoomScene, ClassNamesFollowTheClasses)
{
  const std::vector<std::string>& names = roomClassNames();
  ASSERT_EQ(names.size(), 14u);
  EXPECT_EQ(names[static_cast<std::size_t>(RoomClass::none)], "none");
  EXPECT_EQ(names[static_cast<std::size_t>(RoomClass::column)], "column");
  EXPECT_EQ(names[static_cast<std::size_t>(RoomClass::clutter)], "clutter");
}

TEST(PrimitiveTree, FindsWhatALoopOverAllPrimitivesFinds)
{
  const RoomScene scene = makeSeededRoom(3);
  const PrimitiveTree tree(scene.primitives);
  RandomGenerator generator(5);
  int hits = 0;
  for (int ray = 0; ray < 20000; ++ray) {
    const Eigen::Vector3d origin{drawWithin(generator, {-1.0, scene.size.x() + 1.0}),
                                 drawWithin(generator, {-1.0, scene.size.y() + 1.0}),
                                 drawWithin(generator, {-1.0, scene.size.z() + 1.0})};
    Eigen::Vector3d direction{drawWithin(generator, {-1.0, 1.0}),
                              drawWithin(generator, {-1.0, 1.0}),
                              drawWithin(generator, {-1.0, 1.0})};
    if (ray % 10 == 0)
      direction[ray / 10 % 3] = 0.0;
    if (ray % 100 == 0)
      direction[(ray / 100 + 1) % 3] = 0.0;
    if (direction.norm() == 0.0)
      continue;
    direction.normalize();

    RayHit expected{scene.primitives.size(), {1e9, 0.0}};
    for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
      SurfaceHit surface;
      if (intersect(scene.primitives[i], origin, direction, surface) &&
          surface.range < expected.surface.range)
        expected = {i, surface};
    }
    RayHit found;
    ASSERT_EQ(tree.firstHit(origin, direction, found),
              expected.primitive < scene.primitives.size());
    ASSERT_EQ(found.primitive, expected.primitive);
    if (found.primitive == scene.primitives.size())
      continue;
    ++hits;
    const Eigen::Vector3d point = origin + found.surface.range * direction;
    const Primitive& primitive = scene.primitives[found.primitive];
    ASSERT_LT(std::abs(signedDistance(primitive, point)), 1e-9);
    const Eigen::Vector3d before = point - 1e-5 * direction;
    const double cosine = signedDistance(primitive, before) / 1e-5;
    ASSERT_NEAR(found.surface.incidence_cosine, cosine, 1e-2);
  }
  EXPECT_GT(hits, 10000);
}

TEST(PrimitiveTree, KnowsWhichPointsAreCovered)
{
  const RoomScene scene = makeSeededRoom(4);
  const PrimitiveTree tree(scene.primitives);
  int covered = 0;
  for (std::size_t self = 0; self < scene.primitives.size(); ++self)
    for (const SurfacePoint& point : surfaceGrid(scene.primitives[self], 0.1)) {
      bool expected = false;
      for (std::size_t other = 0; other < scene.primitives.size(); ++other)
        expected = expected || (other != self && signedDistance(scene.primitives[other],
                                                                point.position) < 1e-6);
      ASSERT_EQ(tree.isCovered(point.position, self), expected);
      covered += expected ? 1 : 0;
    }
  EXPECT_GT(covered, 100);
}

} // namespace
} // namespace pcl_cid::test
