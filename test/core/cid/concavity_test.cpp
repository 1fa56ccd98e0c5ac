/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Eq. 1 to 3: against the literal definitions, and the properties of section III.
 */

#include "base/random.h"
#include "clouds.h"
#include "oracle.h"

#include <pcl_cid/core/concavity.h>
#include <pcl_cid/exceptions.h>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace pcl_cid::test {
namespace {

struct Pair {
  Eigen::Vector3f p;
  Eigen::Vector3f q;
};

std::vector<Pair>
randomPairs(const Points& points, std::size_t count, std::uint64_t seed)
{
  RandomGenerator generator(seed);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t p = drawBelow(generator, points.size());
    const std::size_t q = drawBelow(generator, points.size());
    pairs.push_back({points[p], points[q]});
  }
  return pairs;
}

class ConcavityOfClouds : public testing::TestWithParam<NamedPoints> {
protected:
  const Points& points_ = GetParam().points;
  const DistanceField field_{points_};
  const double tolerance_ = agreementTolerance(points_) + 1e-7;
};

TEST_P(ConcavityOfClouds, Equation2EqualsTheLiteralDefinition)
{
  for (const int samples : {2, 3, 7, 64, 100}) {
    const Oracle oracle(points_, samples);
    for (const auto& [p, q] : randomPairs(points_, 60, 21))
      EXPECT_NEAR(pointCID(field_, p, q, samples), oracle.pointCID(p, q), tolerance_);
  }
}

TEST_P(ConcavityOfClouds, Equation2IsTheMaximumOfAllSamplesToTheBit)
{
  constexpr int samples = 100;
  for (const auto& [p, q] : randomPairs(points_, 150, 22)) {
    float largest = 0.0f;
    for (int l = 0; l < samples; ++l)
      largest = std::max(largest, field_.distance(segmentSample(p, q, l, samples)));
    EXPECT_EQ(pointCID(field_, p, q, samples), largest);
  }
}

TEST_P(ConcavityOfClouds, NonNegativeSymmetricToTheBitReflexive)
{
  for (const auto& [p, q] : randomPairs(points_, 150, 23)) {
    EXPECT_GE(pointCID(field_, p, q, 100), 0.0f);
    EXPECT_EQ(pointCID(field_, p, q, 100), pointCID(field_, q, p, 100));
    EXPECT_EQ(pointCID(field_, p, p, 100), 0.0f);
  }
}

TEST_P(ConcavityOfClouds, LimitGivesUpOnlyWhenReached)
{
  for (const auto& [p, q] : randomPairs(points_, 150, 24)) {
    const float cid = pointCID(field_, p, q, 50);
    for (const float share : {0.0f, 0.5f, 1.0f, 1.5f}) {
      const float limit = share * cid;
      const float found = pointCID(field_, p, q, 50, limit);
      if (cid < limit)
        EXPECT_EQ(found, cid);
      else
        EXPECT_TRUE(found >= limit && found <= cid) << found << " of " << cid;
    }
  }
}

TEST_P(ConcavityOfClouds, Equation1IsWithinItsTolerance)
{
  const float diagonal = static_cast<float>(1e5 * agreementTolerance(points_));
  for (const auto& [p, q] : randomPairs(points_, 25, 25)) {
    const float reference = pointCID(field_, p, q, 16385);
    const float rounding = 1e-6f * diagonal;
    for (const float tolerance : {0.1f, 0.01f, 0.001f}) {
      if (!(tolerance * diagonal > 0.0f))
        continue;
      const float cid = continuousPointCID(field_, p, q, tolerance * diagonal);
      // The reference itself misses Eq. 1 by half of its spacing at most.
      const float unseen = (q - p).norm() / (2.0f * 16384.0f);
      EXPECT_LE(cid, reference + unseen + rounding);
      EXPECT_GE(cid, reference - tolerance * diagonal - rounding);
    }
  }
}

TEST_P(ConcavityOfClouds, Equation2NeverExceedsEquation1)
{
  const float diagonal = static_cast<float>(1e5 * agreementTolerance(points_));
  const float tolerance = std::max(1e-3f * diagonal, 1e-6f);
  for (const auto& [p, q] : randomPairs(points_, 40, 26))
    EXPECT_LE(pointCID(field_, p, q, 100),
              continuousPointCID(field_, p, q, tolerance) + tolerance +
                  1e-6f * diagonal);
}

TEST_P(ConcavityOfClouds, ChangesByNoMoreThanAPointMoves)
{
  float magnitude = 0.0f;
  for (const Eigen::Vector3f& point : points_)
    magnitude = std::max(magnitude, point.cwiseAbs().maxCoeff());
  const float slack = 32.0f * std::numeric_limits<float>::epsilon() * magnitude;
  const std::vector<Pair> pairs = randomPairs(points_, 300, 27);
  for (std::size_t k = 0; k + 1 < pairs.size(); ++k) {
    const auto& [p, q] = pairs[k];
    const Eigen::Vector3f moved = pairs[k + 1].p;
    EXPECT_LE(pointCID(field_, moved, q, 100),
              (pointCID(field_, p, q, 100) + (moved - p).norm()) * 1.00001f + slack);
  }
}

