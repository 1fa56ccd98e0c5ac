/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The simulated scans: what is seen, how densely, with which noise; the sample scan.
 */

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>

#include <pcl/PCLPointCloud2.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <pcl_cid/exceptions.h>

#include "depth_sensor.h"
#include "even_sampler.h"
#include "primitive_tree.h"
#include "room_oracle.h"
#include "sample_scan.h"

namespace pcl_cid::test {
namespace {

const std::string data_folder = PCL_CID_DATA_DIR;

SensorOptions
smallScan()
{
  SensorOptions options;
  options.seed = 3;
  options.points = 20000;
  return options;
}

SensorOptions
perfectScan()
{
  SensorOptions options = smallScan();
  options.noise = 0.0;
  return options;
}

RoomScene
makeEmptyRoom()
{
  RoomOptions options;
  options.width = options.depth = {10.0, 10.0};
  options.doors = options.windows = options.beams = options.columns = 0;
  options.bookcases = options.boards = options.sofas = 0;
  options.tables = options.chairs = options.clutter = 0;
  return makeRoom(options);
}

bool
sameScan(const LabelledScan& a, const LabelledScan& b)
{
  return a.points == b.points && a.instance == b.instance && a.semantic == b.semantic &&
         a.sensor == b.sensor && a.sensor_positions == b.sensor_positions;
}

double
rangeOf(const LabelledScan& scan, std::size_t point)
{
  return (scan.points[point].cast<double>() - scan.sensor_positions[scan.sensor[point]])
      .norm();
}

std::string
readBytes(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class ScanTest : public testing::Test {
protected:
  RoomScene scene_ = makeRoom({});
};

TEST_F(ScanTest, IsTheSameForTheSameSeedOnly)
{
  SensorOptions other = smallScan();
  other.seed = 4;
  EXPECT_TRUE(sameScan(scanRoom(scene_, smallScan()), scanRoom(scene_, smallScan())));
  EXPECT_FALSE(sameScan(scanRoom(scene_, smallScan()), scanRoom(scene_, other)));
}

TEST_F(ScanTest, HasExactlyThePointsAskedFor)
{
  for (const std::size_t count : {1, 2, 777, 30011}) {
    SensorOptions options = smallScan();
    options.points = count;
    const LabelledScan scan = scanRoom(scene_, options);
    EXPECT_EQ(scan.points.size(), count);
    EXPECT_EQ(scan.instance.size(), count);
    EXPECT_EQ(scan.semantic.size(), count);
    EXPECT_EQ(scan.sensor.size(), count);
    EXPECT_EQ(scan.sensor_positions.size(), options.positions);
  }
}

TEST_F(ScanTest, PointsLieOnTheirOwnInstance)
{
  const LabelledScan scan = scanRoom(scene_, perfectScan());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    ASSERT_LT(
        distanceToInstance(scene_, scan.instance[i], scan.points[i].cast<double>()),
        1e-5);
    ASSERT_EQ(scan.semantic[i],
              static_cast<std::uint8_t>(scene_.class_of_instance[scan.instance[i]]));
  }
}

TEST_F(ScanTest, NothingStandsBetweenSensorAndPoint)
{
  const LabelledScan scan = scanRoom(scene_, perfectScan());
  for (std::size_t i = 0; i < scan.points.size(); i += 20)
    ASSERT_TRUE(isVisible(
        scene_, scan.sensor_positions[scan.sensor[i]], scan.points[i].cast<double>()))
        << "point " << i;
}

TEST_F(ScanTest, SomeSurfacesAreHidden)
{
  const LabelledScan scan = scanRoom(scene_, perfectScan());
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < scan.points.size(); i += 20) {
    const std::size_t other = (scan.sensor[i] + 1u) % scan.sensor_positions.size();
    if (!isVisible(scene_, scan.sensor_positions[other], scan.points[i].cast<double>()))
      ++hidden;
  }
  EXPECT_GT(hidden, scan.points.size() / 20 / 20);
}

TEST_F(ScanTest, NoiseMovesPointsAlongTheirRaysByTheSquareOfTheRange)
{
  const LabelledScan perfect = scanRoom(scene_, perfectScan());
  const LabelledScan noisy = scanRoom(scene_, smallScan());
  ASSERT_EQ(perfect.instance, noisy.instance);
  std::map<int, std::vector<double>> deviations; // by metre of range
  for (std::size_t i = 0; i < perfect.points.size(); ++i) {
    const Eigen::Vector3d eye = perfect.sensor_positions[perfect.sensor[i]];
    const Eigen::Vector3d ray = (perfect.points[i].cast<double>() - eye).normalized();
    const Eigen::Vector3d moved = noisy.points[i].cast<double>() - eye;
    ASSERT_LT((moved - moved.dot(ray) * ray).norm(), 1e-5);
    const double range = rangeOf(perfect, i);
    deviations[static_cast<int>(range)].push_back(moved.dot(ray) - range);
    ASSERT_LE(std::abs(moved.dot(ray) - range), 6 * 0.0015 * range * range + 1e-5);
  }
  double previous_deviation = 0.0;
  for (int metre = 1; metre <= 4; ++metre) {
    const std::vector<double>& bin = deviations[metre];
    ASSERT_GT(bin.size(), 500u);
    double squares = 0.0;
    for (const double deviation : bin)
      squares += deviation * deviation;
    const double deviation = std::sqrt(squares / static_cast<double>(bin.size()));
    EXPECT_GT(deviation, 0.0015 * metre * metre);
    EXPECT_LT(deviation, 0.0015 * (metre + 1) * (metre + 1));
    EXPECT_GT(deviation, previous_deviation);
    previous_deviation = deviation;
  }
}

TEST(Scan, DensityFallsWithTheRange)
{
  SensorOptions options = perfectScan();
  options.positions = 1;
  options.height = {1.5, 1.5};
  options.points = 100000;
  const RoomScene room = makeEmptyRoom();
  const LabelledScan scan = scanRoom(room, options);
  const Eigen::Vector3d eye = scan.sensor_positions.front();
  const auto densityAround = [&](double radius) {
    std::size_t count = 0;
    for (const Eigen::Vector3f& point : scan.points)
      if (point.z() < 1e-4f) {
        const double off =
            std::hypot(point.x() - eye.x(), point.y() - eye.y()) - radius;
        count += std::abs(off) < 0.1 ? 1 : 0;
      }
    return static_cast<double>(count) / (4 * M_PI * 0.1 * radius);
  };
  // cos / r^2 below a sensor at 1.5 m is 3.0 times as much at 0.5 m as at 1.7 m; the
  // images spread their rays to within a factor of 1.4.
  const double ratio = densityAround(0.5) / densityAround(1.7);
  EXPECT_GT(ratio, 3.0 / 1.5);
  EXPECT_LT(ratio, 3.0 * 1.5);
}

TEST_F(ScanTest, KeepsToTheLimitsOfTheSensor)
{
  SensorOptions options = perfectScan();
  options.range = {1.0, 3.0};
  options.max_elevation_sine = 0.2;
  options.height = {1.2, 1.4};
  const LabelledScan scan = scanRoom(scene_, options);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3d& eye = scan.sensor_positions[scan.sensor[i]];
    ASSERT_GE(rangeOf(scan, i), 1.0 - 1e-5);
    ASSERT_LE(rangeOf(scan, i), 3.0 + 1e-5);
    ASSERT_LE((scan.points[i].z() - eye.z()) / rangeOf(scan, i), 0.2 + 1e-5);
    ASSERT_GE(eye.z(), 1.2);
    ASSERT_LE(eye.z(), 1.4);
  }
}

