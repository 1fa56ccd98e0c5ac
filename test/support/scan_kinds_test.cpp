/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The kinds of scans: where their points lie, how they are spaced, what errors do.
 */

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include <pcl_cid/exceptions.h>

#include "colored_room.h"
#include "room_oracle.h"
#include "scan_cloud.h"
#include "scan_kinds.h"
#include "scan_paint.h"

namespace pcl_cid::test {
namespace {

constexpr std::array<ScanKind, 6> all_kinds{ScanKind::even,
                                            ScanKind::sensor,
                                            ScanKind::merged,
                                            ScanKind::mesh_vertices,
                                            ScanKind::single_view,
                                            ScanKind::lidar};

const ColoredRoom&
theRoom()
{
  static const ColoredRoom room = makeColoredRoom(4);
  return room;
}

LabelledScan
wholeScan(ScanKind kind, std::size_t count, std::uint64_t seed)
{
  LabelledScan scan = choosePoints(theRoom().scene, kind, count, seed);
  paintScan(theRoom(), scan);
  disturb(scan, usualErrors(kind), seed);
  return scan;
}

/// Of every hundredth of \a places, the distance to the eighth neighbor, which varies
/// little where places are drawn evenly; sorted.
std::vector<double>
spacingsOf(const std::vector<Eigen::Vector3f>& places)
{
  std::vector<double> spacings;
  for (std::size_t i = 0; i < places.size(); i += 100) {
    std::vector<float> squared;
    for (const Eigen::Vector3f& other : places)
      squared.push_back((other - places[i]).squaredNorm());
    std::nth_element(squared.begin(), squared.begin() + 8, squared.end());
    spacings.push_back(std::sqrt(squared[8]));
  }
  std::sort(spacings.begin(), spacings.end());
  return spacings;
}

/// How many times the wide spacings are the narrow ones.
double
spreadOf(const std::vector<double>& sorted)
{
  return sorted[sorted.size() * 9 / 10] / sorted[sorted.size() / 10];
}

TEST(ScanKinds, PointsLieOnTheirOwnPrimitiveWithTheNearestLabel)
{
  for (const ScanKind kind : all_kinds) {
    const LabelledScan scan = choosePoints(theRoom().scene, kind, 1500, 3);
    ASSERT_EQ(scan.points.size(), 1500u);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const Eigen::Vector3d point = scan.points[i].cast<double>();
      double nearest = 1e9;
      for (const Primitive& primitive : theRoom().scene.primitives)
        nearest = std::min(nearest, std::abs(signedDistance(primitive, point)));
      const Primitive& own = theRoom().scene.primitives[scan.primitive[i]];
      ASSERT_LT(std::abs(signedDistance(own, point)), nearest + 2e-6);
      ASSERT_LT(nearest, 2e-6);
      ASSERT_EQ(scan.instance[i], own.instance);
      ASSERT_EQ(
          scan.semantic[i],
          static_cast<std::uint8_t>(theRoom().scene.class_of_instance[own.instance]));
    }
  }
}

TEST(ScanKinds, AreTheSameForTheSameSeedOnly)
{
  for (const ScanKind kind : all_kinds) {
    const pcl::PCLPointCloud2 cloud = cloudOf(wholeScan(kind, 1000, 5));
    EXPECT_EQ(cloud.data, cloudOf(wholeScan(kind, 1000, 5)).data);
    EXPECT_NE(cloud.data, cloudOf(wholeScan(kind, 1000, 6)).data);
  }
}

TEST(ScanKinds, ColorsAreAFieldAsOfPcl)
{
  const LabelledScan scan = wholeScan(ScanKind::even, 100, 1);
  const pcl::PCLPointCloud2 cloud = cloudOf(scan);
  ASSERT_EQ(cloud.fields.back().name, "rgb");
  ASSERT_EQ(cloud.fields.back().datatype, pcl::PCLPointField::FLOAT32);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    std::uint32_t packed = 0;
    std::memcpy(&packed,
                &cloud.data[i * cloud.point_step + cloud.fields.back().offset],
                sizeof(packed));
    const ColorRGB color = unpackColor(packed);
    EXPECT_EQ(color.r, scan.colors[i].r);
    EXPECT_EQ(color.g, scan.colors[i].g);
    EXPECT_EQ(color.b, scan.colors[i].b);
  }
}

TEST(ScanKinds, MeshVerticesAreIrregularButCoverFlatAreas)
{
  constexpr std::size_t count = 40000;
  const RoomScene& scene = theRoom().scene;
  const LabelledScan mesh = choosePoints(scene, ScanKind::mesh_vertices, count, 2);
  const LabelledScan even = choosePoints(scene, ScanKind::even, count, 2);
  EXPECT_GT(spreadOf(spacingsOf(mesh.points)), 1.5 * spreadOf(spacingsOf(even.points)));
  for (std::size_t i = 0; i < count; i += 50) { // nowhere is there no vertex
    float nearest = std::numeric_limits<float>::infinity();
    for (const Eigen::Vector3f& vertex : mesh.points)
      nearest = std::min(nearest, (vertex - even.points[i]).squaredNorm());
    EXPECT_LT(std::sqrt(nearest), 0.25f);
  }
}

