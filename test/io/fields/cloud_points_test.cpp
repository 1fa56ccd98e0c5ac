/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Coordinates of clouds.
 */

#include "base/random.h"
#include "cloud_files.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

TEST(FinitePoints, KeepTheirIndices)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.emplace_back(1.0f, 2.0f, 3.0f);
  cloud.emplace_back(std::nanf(""), 0.0f, 0.0f);
  cloud.emplace_back(4.0f, 5.0f, 6.0f);
  const PointSet points = finitePoints(cloud);
  EXPECT_EQ(points.source, (pcl::Indices{0, 2}));
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ((points.frame.toFile(points.points[1].cast<double>())),
            Eigen::Vector3d(4, 5, 6));
}

TEST(PointsOf, MovesDoubleCoordinatesToALocalFrame)
{
  const std::vector<double> x{500000.001, 500000.002, 500001.5, std::nan("")};
  const std::vector<double> y{4100000.25, 4100000.251, 4100002.0, 0.0};
  const std::vector<double> z{120.0, 120.001, 121.0, 0.0};
  LabelledCloud cloud;
  appendField("x", x, cloud.fields);
  appendField("y", y, cloud.fields);
  appendField("z", z, cloud.fields);
  const CloudPoints points = pointsOf(cloud);
  EXPECT_EQ(points.finite, 3u);
  EXPECT_FALSE(points.points->is_dense);
  for (std::size_t i = 0; i < points.finite; ++i) {
    const Eigen::Vector3d back =
        points.frame.toFile((*points.points)[i].getVector3fMap().cast<double>());
    EXPECT_NEAR(back.x(), x[i], 1e-6);
    EXPECT_NEAR(back.y(), y[i], 1e-6);
    EXPECT_NEAR(back.z(), z[i], 1e-6);
  }
}

TEST(PointsOf, LeavesFloatAndSmallCoordinatesAlone)
{
  EXPECT_TRUE(pointsOf(deskScan()).frame.origin.isZero(0.0));
  LabelledCloud cloud;
  appendField<double>("x", {-1, 2}, cloud.fields);
  appendField<double>("y", {0, 3}, cloud.fields);
  appendField<double>("z", {1, 1}, cloud.fields);
  EXPECT_TRUE(pointsOf(cloud).frame.origin.isZero(0.0));
}

/// Random points in a cube of 2 m at UTM coordinates.
std::vector<Eigen::Vector3d>
atUTM(std::size_t count)
{
  RandomGenerator generator(7);
  std::vector<Eigen::Vector3d> points;
  const auto draw = [&] {
    return static_cast<double>(drawBelow(generator, 2000000)) * 1e-6;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const double x = draw();
    const double y = draw();
    points.emplace_back(691234.5 + x, 5334001.25 + y, 512.0 + draw());
  }
  return points;
}

template <typename Value = double>
LabelledCloud
cloudOf(const std::vector<Eigen::Vector3d>& points)
{
  LabelledCloud cloud;
  cloud.name = "cloud";
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Value> values;
    for (const Eigen::Vector3d& p : points)
      values.push_back(static_cast<Value>(p[axis]));
    appendField(std::string(1, "xyz"[axis]), values, cloud.fields);
  }
  return cloud;
}

TEST(PointsOf, KeepsMillimetersWhereSinglePointsLieAstray)
{
  for (const Eigen::Vector3d& stray : {Eigen::Vector3d(0, 0, 0),
                                       Eigen::Vector3d(691234.5, 5334001.25, -9e9),
                                       Eigen::Vector3d(-1e14, 1e12, 3)}) {
    std::vector<Eigen::Vector3d> points = atUTM(100);
    const Frame without = pointsOf(cloudOf(points)).frame;
    points.insert(points.begin() + 17, stray);
    const CloudPoints local = pointsOf(cloudOf(points));
    EXPECT_EQ(local.frame.origin, without.origin);
    EXPECT_EQ(local.finite, points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d back =
          local.frame.toFile((*local.points)[i].getVector3fMap().cast<double>());
      EXPECT_LT((back - points[i]).norm(), points[i] == stray ? 1e10 : 1e-6);
    }
  }
}

std::vector<std::string>
remarksOn(const LabelledCloud& cloud, bool keep_zeros = false)
{
  std::vector<std::string> remarks;
  PointOptions options;
  options.keep_zeros = keep_zeros;
  options.remark = [&](const std::string& text) { remarks.push_back(text); };
  pointsOf(cloud, options);
  return remarks;
}

TEST(PointsOf, SaysWhenTheStepOfCoordinatesIsCoarse)
{
  const std::vector<std::string> remarks = remarksOn(cloudOf<float>(atUTM(100)));
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_NE(remarks[0].find("in steps of 0.5 m"), std::string::npos) << remarks[0];
  EXPECT_TRUE(remarksOn(cloudOf(atUTM(100))).empty());
  EXPECT_TRUE(remarksOn(deskScan()).empty());
}

