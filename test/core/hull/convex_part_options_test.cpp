/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls that are reduced, padded, and freed from stray points.
 */

#include "hulls.h"

#include "base/random.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

Points
sphere()
{
  for (NamedPoints& cloud : randomClouds())
    if (cloud.name == "sphere")
      return cloud.points;
  return {};
}

ConvexPartOptions
atMost(std::size_t max_vertices)
{
  ConvexPartOptions options;
  options.max_vertices = max_vertices;
  return options;
}

TEST(MaxVertices, EveryLimitIsKeptAndMoreVerticesAreTighter)
{
  const Points points = sphere();
  const ConvexPart exact = partOf(points);
  ASSERT_GT(exact.hull.vertices.size(), 100u);
  for (std::size_t most = 4; most <= 64; ++most) {
    const ConvexPart part = partOf(points, atMost(most));
    expectGuarantees(part, points, atMost(most), std::to_string(most));
    EXPECT_GT(part.volume, exact.volume);
  }
  double larger = partOf(points, atMost(8)).volume;
  for (const std::size_t most : {16u, 32u, 64u}) {
    const double volume = partOf(points, atMost(most)).volume;
    EXPECT_LT(volume, larger) << most;
    larger = volume;
  }
  EXPECT_LT(larger, 1.1 * exact.volume);
}

TEST(MaxVertices, AHullOfFewerVerticesStaysAsItIs)
{
  for (const NamedPoints& cloud : allClouds()) {
    const ConvexPart exact = partOf(cloud.points);
    const ConvexPart part = partOf(cloud.points, atMost(exact.hull.vertices.size()));
    EXPECT_EQ(part.hull.vertices, exact.hull.vertices) << cloud.name;
    EXPECT_EQ(part.hull.triangles, exact.hull.triangles) << cloud.name;
  }
}

TEST(MaxVertices, AReducedHullLiesInTheBoxOfThePoints)
{
  Points points = sphere();
  for (Eigen::Vector3f& p : points)
    p = p.cwiseProduct(Eigen::Vector3f(3.0f, 2.0f, 1.0f)); // its axes are x, y and z
  for (const std::size_t most : {8u, 20u})
    for (const Eigen::Vector3d& v : partOf(points, atMost(most)).hull.vertices) {
      EXPECT_LT(std::abs(v.x()), 3.2);
      EXPECT_LT(std::abs(v.y()), 2.2);
      EXPECT_LT(std::abs(v.z()), 1.2);
    }
}

TEST(Padding, ReachesAsFarAsAskedAndAtMostSqrt3TimesAsFar)
{
  for (const NamedPoints& cloud : allClouds()) {
    ConvexPartOptions options;
    const TriangleMesh tight = partOf(cloud.points, options).hull;
    options.padding = 0.1;
    const ConvexPart part = partOf(cloud.points, options);
    expectGuarantees(part, cloud.points, options, cloud.name);
    const double tolerance =
        hull_tolerance * (tight.vertices[0] - tight.vertices[1]).norm() + 1e-2 * 0.1;
    for (const Eigen::Vector3d& v : tight.vertices)
      EXPECT_LE(excess(part.hull, v), -options.padding + tolerance) << cloud.name;
    for (const Eigen::Vector3d& v : part.hull.vertices)
      EXPECT_LE(excess(tight, v), std::sqrt(3.0) * options.padding + tolerance)
          << cloud.name;
  }
}

TEST(Padding, OfAFlatSquareIsAThickerLargerSlab)
{
  ConvexPartOptions options;
  options.min_thickness = 0.01;
  options.padding = 0.05;
  const ConvexPart part = partOf({{0, 0, 2}, {2, 0, 2}, {0, 1, 2}, {2, 1, 2}}, options);
  EXPECT_NEAR(part.volume, 2.1 * 1.1 * 0.11, 1e-6);
  EXPECT_NEAR(part.thickness, 0.11, 1e-6);
  EXPECT_TRUE(part.thickened);
}

ConvexPartOptions
trimmedAt(double distance)
{
  ConvexPartOptions options;
  options.trim_distance = distance;
  return options;
}

TEST(Trimming, OneStrayPointDoesNotBlowUpAHull)
{
  Points points = randomCube(500, 61);
  points.insert(points.begin() + 200, Eigen::Vector3f(9.0f, 9.0f, 9.0f));
  EXPECT_GT(partOf(points).volume, 5.0);
  const ConvexPart part = partOf(points, trimmedAt(0.4));
  EXPECT_LT(part.volume, 1.0);
  EXPECT_EQ(part.trimmed, pcl::Indices{200});
  EXPECT_EQ(part.indices.size(), 500u);
  EXPECT_EQ(std::count(part.indices.begin(), part.indices.end(), 200), 0);
  expectGuarantees(part, points, trimmedAt(0.4), "cube");
}

TEST(Trimming, IsOffUnlessAskedFor)
{
  Points points = randomCube(500, 62);
  points.emplace_back(9.0f, 9.0f, 9.0f);
  EXPECT_TRUE(partOf(points).trimmed.empty());
  EXPECT_EQ(partOf(points).indices.size(), 501u);
}

TEST(Trimming, KeptAndTrimmedAreThePartAndAscend)
{
  Points points = randomCube(800, 63);
  for (std::size_t i = 0; i < 5; ++i)
    points[100 * i] += Eigen::Vector3f::Constant(10.0f + 5.0f * static_cast<float>(i));
  const ConvexPart part = partOf(points, trimmedAt(0.4));
  EXPECT_EQ(part.trimmed, (pcl::Indices{0, 100, 200, 300, 400}));
  EXPECT_TRUE(std::is_sorted(part.indices.begin(), part.indices.end()));
  EXPECT_EQ(part.indices.size() + part.trimmed.size(), points.size());
}

TEST(Trimming, ClustersAreThoseOfAllPairs)
{
  // Dense and sparse, so that the clusters are of all sizes.
  RandomGenerator generator(64);
  Points points = randomCube(1500, 64);
  for (Eigen::Vector3f& p : points)
    p *= static_cast<float>(1 + drawBelow(generator, 6));
  for (const double distance : {0.05, 0.15, 0.3, 0.6}) {
    // Union by relaxing labels over all pairs until nothing changes.
    std::vector<std::size_t> label(points.size());
    for (std::size_t i = 0; i < label.size(); ++i)
      label[i] = i;
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < points.size(); ++j)
          if (label[j] < label[i] &&
              (points[i] - points[j]).cast<double>().norm() <= distance) {
            label[i] = label[j];
            changed = true;
          }
    }
    std::vector<std::size_t> size(points.size(), 0);
    for (const std::size_t l : label)
      ++size[l];
    const std::size_t largest = *std::max_element(size.begin(), size.end());
    pcl::Indices expected;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (100 * size[label[i]] < largest)
        expected.push_back(static_cast<pcl::index_t>(i));
    EXPECT_EQ(partOf(points, trimmedAt(distance)).trimmed, expected) << distance;
  }
}

TEST(Trimming, ComparablePiecesAndSparsePointsStay)
{
  EXPECT_TRUE(partOf(twoBoxes(400, 65), trimmedAt(0.5)).trimmed.empty());
  EXPECT_TRUE(partOf(randomCube(300, 66), trimmedAt(1e-6)).trimmed.empty());
  EXPECT_TRUE(partOf({{0, 0, 0}}, trimmedAt(0.1)).trimmed.empty());
}

} // namespace
} // namespace pcl_cid::test
