/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The rooms of a set: each another one, all in order.
 */

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "room_oracle.h"
#include "room_set.h"
#include "scan_cloud.h"

namespace pcl_cid::test {
namespace {

constexpr unsigned rooms = 20;

std::vector<RoomScene>
firstRooms()
{
  std::vector<RoomScene> scenes;
  for (unsigned room = 0; room < rooms; ++room)
    scenes.push_back(makeVariousRoom(seedOfRoom(0, room)));
  return scenes;
}

double
areaOf(const RoomScene& scene)
{
  return scene.size.x() * scene.size.y();
}

TEST(RoomSet, HasAllClassesAndRoomsThatDiffer)
{
  std::set<RoomClass> classes;
  std::set<std::size_t> instances;
  std::vector<double> areas;
  for (const RoomScene& scene : firstRooms()) {
    classes.insert(scene.class_of_instance.begin(), scene.class_of_instance.end());
    instances.insert(scene.class_of_instance.size());
    areas.push_back(areaOf(scene));
  }
  EXPECT_EQ(classes.size(), roomClassNames().size()); // "none" is instance 0
  EXPECT_GT(instances.size(), rooms / 2);
  EXPECT_EQ(std::set<double>(areas.begin(), areas.end()).size(), rooms);
  EXPECT_GT(*std::max_element(areas.begin(), areas.end()),
            2 * *std::min_element(areas.begin(), areas.end()));
}

TEST(RoomSet, IsTheSameForTheSameSeedOnly)
{
  std::set<std::uint64_t> seeds;
  for (const std::uint64_t random_seed : {0, 1})
    for (unsigned room = 0; room < rooms; ++room)
      seeds.insert(seedOfRoom(random_seed, room));
  EXPECT_EQ(seeds.size(), 2 * rooms);
  const std::uint64_t seed = seedOfRoom(0, 3);
  EXPECT_EQ(seedOfRoom(0, 3), seed);
  const auto scan = [](std::uint64_t of) {
    return scanVariousRoom(makeVariousRoom(of), 2000, of);
  };
  EXPECT_EQ(scan(seed).points, scan(seed).points);
  EXPECT_NE(scan(seed).points, scan(seedOfRoom(0, 4)).points);
}

TEST(RoomSet, AnySeedGivesARoom)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
    EXPECT_NO_THROW(makeVariousRoom(seed)) << "seed " << seed;
}

/// With pictures, and furniture turned at any angle.
TEST(RoomSetPieces, NothingInterpenetrates)
{
  for (unsigned room = 0; room < 3; ++room)
    EXPECT_LT(deepestPenetration(makeVariousRoom(seedOfRoom(0, room)), 0.08), 1e-6)
        << "room " << room;
}

TEST(RoomSet, ScansHaveTheTruthAsFields)
{
  const RoomScene scene = makeVariousRoom(1);
  const LabelledScan scan = scanVariousRoom(scene, 3000, 1);
  ASSERT_EQ(scan.points.size(), 3000u);
  const pcl::PCLPointCloud2 cloud = cloudOf(scan);
  ASSERT_EQ(cloud.data.size(), 3000u * cloud.point_step);
  ASSERT_EQ(cloud.fields.size(), 5u);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    std::uint32_t truth[2];
    std::memcpy(truth,
                &cloud.data[i * cloud.point_step + cloud.fields[3].offset],
                sizeof(truth));
    EXPECT_EQ(truth[0], scan.instance[i]);
    EXPECT_EQ(truth[1], static_cast<std::uint32_t>(scene.class_of_instance[truth[0]]));
  }
}

} // namespace
} // namespace pcl_cid::test