/// A wall, and what did not return, at a place.
LabelledCloud
withNoReturns(std::size_t count, const Eigen::Vector3d& place)
{
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < 100; ++i)
    points.emplace_back(
        0.1 * static_cast<double>(i % 10), 2, 0.1 * static_cast<double>(i / 10));
  points.insert(points.begin() + 50, count, place);
  return cloudOf<float>(points);
}

TEST(PointsOf, LeavesOutWhatDidNotReturn)
{
  const Eigen::Vector3d sensor(0.25, -1, 1.5);
  for (const Eigen::Vector3d& place : {Eigen::Vector3d(0, 0, 0), sensor}) {
    LabelledCloud cloud = withNoReturns(10, place);
    cloud.sensor_origin.head<3>() = sensor.cast<float>();
    const CloudPoints points = pointsOf(cloud);
    EXPECT_EQ(points.finite, 100u);
    EXPECT_FALSE(points.points->is_dense);
    for (std::size_t i = 0; i < 110; ++i)
      EXPECT_EQ((*points.points)[i].getVector3fMap().allFinite(), i < 50 || i >= 60);
    ASSERT_EQ(remarksOn(cloud).size(), 1u);
    EXPECT_EQ(remarksOn(cloud)[0].rfind("cloud: 10 points lie exactly at", 0), 0u);
    PointOptions keep;
    keep.keep_zeros = true;
    EXPECT_EQ(pointsOf(cloud, keep).finite, 110u);
    EXPECT_TRUE(remarksOn(cloud, true).empty());
  }
}

TEST(PointsOf, KeepsFewPointsAtTheOriginAndCloudsOfNothingElse)
{
  EXPECT_EQ(pointsOf(withNoReturns(9, Eigen::Vector3d::Zero())).finite, 109u);
  EXPECT_EQ(pointsOf(withNoReturns(20, Eigen::Vector3d(1, 0, 0))).finite, 120u);
  EXPECT_EQ(pointsOf(cloudOf(std::vector<Eigen::Vector3d>(20, {0, 0, 0}))).finite, 20u);
}

TEST(PointsOf, RefusesCoordinatesBeyondItsLimit)
{
  for (const double value : {1e30, -1.1e15, 1e308}) {
    std::vector<Eigen::Vector3d> points = atUTM(5);
    points[3].y() = value;
    try {
      pointsOf(cloudOf(points));
      FAIL() << value << " was taken";
    }
    catch (const CIDException& error) {
      EXPECT_EQ(std::string(error.what()).rfind("cloud: the y of point 3 is ", 0), 0u)
          << error.what();
    }
  }
  std::vector<Eigen::Vector3d> points = atUTM(5);
  points[3].y() = 1e15;
  points[4].x() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(pointsOf(cloudOf(points)).finite, 4u);
}

TEST(PointsOf, CountsFinitePoints)
{
  const CloudPoints points = pointsOf(deskScan());
  std::size_t labelled = 0;
  for (const std::uint32_t label : deskLabels())
    labelled += label != 0 ? 1 : 0;
  EXPECT_EQ(points.finite, labelled);
  EXPECT_EQ(points.points->width, 40u);
  EXPECT_EQ(points.points->height, 30u);
}

TEST(ConvertToMetres, GivesTheSamePointsWhateverTheType)
{
  const LabelledCloud desk = deskScan();
  LabelledCloud cloud = desk;
  cloud.scale = 0.001;
  const CloudPoints before = pointsOf(cloud);
  EXPECT_EQ(before.metres_per_unit, 0.001);
  convertToMetres(cloud);
  const CloudPoints after = pointsOf(cloud);
  EXPECT_EQ(after.metres_per_unit, 1.0);
  EXPECT_EQ(bytesOf(toLabelledCloud(*after.points).fields, "z"),
            bytesOf(toLabelledCloud(*before.points).fields, "z"));
  EXPECT_TRUE(cloud.sensor_origin.isApprox(0.001f * desk.sensor_origin));
  EXPECT_EQ(cloud.fields.point_step, desk.fields.point_step);

  LabelledCloud whole;
  appendField<std::uint16_t>("ring", {7, 8}, whole.fields);
  for (const char* const axis : {"x", "y", "z"})
    appendField<std::int32_t>(axis, {-1, 1234567891}, whole.fields);
  whole.scale = 0.001;
  convertToMetres(whole);
  EXPECT_EQ(valuesOf<double>(whole.fields, "y"), (std::vector{-0.001, 1234567.891}));
  EXPECT_EQ(valuesOf<std::uint16_t>(whole.fields, "ring"),
            (std::vector<std::uint16_t>{7, 8}));
}

TEST(ToLabelledCloud, IsTheWayBack)
{
  const CloudPoints points = pointsOf(deskScan());
  LabelledCloud cloud = toLabelledCloud(*points.points);
  for (const char* const name : {"x", "y", "z"})
    EXPECT_EQ(bytesOf(cloud.fields, name), bytesOf(deskScan().fields, name));
  EXPECT_EQ(cloud.fields.fields.size(), 3u);
  EXPECT_EQ(cloud.fields.width, 40u);
  EXPECT_EQ(cloud.fields.height, 30u);
  EXPECT_EQ(cloud.sensor_origin, deskScan().sensor_origin);
}

} // namespace
} // namespace pcl_cid::test
