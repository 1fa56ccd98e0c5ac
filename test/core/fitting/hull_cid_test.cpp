/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID of a set against dense samples of its hull.
 */

#include "clouds.h"
#include "hulls.h"
#include "oracle.h"
#include "portable_draw.h"

#include <pcl_cid/core/concavity.h>
#include <pcl_cid/core/hull_cid.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using SetOfPoints = std::vector<Eigen::Vector3d>;

constexpr int anything = 2; // samples of the oracle, whose distances alone are used

SetOfPoints
firstOf(const Points& points, std::size_t count)
{
  SetOfPoints first = inDouble(points);
  first.resize(std::min(first.size(), count));
  return first;
}

/** Mixes few of the points at a time, too, which lie on edges and faces. */
Eigen::Vector3d
drawInHull(const SetOfPoints& points, RandomGenerator& generator)
{
  const std::uint64_t mixed = 1 + drawBelow(generator, 5);
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double weights = 0.0;
  for (std::uint64_t k = 0; k < mixed; ++k) {
    const double weight = 1e-6 + drawUnit(generator);
    place += weight * points[drawBelow(generator, points.size())];
    weights += weight;
  }
  return place / weights;
}

struct SampledHull {
  double highest = 0.0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
};

/** The farthest of many places of the hull, then of places between it and others: a
 *  hull holds what is between two of its places. */
SampledHull
sampleHull(const SetOfPoints& points, const Oracle& surface, int samples)
{
  RandomGenerator generator(21);
  SampledHull best{surface.distance(points.front()), points.front()};
  const auto look = [&](const Eigen::Vector3d& place) {
    const double distance = surface.distance(place);
    if (distance > best.highest)
      best = {distance, place};
  };
  for (int i = 0; i < samples; ++i)
    look(drawInHull(points, generator));
  for (int i = 0; i < samples; ++i) {
    const double share = std::pow(0.5, 1.0 + 12.0 * drawUnit(generator));
    look(best.place + share * (drawInHull(points, generator) - best.place));
  }
  return best;
}

double
sizeOfCloud(const Points& points)
{
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : points)
    box.extend(p);
  return static_cast<double>(box.diagonal().norm());
}

/** Coordinates are rounded to float before they are looked up. */
double
roundingOf(const Points& surface)
{
  double largest = 0.0;
  for (const Eigen::Vector3f& p : surface)
    largest = std::max(largest, static_cast<double>(p.cwiseAbs().maxCoeff()));
  return 2e-6 * largest;
}

class HullCIDOfClouds : public testing::TestWithParam<NamedPoints> {
protected:
  const Points& surface_ = GetParam().points;
  const DistanceField field_{surface_};
  const double size_ = std::max(1e-3, sizeOfCloud(surface_));
  const double rounding_ = roundingOf(surface_);
};

TEST_P(HullCIDOfClouds, BoundsWhatSamplesFind)
{
  const Oracle oracle(surface_, anything);
  for (const std::size_t count : {1u, 2u, 3u, 4u, 7u, 30u, 250u})
    for (const double tolerance : {0.1 * size_, 0.003 * size_}) {
      const SetOfPoints points = firstOf(surface_, count);
      const HullCID cid = hullCID(points, field_, tolerance);
      EXPECT_LE(cid.low, cid.high);
      EXPECT_LE(cid.high - cid.low, tolerance * (1.0 + 1e-12));
      const SampledHull sampled = sampleHull(points, oracle, 3000);
      EXPECT_LE(sampled.highest, cid.high + rounding_) << count;
      EXPECT_GE(sampled.highest, cid.low - 0.02 * size_ - 0.1 * cid.low) << count;
    }
}

TEST_P(HullCIDOfClouds, TwoPointsGiveEq1)
{
  const float tolerance = static_cast<float>(0.001 * size_);
  for (std::size_t i = 1; i < std::min<std::size_t>(surface_.size(), 10); ++i) {
    const Eigen::Vector3f& p = surface_[i - 1];
    const Eigen::Vector3f& q = surface_[surface_.size() - i];
    const auto low = static_cast<double>(continuousPointCID(field_, p, q, tolerance));
    const HullCID cid =
        hullCID({p.cast<double>(), q.cast<double>()}, field_, 0.001 * size_);
    EXPECT_LE(cid.low, low + 0.001 * size_ + rounding_);
    EXPECT_GE(cid.high, low - rounding_);
  }
}

TEST_P(HullCIDOfClouds, IsAtLeastTheCIDOfEveryPair)
{
  const std::size_t count = std::min<std::size_t>(surface_.size(), 40);
  const HullCID cid = hullCID(firstOf(surface_, count), field_, 0.002 * size_);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      ASSERT_LE(static_cast<double>(pointCID(field_, surface_[i], surface_[j], 20)),
                cid.high + rounding_);
}

TEST_P(HullCIDOfClouds, NeverFallsWhenPointsAreAdded)
{
  double known = 0.0;
  for (std::size_t count = 1; count <= std::min<std::size_t>(surface_.size(), 24);
       ++count) {
    const HullCID cid = hullCID(firstOf(surface_, count), field_, 0.002 * size_);
    EXPECT_GE(cid.high, known - rounding_) << count;
    known = std::max(known, cid.low);
  }
}