TEST_P(ConcavityOfClouds, InvariantUnderRigidMotion)
{
  const Eigen::Isometry3f motion =
      Eigen::Translation3f(0.3f, -0.7f, 0.2f) *
      Eigen::AngleAxisf(1.1f, Eigen::Vector3f(1.0f, 2.0f, -0.5f).normalized());
  Points moved = points_;
  for (Eigen::Vector3f& p : moved)
    p = motion * p;
  const DistanceField moved_field(moved);
  for (const auto& [p, q] : randomPairs(points_, 100, 27))
    EXPECT_NEAR(pointCID(moved_field, motion * p, motion * q, 100),
                pointCID(field_, p, q, 100),
                tolerance_ + 1e-6);
}

TEST_P(ConcavityOfClouds, ScalesWithTheCloud)
{
  // A power of two scales floats without rounding, so the CID scales to the bit.
  Points scaled = points_;
  for (Eigen::Vector3f& p : scaled)
    p *= 8.0f;
  const DistanceField scaled_field(scaled);
  for (const auto& [p, q] : randomPairs(points_, 100, 28))
    EXPECT_EQ(pointCID(scaled_field, 8.0f * p, 8.0f * q, 100),
              8.0f * pointCID(field_, p, q, 100));
}

INSTANTIATE_TEST_SUITE_P(Clouds,
                         ConcavityOfClouds,
                         testing::ValuesIn(allClouds()),
                         [](const auto& info) { return info.param.name; });

TEST(Concavity, TriangleInequalityFails)
{
  // An L: two walls that meet in a corner. Along each wall CID is small, across the
  // open corner it is not. That is what separates objects that touch.
  Points walls;
  for (int i = 0; i <= 100; ++i) {
    walls.emplace_back(0.01f * static_cast<float>(i), 0.0f, 0.0f);
    walls.emplace_back(0.0f, 0.01f * static_cast<float>(i), 0.0f);
  }
  const DistanceField field(walls);
  const Eigen::Vector3f a(1.0f, 0.0f, 0.0f), corner(0.0f, 0.0f, 0.0f),
      b(0.0f, 1.0f, 0.0f);
  EXPECT_GT(pointCID(field, a, b, 100),
            10.0f *
                (pointCID(field, a, corner, 100) + pointCID(field, corner, b, 100)));
}

TEST(Concavity, KnownValue)
{
  // Halfway between two points a metre apart there is nothing for half a metre.
  const DistanceField field({{0, 0, 0}, {1, 0, 0}});
  EXPECT_FLOAT_EQ(pointCID(field, {0, 0, 0}, {1, 0, 0}, 101), 0.5f);
  EXPECT_NEAR(continuousPointCID(field, {0, 0, 0}, {1, 0, 0}, 1e-3f), 0.5f, 1e-3f);
}

TEST(Concavity, SamplesStartAndEndAtThePoints)
{
  const Eigen::Vector3f p(0.1f, -3.3f, 1e3f), q(0.7f, 2.2f, -1e-3f);
  for (const int samples : {2, 3, 100, max_samples}) {
    EXPECT_EQ(segmentSample(p, q, 0, samples), p);
    EXPECT_EQ(segmentSample(p, q, samples - 1, samples), q);
    EXPECT_EQ(segmentSample(p, p, samples / 2, samples), p);
    EXPECT_EQ(segmentSample(p, q, samples / 3, samples),
              segmentSample(q, p, samples - 1 - samples / 3, samples));
  }
}

TEST(Concavity, Equation3IsTheMeanOverAllPairs)
{
  const Points points = twoBoxes(60, 29);
  const Points first(points.begin(), points.begin() + 13);
  const Points second(points.begin() + 20, points.begin() + 41);
  const DistanceField field(points);
  EXPECT_NEAR(groupCID(field, first, second, 100),
              Oracle(points, 100).groupCID(first, second),
              agreementTolerance(points));
  EXPECT_NEAR(
      groupCID(field, first, second, 100), groupCID(field, second, first, 100), 1e-12);
}

TEST(Concavity, RefusesBadValues)
{
  const DistanceField field({{0, 0, 0}});
  EXPECT_THROW(continuousPointCID(field, {0, 0, 0}, {1, 0, 0}, 0.0f), CIDException);
  EXPECT_THROW(continuousPointCID(field, {0, 0, 0}, {1, 0, 0}, NAN), CIDException);
  EXPECT_THROW(groupCID(field, {}, {{0, 0, 0}}, 100), CIDException);
}

} // namespace
} // namespace pcl_cid::test
