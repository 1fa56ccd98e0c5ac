/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What every hull guarantees, on clouds of all kinds.
 */

#include "even_sampler.h"
#include "hulls.h"
#include "room_scene.h"

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/hull_guarantees.h>
#include <pcl_cid/exceptions.h>

#include <cmath>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace pcl_cid::test {
namespace {

ConvexPartOptions
atLeast(double min_thickness)
{
  ConvexPartOptions options;
  options.min_thickness = min_thickness;
  return options;
}

/** Everything at once, and each alone. */
std::vector<ConvexPartOptions>
variants(double min_thickness)
{
  std::vector<ConvexPartOptions> variants(4, atLeast(min_thickness));
  variants[1].max_vertices = 12;
  variants[2].padding = 3.0 * min_thickness;
  variants[3].max_vertices = 7;
  variants[3].padding = 0.5 * min_thickness;
  return variants;
}

void
expectGuaranteesOfParts(const Points& points,
                        const std::vector<int>& part,
                        double min_thickness,
                        const std::string& what)
{
  for (const ConvexPartOptions& options : variants(min_thickness))
    for (const ConvexPart& hull : makeConvexParts(pointSet(points), part, options, {}))
      expectGuarantees(hull, points, options, what);
}

class HullOfClouds : public testing::TestWithParam<NamedPoints> {};

TEST_P(HullOfClouds, HoldsItsGuarantees)
{
  for (const double thickness : {0.005, 0.05})
    for (const ConvexPartOptions& options : variants(thickness)) {
      const ConvexPart part = partOf(GetParam().points, options);
      expectGuarantees(part, GetParam().points, options, GetParam().name);
      EXPECT_EQ(part.indices.size(), GetParam().points.size());
      EXPECT_TRUE(part.trimmed.empty());
    }
}

TEST_P(HullOfClouds, SameAtUtmCoordinates)
{
  // Coordinates on a quarter-metre grid survive the shift, so the hull must, too.
  Points near = GetParam().points;
  for (Eigen::Vector3f& p : near)
    p = (4.0f * p).array().round() / 4.0f;
  Points far = near;
  const Eigen::Vector3f shift(524288.0f, 1048576.0f, 1024.0f);
  for (Eigen::Vector3f& p : far)
    p += shift;
  const ConvexPart here = partOf(near);
  const ConvexPart there = partOf(far);
  EXPECT_NEAR(here.volume, there.volume, 1e-6 * here.volume);
  ASSERT_EQ(here.hull.vertices.size(), there.hull.vertices.size());
}

INSTANTIATE_TEST_SUITE_P(Clouds,
                         HullOfClouds,
                         testing::ValuesIn(allClouds()),
                         [](const auto& info) { return info.param.name; });

TEST(ConvexPart, UnitCube)
{
  Points corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? 1.0f : 0.0f, i & 2 ? 1.0f : 0.0f, i & 4 ? 1.0f : 0.0f);
  const ConvexPart part = partOf(corners);
  EXPECT_NEAR(part.volume, 1.0, 1e-6);
  EXPECT_NEAR(part.area, 6.0, 1e-6);
  EXPECT_NEAR(part.thickness, 1.0, 1e-6);
  EXPECT_FALSE(part.thickened);
}

TEST(ConvexPart, AFlatSquareBecomesASlab)
{
  const ConvexPart part =
      partOf({{0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {1, 1, 2}}, atLeast(0.01));
  EXPECT_TRUE(part.thickened);
  EXPECT_NEAR(part.volume, 0.01, 1e-6);
  EXPECT_NEAR(part.thickness, 0.01, 1e-6);
  double lowest = 9.0, highest = -9.0; // symmetric about the points
  for (const Eigen::Vector3d& v : part.hull.vertices) {
    lowest = std::min(lowest, v.z());
    highest = std::max(highest, v.z());
  }
  EXPECT_NEAR(0.5 * (lowest + highest), 2.0, 1e-6);
}

TEST(ConvexPart, ASinglePointBecomesACube)
{
  const ConvexPart part = partOf({{1, 2, 3}}, atLeast(0.02));
  EXPECT_TRUE(part.thickened);
  EXPECT_NEAR(part.volume, 8e-6, 1e-9);
}

/** Edges of length 1; the opposite ones are nearer to each other than a face to its
 *  corner. */
Points
regularTetrahedron()
{
  const float h = std::sqrt(0.125f);
  return {{h, h, h}, {h, -h, -h}, {-h, h, -h}, {-h, -h, h}};
}

TEST(ConvexPart, ThicknessIsTheLeastOfAllDirectionsNotOnlyOfFaceNormals)
{
  const ConvexPart part = partOf(regularTetrahedron());
  EXPECT_NEAR(part.thickness, std::sqrt(0.5), 1e-6);
  EXPECT_FALSE(part.thickened);
  const double between_edges_and_faces = 0.75;
  const ConvexPart thick =
      partOf(regularTetrahedron(), atLeast(between_edges_and_faces));
  EXPECT_TRUE(thick.thickened);
  EXPECT_NEAR(thick.thickness, between_edges_and_faces, 1e-5);
}

TEST(ConvexPart, ThicknessIsThatOfTheCheckToo)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Points points = randomSmallCloud(seed);
    const ConvexPart part = partOf(points);
    EXPECT_FALSE(findBrokenGuarantee(part.hull, {}, atLeast(0.9999 * part.thickness)));
    const auto broken =
        findBrokenGuarantee(part.hull, {}, atLeast(1.0001 * part.thickness));
    ASSERT_TRUE(broken) << seed;
    EXPECT_NE(broken->find("too thin"), std::string::npos) << *broken;
  }
}

