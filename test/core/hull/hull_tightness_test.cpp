/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hull concavity and free-space volume: known values, monotony, threads.
 */

#include "even_sampler.h"
#include "field/build_count.h"
#include "hulls.h"
#include "prepared_points.h"
#include "room_scene.h"
#include "seeds_on_points.h"

#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/hull_tightness.h>
#include <pcl_cid/exceptions.h>

#include <cmath>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

constexpr double spacing = 0.05;

/** The points of a grid in the box from 0 to \a size that a test lets pass. */
template <typename Test>
Points
gridPoints(const Eigen::Vector3d& size, const Test& test)
{
  Points points;
  const Eigen::Vector3i steps = (size / spacing).array().round().cast<int>();
  for (int i = 0; i <= steps.x(); ++i)
    for (int j = 0; j <= steps.y(); ++j)
      for (int k = 0; k <= steps.z(); ++k)
        if (const Eigen::Vector3d p = spacing * Eigen::Vector3d(i, j, k); test(p))
          points.push_back(p.cast<float>());
  return points;
}

TightnessOptions
freeBeyond(double free_distance)
{
  TightnessOptions options;
  options.free_distance = free_distance;
  return options;
}

Tightness
tightnessOf(const Points& points, const TightnessOptions& options)
{
  return TightnessMeter(pointSet(points), options).measure({partOf(points)});
}

TEST(Tightness, ASolidCubeHasNoFreeSpace)
{
  const Points points =
      gridPoints(Eigen::Vector3d::Ones(), [](const auto&) { return true; });
  const Tightness tightness =
      tightnessOf(points, freeBeyond(0.5 * std::sqrt(3.0) * spacing * 1.001));
  EXPECT_EQ(tightness.hulls.at(0).free_share, 0.0);
  EXPECT_EQ(tightness.free_volume, 0.0);
  EXPECT_NEAR(tightness.volume, 1.0, 1e-3);
  const double largest =
      0.5 * std::sqrt(2.0) * spacing; // between four points of a face
  EXPECT_LE(tightness.all.max_concavity, largest * 1.001);
  EXPECT_GE(tightness.all.max_concavity, largest * 0.95);
}

TEST(Tightness, AHollowCubeIsFreeInside)
{
  const auto on_surface = [](const Eigen::Vector3d& p) {
    return p.minCoeff() < 0.5 * spacing || p.maxCoeff() > 1.0 - 0.5 * spacing;
  };
  const Points points = gridPoints(Eigen::Vector3d::Ones(), on_surface);
  const double free_distance = 0.2;
  const Tightness tightness = tightnessOf(points, freeBeyond(free_distance));
  // The points are not quite a surface: a ball about one reaches less far above the
  // middle between four of them.
  const double reach =
      std::sqrt(free_distance * free_distance - 0.5 * spacing * spacing);
  const double least = std::pow(1.0 - 2.0 * free_distance, 3);
  const double most = std::pow(1.0 - 2.0 * reach, 3);
  for (const double share :
       {tightness.hulls.at(0).free_share, tightness.all.free_share}) {
    EXPECT_GE(share, least - 0.01);
    EXPECT_LE(share, most + 0.01);
  }
  EXPECT_NEAR(tightness.free_volume, tightness.all.free_share, 1e-2);
}

TEST(Tightness, AnLShapeStraysAcrossItsCorner)
{
  const Points points = gridPoints({2.0, 2.0, 1.0}, [](const Eigen::Vector3d& p) {
    return p.x() < 1.0 + 0.5 * spacing || p.y() < 1.0 + 0.5 * spacing;
  });
  const double free_distance = 0.1;
  const Tightness tightness = tightnessOf(points, freeBeyond(free_distance));
  // The hull adds a triangle of legs 1 to the three squares; free in it is a triangle
  // of legs 1 - 2 free_distance.
  const double legs = 1.0 - 2.0 * free_distance;
  EXPECT_NEAR(tightness.hulls.at(0).free_share, 0.5 * legs * legs / 3.5, 0.01);
  EXPECT_NEAR(tightness.free_volume, 0.5 * legs * legs, 0.03);
  EXPECT_NEAR(tightness.volume, 3.5, 0.03);
  EXPECT_NEAR(tightness.all.max_concavity, 0.5, 0.02);
}