TEST_F(ScanTest, RefusesWhatIsOutOfRange)
{
  const auto refuses = [&](auto change) {
    SensorOptions options = smallScan();
    change(options);
    EXPECT_THROW(scanRoom(scene_, options), CIDException);
  };
  refuses([](SensorOptions& o) { o.points = 0; });
  refuses([](SensorOptions& o) { o.positions = 0; });
  refuses([](SensorOptions& o) { o.positions = 256; });
  refuses([](SensorOptions& o) { o.noise = -0.001; });
  refuses([](SensorOptions& o) { o.noise = std::numeric_limits<double>::quiet_NaN(); });
  refuses([](SensorOptions& o) { o.range = {100.0, 200.0}; });
  refuses([](SensorOptions& o) { o.height = {50.0, 60.0}; });
}

TEST_F(ScanTest, EvenSamplingIsExactAndRepeatable)
{
  const LabelledScan scan = sampleRoomEvenly(scene_, 5000, 1);
  EXPECT_EQ(scan.points.size(), 5000u);
  EXPECT_TRUE(sameScan(scan, sampleRoomEvenly(scene_, 5000, 1)));
  EXPECT_FALSE(sameScan(scan, sampleRoomEvenly(scene_, 5000, 2)));
  EXPECT_TRUE(sampleRoomEvenly(scene_, 0, 1).points.empty());
}

TEST_F(ScanTest, EvenSamplingLiesOnItsInstanceInFreeAir)
{
  const LabelledScan scan = sampleRoomEvenly(scene_, 5000, 1);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3d point = scan.points[i].cast<double>();
    ASSERT_LT(distanceToInstance(scene_, scan.instance[i], point), 1e-5);
    for (const Primitive& primitive : scene_.primitives)
      ASSERT_GT(signedDistance(primitive, point), -1e-5);
  }
}

