/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Finite points, and an origin that loses nothing.
 */

#include "clouds.h"

#include <pcl_cid/core/point_set.h>

#include <limits>
#include <numeric>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

pcl::Indices
allOf(const Points& points)
{
  pcl::Indices indices(points.size());
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

Points
moved(const Points& points, const Eigen::Vector3f& by)
{
  Points result = points;
  for (Eigen::Vector3f& p : result)
    p += by;
  return result;
}

TEST(PointSet, KeepsFinitePointsAndTheirIndices)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const Points points = {
      {nan, 0, 0}, {1, 2, 3}, {0, infinity, 0}, {4, 5, 6}, {0, 0, -infinity}};
  const PointSet set(points, {10, 11, 12, 13, 14});
  ASSERT_EQ(set.size(), 2u);
  EXPECT_EQ(set.source, (pcl::Indices{11, 13}));
  EXPECT_EQ(set.frame.toFile(set.points[0].cast<double>()), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(set.frame.toFile(set.points[1].cast<double>()), Eigen::Vector3d(4, 5, 6));
}

TEST(PointSet, CloudAroundZeroIsUntouched)
{
  for (const NamedPoints& cloud : randomClouds()) {
    const PointSet set(cloud.points, allOf(cloud.points));
    EXPECT_TRUE(set.frame.origin.isZero(0.0)) << cloud.name;
    EXPECT_EQ(set.points, cloud.points) << cloud.name;
  }
}

TEST(PointSet, UtmCloudEqualsTheSameCloudAtTheOriginToTheBit)
{
  // On a grid of 1/4 metre the coordinates survive a shift to UTM in float unharmed.
  Points points = randomCube(500, 7);
  for (Eigen::Vector3f& p : points)
    p = (40.0f * p).array().round() / 4.0f;
  const PointSet here(points, allOf(points));
  const Points far = moved(points, {512000.0f, 1048576.0f, -1024.0f});
  const PointSet there(far, allOf(far));
  EXPECT_EQ(here.points, there.points);
  for (std::size_t i = 0; i < far.size(); ++i)
    EXPECT_EQ(there.frame.toFile(there.points[i].cast<double>()),
              far[i].cast<double>());
}

TEST(PointSet, ShiftIsExactAndResultIsNoLargerThanTheCloud)
{
  for (const float offset : {0.4f, 3.0f, 77.7f, 1e4f, -6e5f}) {
    const Points points = moved(randomCube(300, 8), Eigen::Vector3f::Constant(offset));
    const PointSet set(points, allOf(points));
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(set.frame.toFile(set.points[i].cast<double>()),
                points[i].cast<double>());
      EXPECT_LE(set.points[i].cwiseAbs().maxCoeff(), 3.0f) << "offset " << offset;
    }
  }
}

TEST(PointSet, EmptyAndSinglePoint)
{
  EXPECT_EQ(PointSet(Points(), pcl::Indices()).size(), 0u);
  const PointSet one(Points{{5e5f, 4e6f, 12.5f}}, {0});
  EXPECT_EQ(one.frame.toFile(one.points[0].cast<double>()),
            Eigen::Vector3d(5e5, 4e6, 12.5));
}

TEST(PointSet, GivenFrameIsTaken)
{
  const PointSet set(Points{{10, 20, 30}}, {3}, Frame{Eigen::Vector3d(1, 2, 3)});
  EXPECT_EQ(set.points[0], Eigen::Vector3f(9, 18, 27));
  EXPECT_EQ(set.source, pcl::Indices{3});
  EXPECT_EQ(set.frame.origin, Eigen::Vector3d(1, 2, 3));
}

TEST(Frame, ThereAndBack)
{
  const Frame frame{{512000.0, -4096.0, 0.5}};
  const Eigen::Vector3d p(1.25, 2.5, -3.0);
  EXPECT_EQ(frame.toFile(p), Eigen::Vector3d(512001.25, -4093.5, -2.5));
  EXPECT_EQ(frame.toLocal(frame.toFile(p)), p);
  EXPECT_EQ(Frame().toLocal(p), p);
}

} // namespace
} // namespace pcl_cid::test