TEST(Tightness, HullsThatOverlapCountOnceInTheUnion)
{
  const Points points =
      gridPoints(Eigen::Vector3d::Ones(), [](const auto&) { return true; });
  const TightnessMeter meter(pointSet(points), {});
  const ConvexPart part = partOf(points);
  EXPECT_EQ(meter.measure({part, part}).volume, meter.measure({part}).volume);
  EXPECT_EQ(meter.measure({}).volume, 0.0);
  EXPECT_EQ(meter.measure({}).all.free_share, 0.0);
}

/** Room scans, their groups, and how those merge. */
struct MergedRoom {
  explicit MergedRoom(std::uint64_t seed)
  {
    RoomOptions room;
    room.seed = seed;
    points = sampleRoomEvenly(makeRoom(room), 8000, seed).points;
    group = groupsOf(points, groups);
    GroupMergingOptions options;
    options.group_samples = 4;
    options.samples = 20;
    tree = mergeGroups(DistanceField(points), points, group, groups, options);
  }

  std::vector<ConvexPart>
  cut(std::size_t parts) const
  {
    const std::vector<int> part_of_group = tree.cutAtParts(parts);
    std::vector<int> part;
    for (const int g : group)
      part.push_back(part_of_group[static_cast<std::size_t>(g)]);
    ConvexPartOptions options;
    options.min_thickness = 1e-6; // next to no layer that a merge could take back
    return makeConvexParts(pointSet(points), part, options, {});
  }

  static constexpr std::size_t groups = 20;
  Points points;
  std::vector<int> group;
  MergeTree tree;
};

/** Whatever the surface of the scan is, tightness is measured to its points. */
TEST(Tightness, OfAPreparedScanIsThatOfItsPoints)
{
  Points points = gridPoints({1.0, 1.0, 0.5}, [](const Eigen::Vector3d& p) {
    return p.x() < 0.4 || p.y() < 0.3;
  });
  for (Eigen::Vector3f& p : points)
    p += Eigen::Vector3f(4096.0f, -1024.0f, 0.0f);
  RawScan raw = rawScan(points);
  RawScan elsewhere = raw;
  elsewhere.surface = {raw.points.points.front()};
  PreparationSettings half = plainSettings();
  half.subsample = static_cast<int>(points.size() / 2);
  const struct {
    PreparedScan::ConstPtr scan;
    std::size_t fields;
  } cases[] = {
      {std::make_shared<const PreparedScan>(raw, plainSettings()), 0},
      {std::make_shared<const PreparedScan>(elsewhere, plainSettings()), 1},
      {std::make_shared<const PreparedScan>(raw, half), 1},
  };
  TightnessOptions options = freeBeyond(0.07);
  options.box_samples = 20000;
  const Tightness expected =
      TightnessMeter(raw.points, options).measure({partOf(points)});
  EXPECT_GT(expected.free_volume, 0.0);
  for (const auto& each : cases) {
    const std::size_t before = fieldsBuilt();
    TightnessMeter meter(each.scan, options);
    EXPECT_EQ(fieldsBuilt() - before, each.fields);
    const Tightness tightness = meter.measure({partOf(points)});
    EXPECT_EQ(tightness.volume, expected.volume);
    EXPECT_EQ(tightness.free_volume, expected.free_volume);
    EXPECT_EQ(tightness.all.max_concavity, expected.all.max_concavity);
    EXPECT_EQ(tightness.all.mean_concavity, expected.all.mean_concavity);
    EXPECT_EQ(tightness.all.free_share, expected.all.free_share);
  }
  // The meter keeps the field of the scan alive.
  TightnessMeter meter(std::make_shared<const PreparedScan>(raw, plainSettings()),
                       options);
  EXPECT_EQ(meter.measure({partOf(points)}).free_volume, expected.free_volume);
  EXPECT_THROW(TightnessMeter(PreparedScan::ConstPtr(), options), CIDException);
  EXPECT_THROW(TightnessMeter(cases[0].scan, freeBeyond(0.0)), CIDException);
}