TEST(ScanKinds, MeshVerticesDoNotDependOnRange)
{
  // Of the floor, away from what stands on it, all places are alike.
  RoomOptions options;
  options.width = options.depth = {6.0, 6.0};
  options.doors = options.windows = options.beams = options.columns = 0;
  options.bookcases = options.boards = options.sofas = 0;
  options.tables = options.chairs = options.clutter = 0;
  const RoomScene empty = makeRoom(options);
  const LabelledScan mesh = choosePoints(empty, ScanKind::mesh_vertices, 6000, 2);
  std::array<int, 4> quarters{};
  int at_wall = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Eigen::Vector3f& p = mesh.points[i];
    if (p.z() != 0.0f)
      continue;
    const float from_wall = std::min({p.x(), p.y(), 6.0f - p.x(), 6.0f - p.y()});
    if (from_wall < 0.05f)
      ++at_wall;
    if (from_wall > 0.2f)
      ++quarters[(p.x() > 3.0f ? 1u : 0u) + (p.y() > 3.0f ? 2u : 0u)];
  }
  const auto [least, most] = std::minmax_element(quarters.begin(), quarters.end());
  EXPECT_GT(*least, 0.8 * *most);
  const double wall_density = at_wall / (4 * 0.05 * 5.95);
  const double inner_density =
      (quarters[0] + quarters[1] + quarters[2] + quarters[3]) / (5.6 * 5.6);
  EXPECT_GT(wall_density, 5.0 * inner_density);
}

TEST(ScanKinds, MergedScansDifferInDensityPlaceAndExposure)
{
  LabelledScan scan = choosePoints(theRoom().scene, ScanKind::merged, 9000, 2);
  ASSERT_GE(scan.sensor_positions.size(), 3u);
  std::vector<int> counts(scan.sensor_positions.size());
  for (const std::uint8_t sensor : scan.sensor)
    ++counts[sensor];
  const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
  EXPECT_GT(*most, *least);

  paintScan(theRoom(), scan);
  const LabelledScan clean = scan;
  disturb(scan, {0.0, 0.0, 0.005, 0.0, 0.12}, 1);
  std::vector<Eigen::Vector3d> shifts;
  for (std::size_t sensor = 0; sensor < counts.size(); ++sensor) {
    const Eigen::Vector3d shift =
        scan.sensor_positions[sensor] - clean.sensor_positions[sensor];
    EXPECT_GT(shift.norm(), 0.0);
    EXPECT_LT(shift.norm(), 0.005 * 6 * 2);
    shifts.push_back(shift);
  }
  EXPECT_NE(shifts[0], shifts[1]);
  double brightest = 0.0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3d ray =
        clean.points[i].cast<double>() - clean.sensor_positions[scan.sensor[i]];
    const Eigen::Vector3d turned =
        scan.points[i].cast<double>() - scan.sensor_positions[scan.sensor[i]];
    ASSERT_NEAR(turned.norm(), ray.norm(), 1e-5); // as a rigid motion leaves it
    ASSERT_NEAR(turned.z(), ray.z(), 1e-5);
    if (clean.colors[i].g > 100)
      brightest = std::max(brightest,
                           std::abs(1.0 * scan.colors[i].g / clean.colors[i].g - 1.0));
  }
  EXPECT_GT(brightest, 0.02);
  EXPECT_LT(brightest, 0.20);
}

TEST(ScanKinds, NoiseOfPointsAndColorsIsAsLargeAsSaid)
{
  LabelledScan scan = choosePoints(theRoom().scene, ScanKind::even, 20000, 2);
  paintScan(theRoom(), scan);
  const LabelledScan clean = scan;
  disturb(scan, {0.01, 0.0, 0.0, 5.0, 0.0}, 1);
  double moved_by = 0.0;
  double colored_by = 0.0;
  std::size_t inner = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    moved_by += (scan.points[i] - clean.points[i]).squaredNorm() / 3.0;
    if (clean.colors[i].r < 40 || clean.colors[i].r > 215)
      continue; // where noise may be cut off
    ++inner;
    colored_by += std::pow(1.0 * scan.colors[i].r - clean.colors[i].r, 2);
  }
  EXPECT_NEAR(
      std::sqrt(moved_by / static_cast<double>(scan.points.size())), 0.01, 3e-4);
  EXPECT_NEAR(std::sqrt(colored_by / static_cast<double>(inner)), 5.0, 0.2);
}

TEST(ScanKinds, SingleViewsAndLidarsSeeFromOnePlace)
{
  for (const ScanKind kind : {ScanKind::single_view, ScanKind::lidar}) {
    const LabelledScan scan = choosePoints(theRoom().scene, kind, 800, 1);
    ASSERT_EQ(scan.sensor_positions.size(), 1u);
    const Eigen::Vector3d& eye = scan.sensor_positions.front();
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3f& point : scan.points) {
      const Eigen::Vector3d ray = point.cast<double>() - eye;
      EXPECT_GT(ray.normalized().z(), -0.80);
      EXPECT_TRUE(
          isVisible(theRoom().scene, eye, eye + ray * (1.0 - 1e-3 / ray.norm())));
      middle += ray.normalized() / static_cast<double>(scan.points.size());
    }
    if (kind == ScanKind::single_view)
      EXPECT_GT(middle.norm(), 0.8); // all rays look one way
    else
      EXPECT_LT(middle.norm(), 0.5);
  }
}

TEST(ScanKinds, RefuseAScanOfNoPoints)
{
  for (const ScanKind kind : all_kinds)
    EXPECT_THROW(choosePoints(theRoom().scene, kind, 0, 1), CIDException);
}

} // namespace
} // namespace pcl_cid::test
