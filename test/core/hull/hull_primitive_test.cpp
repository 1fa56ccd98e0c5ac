/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Primitives for hulls: what is nearly a box, a ball or a rod, and what is not.
 */

#include "base/random.h"
#include "clouds.h"
#include "hulls.h"
#include "prepared_points.h"

#include <pcl_cid/core/hull_primitive.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace pcl_cid::test {
namespace {

using Kind = HullPrimitive::Kind;

double
draw(RandomGenerator& generator, double low, double high)
{
  return low +
         (high - low) * static_cast<double>(drawBelow(generator, 1 << 20)) / (1 << 20);
}

/** A pose anywhere within a metre. */
Eigen::Isometry3d
drawPose(RandomGenerator& generator)
{
  const auto one = [&] { return draw(generator, -1.0, 1.0); };
  return Eigen::Translation3d(one(), one(), one()) *
         Eigen::Quaterniond(one(), one(), one(), one()).normalized();
}

/** Directions all around. */
std::vector<Eigen::Vector3d>
directions(std::size_t count)
{
  std::vector<Eigen::Vector3d> all;
  for (std::size_t i = 0; i < count; ++i) {
    const double z =
        1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
    const double angle = 2.39996322972865332 * static_cast<double>(i);
    const double off = std::sqrt(1.0 - z * z);
    all.emplace_back(off * std::cos(angle), off * std::sin(angle), z);
  }
  return all;
}

/** Points on a primitive of this kind about the origin. */
std::vector<Eigen::Vector3d>
pointsOn(Kind kind, const Eigen::Vector3d& extents)
{
  std::vector<Eigen::Vector3d> points;
  const double radius = 0.5 * extents.x();
  if (kind == Kind::box)
    for (int x = -3; x <= 3; ++x)
      for (int y = -3; y <= 3; ++y)
        for (int z = -3; z <= 3; ++z)
          points.push_back(extents.cwiseProduct(Eigen::Vector3d(x, y, z)) / 6.0);
  if (kind == Kind::cylinder)
    for (int i = 0; i < 40; ++i)
      for (const double z : {-0.5, 0.0, 0.5})
        points.emplace_back(radius * std::cos(M_PI * i / 20.0),
                            radius * std::sin(M_PI * i / 20.0),
                            z * extents.z());
  if (kind == Kind::sphere || kind == Kind::capsule)
    for (const Eigen::Vector3d& direction : directions(400)) {
      Eigen::Vector3d p = radius * direction;
      if (kind == Kind::capsule)
        p.z() += (p.z() > 0.0 ? 0.5 : -0.5) * (extents.z() - extents.x());
      points.push_back(p);
    }
  return points;
}

Points
posed(const std::vector<Eigen::Vector3d>& points,
      const Eigen::Isometry3d& pose,
      double scale)
{
  Points result;
  for (const Eigen::Vector3d& p : points)
    result.push_back((scale * (pose * p)).cast<float>());
  return result;
}

std::optional<HullPrimitive>
primitiveOf(const ConvexPart& part, const PrimitiveOptions& options = {})
{
  return fitPrimitives({part}, Frame(), options, onThreads(1)).front();
}

void
expectHolds(const HullPrimitive& primitive,
            const ConvexPart& part,
            const Points& points,
            const std::string& what)
{
  double most = -1e300;
  for (const pcl::index_t i : part.indices)
    most = std::max(
        most, excess(primitive, points[static_cast<std::size_t>(i)].cast<double>()));
  EXPECT_LE(most, 0.0) << what;
  EXPECT_LE(volumeOf(primitive), (1.0 + primitive_share) * part.volume) << what;
  EXPECT_NEAR(primitive.axes.determinant(), 1.0, 1e-9) << what;
}

ConvexPart
partWithout(const Points& points, double scale)
{
  ConvexPartOptions options;
  options.min_thickness *= scale;
  return partOf(points, options);
}

TEST(FitPrimitives, KnowsBoxesBallsAndRodsHoweverTheyLie)
{
  RandomGenerator generator(17);
  for (int i = 0; i < 120; ++i) {
    const Kind kind = static_cast<Kind>(i % 4);
    const double radius = draw(generator, 0.1, 0.4);
    Eigen::Vector3d extents(
        2.0 * radius, 2.0 * radius, draw(generator, 3.0, 9.0) * radius);
    if (kind == Kind::box)
      extents = {draw(generator, 0.1, 1.0), draw(generator, 0.1, 1.0), extents.z()};
    const double scale = std::pow(10.0, i % 7 - 3);
    const Points points = posed(pointsOn(kind, extents), drawPose(generator), scale);
    const ConvexPart part = partWithout(points, scale);
    const auto primitive = primitiveOf(part);
    const std::string what = nameOf(kind) + std::string(" ") + std::to_string(i);
    ASSERT_TRUE(primitive) << what;
    EXPECT_STREQ(nameOf(primitive->kind), nameOf(kind)) << what;
    expectHolds(*primitive, part, points, what);
  }
}

TEST(FitPrimitives, HoldsThePointsOfEveryPartThatBecomesOne)
{
  std::vector<NamedPoints> clouds = allClouds();
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    clouds.push_back({"small " + std::to_string(seed), randomSmallCloud(seed)});
  std::size_t found = 0;
  for (const NamedPoints& cloud : clouds) {
    const ConvexPart part = partOf(cloud.points);
    if (const auto primitive = primitiveOf(part)) {
      expectHolds(*primitive, part, cloud.points, cloud.name);
      ++found;
    }
  }
  EXPECT_GT(found, 10u);
  EXPECT_LT(found, clouds.size());
}

TEST(FitPrimitives, AWallIsABoxAndAPointIsOne)
{
  const ConvexPart wall =
      partOf({{0, 0, 0}, {4, 0, 0}, {0, 0, 3}, {4, 0, 3}, {1, 0, 1}});
  const auto primitive = primitiveOf(wall);
  ASSERT_TRUE(primitive);
  EXPECT_EQ(primitive->kind, Kind::box);
  EXPECT_NEAR(primitive->extents.minCoeff(), setting::min_thickness.initial, 2e-4);
  const auto dot = primitiveOf(partOf({{1, 2, 3}}));
  ASSERT_TRUE(dot);
  EXPECT_EQ(dot->kind, Kind::box);
}

TEST(FitPrimitives, LeavesPyramidsAndChunksOfATorusAlone)
{
  RandomGenerator generator(23);
  for (int i = 0; i < 10; ++i) {
    std::vector<Eigen::Vector3d> torus;
    for (int u = 0; u <= 20; ++u)
      for (int v = 0; v < 16; ++v) {
        const double around = 0.5 * M_PI * u / 20.0;
        const double off = 1.0 + 0.25 * std::cos(M_PI * v / 8.0);
        torus.emplace_back(off * std::cos(around),
                           off * std::sin(around),
                           0.25 * std::sin(M_PI * v / 8.0));
      }
    EXPECT_FALSE(primitiveOf(partOf(posed(torus, drawPose(generator), 1.0))));
    const std::vector<Eigen::Vector3d> pyramid = {
        {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 1}};
    EXPECT_FALSE(primitiveOf(partOf(posed(pyramid, drawPose(generator), 1.0))));
    std::vector<Eigen::Vector3d> el; // two arms, the hull fills the corner
    for (int z = 0; z <= 1; ++z)
      for (const auto& [x, y] :
           {std::pair(0.0, 0.0), {2.0, 0.0}, {2.0, 0.3}, {0.3, 2.0}, {0.0, 2.0}})
        el.emplace_back(x, y, 0.5 * z);
    EXPECT_FALSE(primitiveOf(partOf(posed(el, drawPose(generator), 1.0))));
  }
}

TEST(FitPrimitives, HasThePaddingOfTheHull)
{
  ConvexPartOptions options;
  options.padding = 0.1;
  for (const Kind kind : {Kind::box, Kind::sphere, Kind::cylinder, Kind::capsule}) {
    const Points points =
        posed(pointsOn(kind, {1.0, 1.0, 2.0}), Eigen::Isometry3d::Identity(), 1.0);
    PrimitiveOptions all;
    all.share = 1.0;
    const auto primitive = primitiveOf(partOf(points, options), all);
    ASSERT_TRUE(primitive);
    for (const Eigen::Vector3f& p : points)
      EXPECT_LE(excess(*primitive, p.cast<double>()), -options.padding + 1e-6);
  }
}

TEST(FitPrimitives, AsksWhetherItMayAndTakesTheNextOne)
{
  const ConvexPart ball = partOf(
      posed(pointsOn(Kind::sphere, {1, 1, 1}), Eigen::Isometry3d::Identity(), 1.0));
  PrimitiveOptions options;
  options.may_replace = [](const TriangleMesh&) { return false; };
  EXPECT_FALSE(primitiveOf(ball, options));
  options.may_replace = nullptr;
  options.kinds = {Kind::box, Kind::cylinder};
  EXPECT_FALSE(primitiveOf(ball, options));
  options.share = 1.0;
  const auto other = primitiveOf(ball, options);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->kind, Kind::cylinder);
  options.share = -0.1;
  EXPECT_THROW(primitiveOf(ball, options), CIDException);
}