TEST(Tightness, FreeVolumeNeverFallsFromCutToCut)
{
  for (const std::uint64_t seed : {1, 2}) {
    const MergedRoom room(seed);
    TightnessOptions options = freeBeyond(0.2);
    options.hull_samples = 1;
    const TightnessMeter meter(pointSet(room.points), options);
    double volume = 0.0;
    double free_volume = 0.0;
    for (std::size_t parts = MergedRoom::groups; parts >= 1; --parts) {
      const Tightness tightness = meter.measure(room.cut(parts));
      EXPECT_EQ(tightness.hulls.size(), parts);
      EXPECT_GE(tightness.volume, volume) << parts;
      EXPECT_GE(tightness.free_volume, free_volume) << parts;
      volume = tightness.volume;
      free_volume = tightness.free_volume;
    }
    EXPECT_GT(free_volume, 0.5 * volume); // one hull around a room is mostly air
  }
}

TEST(Tightness, SameAtUtmCoordinates)
{
  Points near = gridPoints({2.0, 1.0, 1.0}, [](const Eigen::Vector3d& p) {
    return p.x() < 0.5 || p.z() < 0.25;
  });
  for (Eigen::Vector3f& p : near)
    p = (p * 5.0f / static_cast<float>(spacing)).array().round(); // whole metres
  Points far = near;
  for (Eigen::Vector3f& p : far)
    p += Eigen::Vector3f(524288.0f, 4194304.0f, 1024.0f);
  const Tightness here = tightnessOf(near, freeBeyond(10.0));
  const Tightness there = tightnessOf(far, freeBeyond(10.0));
  EXPECT_NEAR(here.all.max_concavity, there.all.max_concavity, 1e-3);
  EXPECT_NEAR(here.all.mean_concavity, there.all.mean_concavity, 1e-2);
  EXPECT_NEAR(here.all.free_share, there.all.free_share, 1e-2);
  EXPECT_NEAR(here.hulls[0].free_share, there.hulls[0].free_share, 1e-2);
}

TEST(Tightness, SameForEveryNumberOfThreads)
{
  const MergedRoom room(3);
  const std::vector<ConvexPart> parts = room.cut(10);
  Tightness serial;
  for (const unsigned int threads : {1u, 2u, 3u, 8u}) {
    TightnessOptions options = freeBeyond(0.1);
    options.execution.threads = threads;
    const Tightness tightness =
        TightnessMeter(pointSet(room.points), options).measure(parts);
    if (threads == 1)
      serial = tightness;
    EXPECT_EQ(tightness.volume, serial.volume);
    EXPECT_EQ(tightness.free_volume, serial.free_volume);
    EXPECT_EQ(tightness.all.mean_concavity, serial.all.mean_concavity);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      EXPECT_EQ(tightness.hulls[k].max_concavity, serial.hulls[k].max_concavity);
      EXPECT_EQ(tightness.hulls[k].mean_concavity, serial.hulls[k].mean_concavity);
      EXPECT_EQ(tightness.hulls[k].free_share, serial.hulls[k].free_share);
    }
  }
}

TEST(Tightness, ProgressRisesAndCancels)
{
  const Points points = randomCube(500, 71);
  TightnessOptions options;
  double last = 0.0;
  options.execution.progress = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return true;
  };
  const TightnessMeter meter(pointSet(points), options);
  EXPECT_EQ(last, 1.0);
  last = 0.0;
  meter.measure({partOf(points)});
  EXPECT_EQ(last, 1.0);
  options.execution.progress = [](double) { return false; };
  EXPECT_THROW(TightnessMeter(pointSet(points), options), CIDCancelled);
}

TEST(Tightness, RefusesBadValues)
{
  const PointSet set = pointSet(randomCube(20, 72));
  for (const double distance : {0.0, -1.0, static_cast<double>(NAN)})
    EXPECT_THROW(TightnessMeter(set, freeBeyond(distance)), CIDException);
  TightnessOptions no_hull_samples;
  no_hull_samples.hull_samples = 0;
  EXPECT_THROW(TightnessMeter(set, no_hull_samples), CIDException);
  TightnessOptions no_box_samples;
  no_box_samples.box_samples = 0;
  EXPECT_THROW(TightnessMeter(set, no_box_samples), CIDException);
  EXPECT_THROW(TightnessMeter(pointSet({}), {}), CIDException);
}

} // namespace
} // namespace pcl_cid::test
