/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The colored rooms: what is in them, where it stands, and its colors.
 */

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "colored_room.h"
#include "even_sampler.h"
#include "room_oracle.h"
#include "scan_paint.h"

namespace pcl_cid::test {
namespace {

constexpr std::uint64_t colored_seeds = 6;

/// Lowest and highest of each instance along z.
std::map<std::uint32_t, Range>
heightsOf(const RoomScene& scene)
{
  std::map<std::uint32_t, Range> heights;
  for (const Primitive& primitive : scene.primitives) {
    Range& range =
        heights.try_emplace(primitive.instance, Range{1e9, -1e9}).first->second;
    range.low = std::min(range.low, primitive.center.z() - primitive.half.z());
    range.high = std::max(range.high, primitive.center.z() + primitive.half.z());
  }
  return heights;
}

double
distanceToWalls(const RoomScene& scene, const Primitive& primitive)
{
  double nearest = 1e9;
  for (const SurfacePoint& point : surfaceGrid(primitive, 0.05))
    nearest = std::min({nearest,
                        std::abs(point.position.x()),
                        std::abs(point.position.y()),
                        std::abs(scene.size.x() - point.position.x()),
                        std::abs(scene.size.y() - point.position.y())});
  return nearest;
}

TEST(ColoredRoom, HasAMaterialForEachPrimitiveAndANameForEachInstance)
{
  std::set<std::string> all;
  for (std::uint64_t seed = 0; seed < colored_seeds; ++seed) {
    const ColoredRoom room = makeColoredRoom(seed);
    EXPECT_EQ(room.materials.size(), room.scene.primitives.size());
    EXPECT_EQ(room.names.size(), room.scene.class_of_instance.size());
    std::set<std::uint32_t> instances;
    for (const Primitive& primitive : room.scene.primitives)
      instances.insert(primitive.instance);
    EXPECT_EQ(instances.size() + 1, room.names.size());
    all.insert(room.names.begin(), room.names.end());
  }
  for (const char* name :
       {"wall", "poster", "paper", "rug", "curtain", "book", "person", "flush door"})
    EXPECT_EQ(all.count(name), 1u) << name;
}

TEST(ColoredRoom, AnySeedGivesARoom)
{
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    EXPECT_NO_THROW(makeColoredRoom(seed)) << "seed " << seed;
}

TEST(ColoredRoom, NothingInterpenetrates)
{
  for (std::uint64_t seed = 0; seed < 3; ++seed)
    EXPECT_LT(deepestPenetration(makeColoredRoom(seed).scene, 0.06), 1e-6)
        << "seed " << seed;
}

TEST(ColoredRoom, NothingFloats)
{
  for (std::uint64_t seed = 0; seed < colored_seeds; ++seed) {
    const ColoredRoom room = makeColoredRoom(seed);
    const std::map<std::uint32_t, Range> heights = heightsOf(room.scene);
    std::map<std::uint32_t, double> from_walls;
    for (const Primitive& primitive : room.scene.primitives) {
      const double distance = distanceToWalls(room.scene, primitive);
      const auto place = from_walls.try_emplace(primitive.instance, distance).first;
      place->second = std::min(place->second, distance);
    }
    for (const auto& [instance, height] : heights) {
      const std::string& name = room.names[instance];
      if (name == "person" || name == "rug" || name == "flush door") {
        EXPECT_NEAR(height.low, 0.0, 1e-9) << name;
      }
      if (name == "poster" || name == "paper" || name == "curtain" ||
          name == "flush door") {
        EXPECT_LT(from_walls[instance], 1e-6) << name;
      }
    }
  }
}

TEST(ColoredRoom, BooksStandSideBySideOnAShelf)
{
  int pairs = 0;
  for (std::uint64_t seed = 0; seed < colored_seeds; ++seed) {
    const ColoredRoom room = makeColoredRoom(seed);
    std::vector<Primitive> books;
    for (const Primitive& primitive : room.scene.primitives)
      if (room.names[primitive.instance] == "book")
        books.push_back(primitive);
    for (const Primitive& book : books) {
      const double bottom = book.center.z() - book.half.z();
      EXPECT_TRUE(std::any_of(
          room.scene.shelves.begin(), room.scene.shelves.end(), [&](const Support& s) {
            return std::abs(s.z - bottom) < 1e-9;
          }));
      pairs += static_cast<int>(
          std::count_if(books.begin(), books.end(), [&](const Primitive& other) {
            return &other != &book && other.instance == book.instance + 1 &&
                   std::abs(distanceTo(other, book.center) - book.half.x()) < 1e-6;
          }));
    }
  }
  EXPECT_GT(pairs, 20);
}

TEST(ColoredRoom, ColorsLieWithinTheRangeOfTheMaterial)
{
  const ColoredRoom room = makeColoredRoom(3);
  LabelledScan scan = sampleRoomEvenly(room.scene, 20000, 1);
  paintScan(room, scan);
  ASSERT_EQ(scan.colors.size(), scan.points.size());
  std::set<int> reds;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Material& material = room.materials[scan.primitive[i]];
    const Rgb low = material.base.cwiseMin(material.second) * least_light;
    const Rgb high = material.base.cwiseMax(material.second);
    const Rgb color(scan.colors[i].r, scan.colors[i].g, scan.colors[i].b);
    ASSERT_GE((color - low).minCoeff(), -0.51);
    ASSERT_LE((color - high).maxCoeff(), 0.51);
    reds.insert(scan.colors[i].r);
  }
  EXPECT_GT(reds.size(), 100u);
}

TEST(ColoredRoom, SurfacesTowardsALampAreBrighter)
{
  ColoredRoom room;
  room.scene.size = {4.0, 4.0, 3.0};
  room.scene.class_of_instance = {RoomClass::none, RoomClass::clutter};
  room.scene.primitives = {makeBox(1.9, 2.1, 1.9, 2.1, 0.0, 1.0)};
  room.scene.primitives[0].instance = 1;
  room.materials = {Material{}};
  room.lamps = {{2.0, 2.0, 2.5}};
  LabelledScan scan;
  scan.points = {{2.0f, 2.0f, 1.0f}, {2.0f, 2.0f, 0.0f}, {2.1f, 2.0f, 0.5f}};
  scan.primitive = {0, 0, 0};
  paintScan(room, scan);
  EXPECT_GT(scan.colors[0].r, scan.colors[2].r);
  EXPECT_EQ(scan.colors[1].r, 100); // from below no lamp is seen
  EXPECT_LE(scan.colors[0].r, 200);
}

TEST(Material, StaysBetweenItsColorsAndUsesBoth)
{
  const Rgb dark(10.0, 20.0, 30.0);
  const Rgb light(200.0, 150.0, 100.0);
  for (const Pattern pattern :
       {Pattern::stripes, Pattern::checks, Pattern::bands, Pattern::blocks}) {
    const Material material{dark, light, pattern, 0.13};
    double least = 1e9;
    double most = -1e9;
    for (int i = 0; i < 10000; ++i) {
      const Rgb color =
          colorAt(material, (i % 100 - 50) * 0.017, (i / 100 - 50) * 0.017);
      EXPECT_GE((color - dark).minCoeff(), -1e-9);
      EXPECT_LE((color - light).maxCoeff(), 1e-9);
      least = std::min(least, color.x());
      most = std::max(most, color.x());
    }
    EXPECT_LT(least, 20.0);
    EXPECT_GT(most, 190.0);
  }
  EXPECT_EQ(colorAt({dark, light, Pattern::plain, 1.0}, 0.3, 0.7), dark);
}

TEST(Capsule, IsMetWhereItsDistanceIsZero)
{
  RandomGenerator generator(11);
  int hits = 0;
  for (int ray = 0; ray < 20000; ++ray) {
    const double radius = drawWithin(generator, {0.1, 0.3});
    const double top = 2 * radius + (ray % 3 == 0 ? 0.0 : drawUnit(generator));
    const Primitive capsule = makeCapsule(0.2, -0.1, radius, 0.0, top);
    const Eigen::Vector3d origin{drawWithin(generator, {-2.0, 2.0}),
                                 drawWithin(generator, {-2.0, 2.0}),
                                 drawWithin(generator, {-2.0, 3.0})};
    if (signedDistance(capsule, origin) < 0.01)
      continue;
    const Eigen::Vector3d target{drawWithin(generator, {-0.5, 0.5}),
                                 drawWithin(generator, {-0.5, 0.5}),
                                 drawWithin(generator, {-0.5, 2.0})};
    const Eigen::Vector3d direction = (target - origin).normalized();
    double walked = 0.0; // never farther than the way to the surface
    for (int step = 0; step < 2000 && walked < 6.0; ++step)
      walked += std::max(signedDistance(capsule, origin + walked * direction), 0.0);
    SurfaceHit hit;
    const bool is_met = intersect(capsule, origin, direction, hit);
    const double left = signedDistance(capsule, origin + walked * direction);
    if (is_met) {
      ++hits;
      ASSERT_NEAR(hit.range, walked, 1e-3);
      ASSERT_NEAR(signedDistance(capsule, origin + hit.range * direction), 0.0, 1e-9);
    }
    else
      ASSERT_GT(left, 1e-9);
    ASSERT_NEAR(distanceTo(capsule, origin), signedDistance(capsule, origin), 1e-12);
  }
  EXPECT_GT(hits, 2000);
}

TEST(Capsule, IsSampledEvenly)
{
  RoomScene scene;
  scene.size = {2.0, 2.0, 2.0};
  scene.class_of_instance = {RoomClass::none, RoomClass::clutter};
  scene.primitives = {makeCapsule(1.0, 1.0, 0.2, 0.5, 1.5)};
  scene.primitives[0].instance = 1;
  constexpr int layers = 10; // of equal height, hence of equal area
  std::vector<int> points(layers);
  const LabelledScan scan = sampleRoomEvenly(scene, 20000, 1);
  for (const Eigen::Vector3f& point : scan.points) {
    EXPECT_NEAR(signedDistance(scene.primitives[0], point.cast<double>()), 0.0, 1e-6);
    const int layer = static_cast<int>((point.z() - 0.5f) * layers);
    ++points[static_cast<std::size_t>(std::clamp(layer, 0, layers - 1))];
  }
  for (const int count : points)
    EXPECT_NEAR(count, 2000, 200); // 4.7 standard deviations
}

} // namespace
} // namespace pcl_cid::test
