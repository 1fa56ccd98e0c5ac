/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Coordinates of clouds.
 */

#include "cloud_files.h"

#include <cmath>

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
