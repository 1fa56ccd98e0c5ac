/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Simpler hulls: they hold the exact ones and keep the bound.
 */

#include "base/random.h"
#include "clouds.h"
#include "hull/hull_mesh.h"
#include "hulls.h"
#include "prepared_points.h"

#include <pcl_cid/core/hull_simplification.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using Positions = std::vector<Eigen::Vector3d>;

/** At most the distance from a place to the hull of some points, and hardly less: the
 *  nearest point so far goes towards the vertex that is farthest in the direction of
 * the place (Frank and Wolfe 1956), and the plane through that vertex is a bound. */
double
distanceToHull(const Positions& vertices, const Eigen::Vector3d& place)
{
  constexpr int steps = 500;
  Eigen::Vector3d nearest = vertices.front();
  double distance = 0.0;
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector3d direction = place - nearest;
    const Eigen::Vector3d& farthest = *std::max_element(
        vertices.begin(), vertices.end(), [&](const auto& a, const auto& b) {
          return direction.dot(a) < direction.dot(b);
        });
    const Eigen::Vector3d way = farthest - nearest;
    if (direction.norm() > 0.0)
      distance = std::max(distance, direction.normalized().dot(place - farthest));
    if (way.squaredNorm() == 0.0)
      break;
    nearest += std::clamp(direction.dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
  }
  return distance;
}

/** Degenerate and random clouds, and small ones of all scales. */
std::vector<NamedPoints>
manyClouds()
{
  std::vector<NamedPoints> clouds = allClouds();
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    clouds.push_back({"small " + std::to_string(seed), randomSmallCloud(seed)});
  return clouds;
}

ConvexPart
simplified(ConvexPart part, const ErrorBound* bound = nullptr)
{
  std::vector<ConvexPart> parts = {std::move(part)};
  simplifyHulls(parts, Frame(), bound, onThreads(1));
  return parts.front();
}

/** Somewhere in the hull of some points. */
Eigen::Vector3d
drawInside(const Positions& vertices, RandomGenerator& generator)
{
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double sum = 0.0;
  for (const Eigen::Vector3d& v : vertices) {
    const double weight =
        std::pow(static_cast<double>(drawBelow(generator, 1000)) / 1000.0, 8.0) + 1e-9;
    place += weight * v;
    sum += weight;
  }
  return place / sum;
}

double
distanceToPoints(const Points& points, const Eigen::Vector3d& place)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3f& p : points)
    nearest = std::min(nearest, (p.cast<double>() - place).norm());
  return nearest;
}

TEST(SimplifyHulls, KeepsAllGuaranteesAndTheShareOfTheDiagonal)
{
  std::size_t exact_vertices = 0;
  std::size_t vertices = 0;
  for (const NamedPoints& cloud : manyClouds()) {
    const ConvexPart exact = partOf(cloud.points);
    const ConvexPart part = simplified(exact);
    expectGuarantees(part, cloud.points, {}, cloud.name);
    EXPECT_LE(part.hull.vertices.size(), exact.hull.vertices.size()) << cloud.name;
    EXPECT_EQ(part.indices, exact.indices);
    const double most = simplification_share * diagonalOf(exact.hull);
    for (const Eigen::Vector3d& v : exact.hull.vertices)
      EXPECT_LE(excess(part.hull, v), 1e-3 * most) << cloud.name;
    for (const Eigen::Vector3d& v : part.hull.vertices)
      EXPECT_LE(distanceToHull(exact.hull.vertices, v), (1.0 + 1e-9) * most)
          << cloud.name;
    exact_vertices += exact.hull.vertices.size();
    vertices += part.hull.vertices.size();
  }
  EXPECT_LT(vertices, exact_vertices);
}

TEST(SimplifyHulls, LeavesABoxAndWhatCannotBeSimplerAlone)
{
  Points box;
  for (int corner = 0; corner < 8; ++corner)
    box.emplace_back(corner & 1, 2 * (corner & 2), 3 * (corner & 4));
  const ConvexPart exact = partOf(box);
  const ConvexPart part = simplified(exact);
  EXPECT_EQ(part.hull.vertices, exact.hull.vertices);
  EXPECT_EQ(part.hull.triangles, exact.hull.triangles);
  EXPECT_EQ(part.volume, exact.volume);
}

TEST(SimplifyHulls, MakesABallSimplerAndHardlyLarger)
{
  for (const NamedPoints& cloud : randomClouds())
    if (cloud.name == "sphere") {
      const ConvexPart exact = partOf(cloud.points);
      ASSERT_GT(exact.hull.vertices.size(), 100u);
      const ConvexPart part = simplified(exact);
      EXPECT_LT(part.hull.vertices.size(), exact.hull.vertices.size());
      EXPECT_LT(part.volume, 1.1 * exact.volume);
    }
}