TEST(ConvexPart, NoDirectionIsThinner)
{
  const Points directions = randomCube(2000, 53);
  for (const NamedPoints& cloud : allClouds()) {
    const ConvexPart part = partOf(cloud.points);
    for (const Eigen::Vector3f& d : directions) {
      const Eigen::Vector3d direction =
          (d.cast<double>() - Eigen::Vector3d::Constant(0.5)).normalized();
      Eigen::AlignedBox<double, 1> shadow;
      for (const Eigen::Vector3d& v : part.hull.vertices)
        shadow.extend(Eigen::Matrix<double, 1, 1>(direction.dot(v)));
      EXPECT_GE(shadow.sizes()[0], part.thickness * (1.0 - 1e-9)) << cloud.name;
    }
  }
}

TEST(ConvexPart, SaysNothingOnStderr)
{
  testing::internal::CaptureStderr();
  for (const NamedPoints& cloud : allClouds())
    for (const ConvexPartOptions& options : variants(0.005))
      partOf(cloud.points, options);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ConvexPart, ATiltedPlaneWithFloatNoiseBecomesASlab)
{
  Points points;
  const Eigen::AngleAxisf tilt(0.7f, Eigen::Vector3f(0.3f, -0.5f, 0.8f).normalized());
  for (const Eigen::Vector3f& p : randomCube(5000, 54))
    points.push_back(tilt * Eigen::Vector3f(3.0f * p.x(), 2.0f * p.y(), 1.0f));
  const ConvexPart part = partOf(points, atLeast(0.01));
  EXPECT_TRUE(part.thickened);
  EXPECT_NEAR(part.volume, 3.0 * 2.0 * 0.01, 0.002);
  expectGuarantees(part, points, atLeast(0.01), "tilted plane");
}

TEST(ConvexPart, RandomSmallCloudsHoldTheirGuarantees)
{
  testing::internal::CaptureStderr();
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Points points = randomSmallCloud(seed);
    for (const ConvexPartOptions& options : variants(0.005))
      expectGuarantees(
          partOf(points, options), points, options, "cloud " + std::to_string(seed));
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ConvexPart, PartsOfGeneratedRoomsHoldTheirGuarantees)
{
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    RoomOptions room;
    room.seed = seed;
    const Points points = sampleRoomEvenly(makeRoom(room), 10000, seed).points;
    expectGuaranteesOfParts(
        points, groupsOf(points, 30), 0.005, "room " + std::to_string(seed));
  }
}

class HullsOfScan : public testing::TestWithParam<std::string> {};

TEST_P(HullsOfScan, HoldTheirGuarantees)
{
  const auto scan = loadSharedScan(GetParam() + ".pcd");
  if (!scan)
    GTEST_SKIP() << "../shared/data/" << GetParam() << ".pcd is absent";
  const Points points = crop(*scan, 10000, scan->size() / 20000);
  const bool in_millimetres = GetParam() == "region_growing_tutorial";
  // The origin is taken out first, as it is for any cloud.
  const Points local = pointSet(points).points;
  expectGuaranteesOfParts(
      points, groupsOf(local, 30), in_millimetres ? 5.0 : 0.005, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Scans,
                         HullsOfScan,
                         testing::Values("milk_cartoon_all_small_clorox",
                                         "mosd_learn13",
                                         "mosd_learn24",
                                         "mosd_learn4",
                                         "mosd_learn41",
                                         "office1",
                                         "region_growing_tutorial",
                                         "room_scan1",
                                         "table_scene_mug_stereo_textured",
                                         "terrain_csite3_utm"),
                         [](const auto& info) { return info.param; });

TEST(ConvexParts, EveryPointOnceAndTheSameForEveryNumberOfThreads)
{
  const Points points = twoBoxes(500, 51);
  const PointSet set = pointSet(points);
  std::vector<int> part(points.size());
  for (std::size_t i = 0; i < part.size(); ++i)
    part[i] = i % 10 == 9 ? -1 : static_cast<int>(i % 2);
  ExecutionOptions execution;
  execution.threads = 1;
  const auto serial = makeConvexParts(set, part, {}, execution);
  ASSERT_EQ(serial.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k)
    for (const pcl::index_t index : serial[k].indices)
      EXPECT_EQ(part[static_cast<std::size_t>(index)], static_cast<int>(k));
  for (const unsigned int threads : {2u, 3u, 8u}) {
    execution.threads = threads;
    const auto parallel = makeConvexParts(set, part, {}, execution);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(parallel[k].hull.vertices, serial[k].hull.vertices);
      EXPECT_EQ(parallel[k].hull.triangles, serial[k].hull.triangles);
    }
  }
}

TEST(ConvexPart, RefusesBadValues)
{
  const PointSet set = pointSet(randomCube(10, 52));
  EXPECT_THROW(makeConvexPart(set, {}, {}), CIDException);
  const double infinity = INFINITY;
  const double nan = NAN;
  for (const double thickness : {0.0, -1.0, nan, infinity})
    EXPECT_THROW(makeConvexPart(set, {0, 1, 2, 3}, atLeast(thickness)), CIDException);
  for (const double distance : {-0.1, nan, infinity}) {
    ConvexPartOptions padding;
    padding.padding = distance;
    EXPECT_THROW(makeConvexPart(set, {0, 1, 2, 3}, padding), CIDException);
    ConvexPartOptions trim;
    trim.trim_distance = distance;
    EXPECT_THROW(makeConvexPart(set, {0, 1, 2, 3}, trim), CIDException);
  }
  for (const std::size_t vertices : {1u, 2u, 3u}) {
    ConvexPartOptions options;
    options.max_vertices = vertices;
    EXPECT_THROW(makeConvexPart(set, {0, 1, 2, 3}, options), CIDException);
  }
}

} // namespace
} // namespace pcl_cid::test