TEST_P(HullCIDOfClouds, MovesWithThePoints)
{
  const double tolerance = 0.002 * size_;
  const SetOfPoints points = firstOf(surface_, 60);
  const HullCID here = hullCID(points, field_, tolerance);
  const Eigen::Affine3d motion =
      Eigen::Translation3d(0.3 * size_, -0.2 * size_, 0.1 * size_) *
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.2, 0.9, -0.4).normalized());
  Points moved_surface;
  for (const Eigen::Vector3f& p : surface_)
    moved_surface.push_back((motion * p.cast<double>()).cast<float>());
  const DistanceField moved_field(moved_surface);
  const HullCID there =
      hullCID(firstOf(moved_surface, points.size()), moved_field, tolerance);
  const double rounding = 2.0 * (rounding_ + roundingOf(moved_surface));
  EXPECT_LE(there.low, here.high + rounding);
  EXPECT_LE(here.low, there.high + rounding);
}

TEST_P(HullCIDOfClouds, ScalesWithThePointsToTheBit)
{
  const double tolerance = 0.002 * size_;
  const HullCID here = hullCID(firstOf(surface_, 60), field_, tolerance);
  for (const float scale : {0x1p-8f, 0x1p8f}) {
    Points scaled = surface_;
    for (Eigen::Vector3f& p : scaled)
      p *= scale;
    const auto factor = static_cast<double>(scale);
    const HullCID there =
        hullCID(firstOf(scaled, 60), DistanceField(scaled), factor * tolerance);
    // Bounds of the field, which is another one, may lead the search another way.
    EXPECT_NEAR(there.low, factor * here.low, factor * tolerance);
    EXPECT_NEAR(there.high, factor * here.high, factor * tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Clouds,
                         HullCIDOfClouds,
                         testing::ValuesIn(allClouds()),
                         [](const auto& info) { return info.param.name; });

/** Corners of a cube of side 2 around the origin. */
Points
cornersOfCube()
{
  Points corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(
        i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f);
  return corners;
}

TEST(HullCID, OfTheCornersOfACubeIsAtItsCenter)
{
  const DistanceField field(cornersOfCube());
  for (const double tolerance : {0.5, 0.01, 1e-4}) {
    const HullCID cid = hullCID(inDouble(cornersOfCube()), field, tolerance);
    EXPECT_LE(cid.low, std::sqrt(3.0) + 1e-6);
    EXPECT_GE(cid.high, std::sqrt(3.0) - 1e-6);
    EXPECT_LE(cid.high - cid.low, tolerance);
  }
}

TEST(HullCID, OfFlatPointsIsThatOfTheirPolygon)
{
  // The surface is a square; its center is farthest. A fifth corner inside of the
  // square changes nothing, and repeated ones do not, either.
  const Points square = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
  const DistanceField field(square);
  SetOfPoints points = inDouble(square);
  for (int more = 0; more < 3; ++more) {
    const HullCID cid = hullCID(points, field, 1e-3);
    EXPECT_LE(cid.low, std::sqrt(2.0) + 1e-6);
    EXPECT_GE(cid.high, std::sqrt(2.0) - 1e-6);
    EXPECT_LE(cid.high - cid.low, 1e-3);
    points.emplace_back(0.25, 0.5, 0.0);
  }
}

TEST(HullCID, OfManyFlatPoints)
{
  RandomGenerator generator(23);
  Points surface;
  for (int i = 0; i < 20000; ++i) {
    const double x = drawUnit(generator);
    const double y = drawUnit(generator);
    const bool is_hole = Eigen::Vector2d(x - 0.5, y - 0.5).norm() < 0.25;
    if (!is_hole)
      surface.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.5f);
  }
  const HullCID cid = hullCID(inDouble(surface), DistanceField(surface), 0.01);
  EXPECT_LE(cid.low, 0.26);
  EXPECT_GE(cid.high, 0.25);
  EXPECT_LE(cid.high - cid.low, 0.01);
}

TEST(HullCID, OfPointsBesideTheSurface)
{
  const DistanceField field(Points{{0, 0, 0}});
  const HullCID one = hullCID({{3, 4, 0}}, field, 1e-3);
  EXPECT_NEAR(one.low, 5.0, 1e-5);
  EXPECT_NEAR(one.high, 5.0, 1e-3);
  const HullCID two = hullCID({{3, 4, 0}, {-3, 4, 0}, {0, 4, 0}}, field, 1e-3);
  EXPECT_NEAR(two.low, 5.0, 1e-5);
  EXPECT_GE(two.high, 5.0 - 1e-6);
}

TEST(HullCID, OfOnePointOfTheSurfaceIsZero)
{
  const DistanceField field(twoBoxes(100, 22));
  for (const Eigen::Vector3f& p : twoBoxes(100, 22)) {
    const HullCID cid = hullCID({p.cast<double>()}, field, 1e-3);
    EXPECT_EQ(cid.low, 0.0);
    EXPECT_LE(cid.high, 1e-3);
  }
}

/** It ends where float does. */
TEST(HullCID, ToleranceBelowTheResolutionOfFloat)
{
  const DistanceField field(cornersOfCube());
  for (const double tolerance : {1e-6, 1e-9, 1e-300}) {
    const HullCID cid = hullCID(inDouble(cornersOfCube()), field, tolerance);
    EXPECT_NEAR(cid.low, std::sqrt(3.0), 1e-5);
    EXPECT_NEAR(cid.high, std::sqrt(3.0), 1e-5);
    EXPECT_GE(cid.high, std::sqrt(3.0) - 1e-7);
  }
}

TEST(HullCID, RefusesWhatHasNone)
{
  const DistanceField field(cornersOfCube());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(hullCID({}, field, 0.1), CIDException);
  for (const double bad : {nan, infinity, -infinity})
    EXPECT_THROW(hullCID({{0, 0, 0}, {0, bad, 0}}, field, 0.1), CIDException);
  for (const double bad : {nan, 0.0, -0.1})
    EXPECT_THROW(hullCID({{0, 0, 0}}, field, bad), CIDException);
}

} // namespace
} // namespace pcl_cid::test