TEST(FitPrimitives, IsTheSameForEveryNumberOfThreadsAndMovesWithTheFrame)
{
  std::vector<ConvexPart> parts;
  for (const NamedPoints& cloud : allClouds())
    parts.push_back(partOf(cloud.points));
  const auto one = fitPrimitives(parts, Frame(), {}, onThreads(1));
  const auto many = fitPrimitives(parts, Frame(), {}, onThreads(6));
  const Frame far{{524288.0, 4194304.0, 128.0}};
  for (ConvexPart& part : parts)
    for (Eigen::Vector3d& v : part.hull.vertices)
      v = far.toFile(v);
  const auto moved = fitPrimitives(parts, far, {}, onThreads(2));
  for (std::size_t k = 0; k < parts.size(); ++k) {
    ASSERT_EQ(one[k].has_value(), many[k].has_value());
    if (!one[k])
      continue;
    EXPECT_EQ(one[k]->center, many[k]->center);
    EXPECT_EQ(one[k]->axes, many[k]->axes);
    EXPECT_EQ(one[k]->extents, many[k]->extents);
    if (!moved[k] || one[k]->extents.maxCoeff() > 100.0)
      continue;
    EXPECT_LT((far.toLocal(moved[k]->center) - one[k]->center).norm(),
              0.05 * one[k]->extents.norm());
  }
}

TEST(MeshAround, HoldsThePrimitiveAndHardlyMore)
{
  RandomGenerator generator(31);
  for (const Kind kind : {Kind::box, Kind::sphere, Kind::cylinder, Kind::capsule}) {
    const Eigen::Isometry3d pose = drawPose(generator);
    const HullPrimitive primitive = {kind,
                                     pose.translation(),
                                     pose.linear(),
                                     {0.4, 0.4, kind == Kind::sphere ? 0.4 : 1.0}};
    const TriangleMesh mesh = meshAround(primitive);
    EXPECT_FALSE(mesh.triangles.empty());
    for (const Eigen::Vector3d& p : pointsOn(kind, primitive.extents))
      EXPECT_LE(excess(mesh, pose * p), 1e-5) << nameOf(kind);
    for (const Eigen::Vector3d& v : mesh.vertices)
      EXPECT_LE(excess(primitive, v), 0.011 * primitive.radius()) << nameOf(kind);
  }
}

} // namespace
} // namespace pcl_cid::test