TEST_F(ScanTest, EvenSamplingIsProportionalToExposedArea)
{
  const PrimitiveTree tree(scene_.primitives);
  std::vector<double> area(scene_.class_of_instance.size(), 0.0);
  double whole_area = 0.0;
  for (std::size_t self = 0; self < scene_.primitives.size(); ++self)
    for (const SurfacePoint& point : surfaceGrid(scene_.primitives[self], 0.01)) {
      if (tree.isCovered(point.position, self))
        continue;
      area[scene_.primitives[self].instance] += point.area;
      whole_area += point.area;
    }
  constexpr double count = 200000;
  const LabelledScan scan =
      sampleRoomEvenly(scene_, static_cast<std::size_t>(count), 1);
  std::vector<double> found(area.size(), 0.0);
  for (const std::uint32_t instance : scan.instance)
    ++found[instance];
  for (std::size_t i = 1; i < area.size(); ++i) {
    const double expected = count * area[i] / whole_area;
    ASSERT_GT(expected, 1.0);
    // five standard deviations and 2 % for the grid's own error at edges
    EXPECT_NEAR(found[i], expected, 5 * std::sqrt(expected) + 0.02 * expected)
        << "instance " << i;
  }
}

TEST(EvenSampling, GivesRectanglesBoxesAndCylindersTheirArea)
{
  RoomScene scene;
  scene.primitives = {makeBox(0.0, 1.0, 0.0, 2.0, 0.0, 0.0),
                      makeBox(2.0, 2.5, 0.0, 1.0, 0.0, 2.0),
                      makeCylinder(4.0, 0.0, 0.4, 0.0, 1.5)};
  scene.class_of_instance.assign(4, RoomClass::clutter);
  for (std::uint32_t i = 0; i < 3; ++i)
    scene.primitives[i].instance = i + 1;
  const std::vector<double> area{
      0.0, 2.0, 2 * (0.5 + 1.0 + 2.0), 2 * M_PI * 0.4 * (0.4 + 1.5)};
  const double whole_area = area[1] + area[2] + area[3];

  constexpr double count = 100000;
  const LabelledScan scan = sampleRoomEvenly(scene, static_cast<std::size_t>(count), 1);
  std::vector<double> found(area.size(), 0.0);
  double on_top = 0.0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    ++found[scan.instance[i]];
    on_top += scan.instance[i] == 3 && scan.points[i].z() > 1.4999f ? 1.0 : 0.0;
  }
  for (std::size_t i = 1; i < area.size(); ++i) {
    const double expected = count * area[i] / whole_area;
    EXPECT_NEAR(found[i], expected, 5 * std::sqrt(expected)) << "instance " << i;
  }
  const double expected_on_top = count * M_PI * 0.4 * 0.4 / whole_area;
  EXPECT_NEAR(on_top, expected_on_top, 5 * std::sqrt(expected_on_top));
}

TEST(SampleScan, IsMadeAgainByteForByte)
{
  const std::string folder = testing::TempDir() + "pcl_cid_sample_scan";
  std::filesystem::create_directories(folder);
  writeSampleScan(folder);
  for (const std::string name : {"/room.pcd", "/room_truth.json"})
    EXPECT_TRUE(readBytes(folder + name) == readBytes(data_folder + name)) << name;
  std::filesystem::remove_all(folder);
}

TEST(SampleScan, IsReadByPclAndFitsItsTruth)
{
  const std::string path = data_folder + "/room.pcd";
  EXPECT_LT(std::filesystem::file_size(path), 2000000u);
  pcl::PCLPointCloud2 file;
  ASSERT_EQ(pcl::PCDReader().read(path, file), 0);
  ASSERT_EQ(file.fields.size(), 5u);
  EXPECT_EQ(file.fields[4].name, "semantic");
  EXPECT_EQ(file.fields[4].datatype, pcl::PCLPointField::UINT32);
  pcl::PointCloud<pcl::PointXYZL> cloud;
  pcl::fromPCLPointCloud2(file, cloud);
  const auto truth = nlohmann::json::parse(readBytes(data_folder + "/room_truth.json"));
  EXPECT_EQ(cloud.size(), truth["sensor_options"]["points"].get<std::size_t>());

  std::map<std::uint32_t, std::size_t> sizes;
  std::map<std::uint32_t, std::uint32_t> classes;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ++sizes[cloud[i].label];
    std::uint32_t semantic = 0;
    std::memcpy(&semantic,
                &file.data[i * file.point_step + file.fields[4].offset],
                sizeof(semantic));
    const auto known = classes.emplace(cloud[i].label, semantic).first;
    ASSERT_EQ(known->second, semantic);
  }
  EXPECT_EQ(sizes.size(), truth["instances"].size());
  for (const auto& instance : truth["instances"]) {
    const auto label = instance["label"].get<std::uint32_t>();
    EXPECT_EQ(sizes[label], instance["points"].get<std::size_t>());
    EXPECT_EQ(classes[label], instance["semantic"].get<std::uint32_t>());
    EXPECT_EQ(instance["class"], truth["class_names"][classes[label]]);
  }
}

TEST(SampleScan, NeedsAFolder)
{
  EXPECT_THROW(writeSampleScan(testing::TempDir() + "no/such/folder"), CIDException);
}

} // namespace
} // namespace pcl_cid::test
