/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * d(x; S) against brute force.
 */

#include "clouds.h"

#include <pcl_cid/core/distance_field.h>
#include <pcl_cid/exceptions.h>

#include <cmath>

#include <pcl/search/brute_force.h>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** The float minimum by a plain loop, with the arithmetic that the contract names. */
float
bruteForceDistance(const Points& surface, const Eigen::Vector3f& x)
{
  float nearest = std::numeric_limits<float>::infinity();
  for (const Eigen::Vector3f& p : surface) {
    const Eigen::Vector3f d = x - p;
    nearest = std::min(nearest, d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
  }
  return std::sqrt(nearest);
}

Points
probes(const Points& surface)
{
  Points result = surface;
  for (const Eigen::Vector3f& p : randomCube(2000, 11))
    result.push_back(4.0f * p - Eigen::Vector3f::Constant(1.5f));
  for (std::size_t i = 0; i + 1 < surface.size(); ++i)
    result.push_back(0.5f * (surface[i] + surface[i + 1]));
  return result;
}

TEST(DistanceField, EqualsBruteForceToTheBit)
{
  for (const NamedPoints& cloud : allClouds()) {
    const DistanceField field(cloud.points);
    for (const Eigen::Vector3f& x : probes(cloud.points))
      ASSERT_EQ(field.distance(x), bruteForceDistance(cloud.points, x)) << cloud.name;
  }
}

TEST(DistanceField, EqualsBruteForceOnARealScan)
{
  const auto scan = loadSharedScan("office1.pcd");
  if (!scan)
    GTEST_SKIP() << "../shared/data/office1.pcd is absent";
  const Points surface = crop(*scan, 20000, 3);
  const DistanceField field(surface);
  const Points targets = crop(*scan, 1500, 71);
  for (std::size_t i = 0; i + 1 < targets.size(); ++i) {
    const Eigen::Vector3f x = 0.5f * (targets[i] + targets[i + 1]);
    ASSERT_EQ(field.distance(x), bruteForceDistance(surface, x));
  }
}

TEST(DistanceField, NearestIsAtTheDistance)
{
  const Points surface = twoBoxes(400, 12);
  const DistanceField field(surface);
  for (const Eigen::Vector3f& x : probes(surface)) {
    const auto nearest = static_cast<std::size_t>(field.nearest(x));
    ASSERT_LT(nearest, surface.size());
    EXPECT_FLOAT_EQ((surface[nearest] - x).norm(), field.distance(x));
    const DistanceField::Nearest found = field.nearestPoint(x);
    EXPECT_EQ(found.distance, field.distance(x));
    EXPECT_EQ(bruteForceDistance({found.point}, x), found.distance);
  }
}

TEST(DistanceField, IsInfiniteWhereFloatCannotSay)
{
  const DistanceField field(twoBoxes(400, 15));
  for (const Eigen::Vector3f& x :
       {Eigen::Vector3f(1e30f, 0.0f, 0.0f), Eigen::Vector3f(-3e38f, 3e38f, 1.0f)})
    EXPECT_EQ(field.distance(x), std::numeric_limits<float>::infinity());
}

TEST(DistanceField, IsOneLipschitz)
{
  const Points surface = twoBoxes(400, 13);
  const DistanceField field(surface);
  const Points x = probes(surface);
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const float difference = std::abs(field.distance(x[i]) - field.distance(x[i + 1]));
    EXPECT_LE(difference, (x[i] - x[i + 1]).norm() * 1.00001f + 1e-6f);
  }
}

TEST(DistanceField, UsesTheSearchItIsGiven)
{
  const Points surface = randomCube(200, 14);
  const auto search = pcl::make_shared<pcl::search::BruteForce<pcl::PointXYZ>>();
  DistanceField::Options options;
  options.search = search;
  const DistanceField with_brute_force(surface, options);
  const DistanceField with_tree(surface);
  for (const Eigen::Vector3f& x : probes(surface))
    EXPECT_EQ(with_brute_force.distance(x), with_tree.distance(x));
  ASSERT_TRUE(search->getInputCloud());
  EXPECT_EQ(search->getInputCloud()->size(), surface.size());
}

TEST(DistanceField, RefusesAnEmptySurface)
{
  EXPECT_THROW(DistanceField(Points{}), CIDException);
}

} // namespace
} // namespace pcl_cid::test