TEST(SimplifyHulls, KeepsTheBoundEverywhere)
{
  RandomGenerator generator(5);
  std::size_t exact_vertices = 0;
  std::size_t vertices = 0;
  for (const NamedPoints& cloud : randomClouds()) {
    const ConvexPart exact = partOf(cloud.points);
    const PreparedScan::ConstPtr scan = prepared(cloud.points);
    for (const double max_error : {0.05, 0.2, 0.6}) {
      const ErrorBound bound(scan, max_error);
      const ConvexPart part = simplified(exact, &bound);
      expectGuarantees(part, cloud.points, {}, cloud.name);
      exact_vertices += exact.hull.vertices.size();
      vertices += part.hull.vertices.size();
      if (!bound.isKeptBy(exact.hull)) {
        EXPECT_EQ(part.hull.vertices, exact.hull.vertices) << cloud.name;
        continue;
      }
      for (const Eigen::Vector3d& v : part.hull.vertices)
        EXPECT_LE(distanceToPoints(cloud.points, v), max_error * 1.0001) << cloud.name;
      for (int i = 0; i < 200; ++i)
        EXPECT_LE(
            distanceToPoints(cloud.points, drawInside(part.hull.vertices, generator)),
            max_error * 1.0001)
            << cloud.name;
    }
  }
  EXPECT_LT(vertices, exact_vertices);
}

TEST(SimplifyHulls, IsTheSameForEveryNumberOfThreadsAndMovesWithTheFrame)
{
  std::vector<ConvexPart> exact;
  for (const NamedPoints& cloud : randomClouds())
    exact.push_back(partOf(cloud.points));
  std::vector<ConvexPart> one = exact;
  simplifyHulls(one, Frame(), nullptr, onThreads(1));
  std::vector<ConvexPart> many = exact;
  simplifyHulls(many, Frame(), nullptr, onThreads(5));
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].hull.vertices, many[k].hull.vertices);
    EXPECT_EQ(one[k].hull.triangles, many[k].hull.triangles);
  }
  const Frame far{{524288.0, 4194304.0, 128.0}};
  for (ConvexPart& part : exact)
    for (Eigen::Vector3d& v : part.hull.vertices)
      v = far.toFile(v);
  simplifyHulls(exact, far, nullptr, onThreads(2));
  for (std::size_t k = 0; k < one.size(); ++k)
    EXPECT_NEAR(exact[k].volume, one[k].volume, 1e-2 * one[k].volume);
}

TEST(ErrorBound, CountsOnlyPlacesThatWereSeen)
{
  // A wall with a hole of 1 m; the scanner looks at it from one side.
  Points points;
  for (int y = -50; y <= 50; ++y)
    for (int z = -50; z <= 50; ++z)
      if (std::max(std::abs(y), std::abs(z)) > 25)
        points.emplace_back(
            2.0f, 0.04f * static_cast<float>(y), 0.04f * static_cast<float>(z));
  const PreparedScan::ConstPtr scan = prepared(points);
  const auto cubeAt = [](double x, double y) {
    TriangleMesh cube;
    for (int corner = 0; corner < 8; ++corner)
      cube.vertices.emplace_back(
          x + 0.2 * (corner & 1), y + 0.1 * (corner & 2), -0.1 + 0.05 * (corner & 4));
    return cube;
  };
  const ErrorBound all(scan, 0.5);
  const ErrorBound seen(scan, 0.5, {{0.0, 0.0, 0.0}});
  EXPECT_TRUE(all.isKeptBy(cubeAt(2.1, 1.5)));
  EXPECT_TRUE(seen.isKeptBy(cubeAt(2.1, 1.5)));
  EXPECT_FALSE(all.isKeptBy(cubeAt(3.0, 1.7))); // behind the wall: nobody knows
  EXPECT_TRUE(seen.isKeptBy(cubeAt(3.0, 1.7)));
  EXPECT_FALSE(all.isKeptBy(cubeAt(1.2, 0.9))); // before it: free
  EXPECT_FALSE(seen.isKeptBy(cubeAt(1.2, 0.9)));
}

TEST(ErrorBound, RefusesWhatIsOutOfItsRange)
{
  const PreparedScan::ConstPtr scan = prepared(randomCube(20, 3));
  EXPECT_THROW(ErrorBound(nullptr, 0.1), CIDException);
  EXPECT_THROW(ErrorBound(scan, 0.0), CIDException);
  EXPECT_THROW(ErrorBound(scan, std::nan("")), CIDException);
  EXPECT_THROW(ErrorBound(scan, 0.1, {{0.0, std::nan(""), 0.0}}), CIDException);
}

} // namespace
} // namespace pcl_cid::test
