/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID from one point to many: each of them is CID_p, whoever computes it.
 */

#include "clouds.h"
#include "prepared_points.h"

#include <pcl_cid/core/cid_from.h>
#include <pcl_cid/core/concavity.h>
#include <pcl_cid/exceptions.h>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

class CIDFromPoints : public testing::TestWithParam<NamedPoints> {};

TEST_P(CIDFromPoints, EqualsEveryPointCIDToTheBit)
{
  const Points& points = GetParam().points;
  const DistanceField field(points);
  for (const int samples : {2, 7, 100}) {
    const Eigen::Vector3f& p = points[points.size() / 3];
    const std::vector<float> cids = cidFrom(field, p, points, samples);
    ASSERT_EQ(cids.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      ASSERT_EQ(cids[i], pointCID(field, p, points[i], samples)) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(AllClouds,
                         CIDFromPoints,
                         testing::ValuesIn(allClouds()),
                         [](const auto& info) { return info.param.name; });

/// Two walls that meet at a right angle: by hand, a point of one and one of the other,
/// both 1 m from the edge, see d = 0.5 m at the middle of the way between them.
TEST(CIDFrom, IsHalfAMetreAcrossACorner)
{
  Points corner;
  for (int i = 0; i <= 64; ++i)
    for (int k = 0; k <= 64; ++k) {
      const float along = static_cast<float>(i) / 32.0f;
      const float across = static_cast<float>(k) / 32.0f;
      corner.emplace_back(along, across, 0.0f);
      corner.emplace_back(0.0f, across, along);
    }
  const DistanceField field(corner);
  const Points ends{{0.0f, 1.0f, 1.0f}, {2.0f, 1.0f, 0.0f}, {1.0f, 1.0f, 0.0f}};
  const std::vector<float> cids = cidFrom(field, {1.0f, 1.0f, 0.0f}, ends, 101);
  EXPECT_FLOAT_EQ(cids[0], 0.5f);
  EXPECT_LE(cids[1], 0.5f / 32.0f); // half of the spacing
  EXPECT_EQ(cids[2], 0.0f);
}

TEST(CIDFrom, TakesPointsOffTheSurfaceAndNoneAtAll)
{
  const DistanceField field(Points{{0.0f, 0.0f, 0.0f}});
  EXPECT_EQ(cidFrom(field, {0.0f, 3.0f, 4.0f}, {{0.0f, 0.0f, 1.0f}}, 100),
            std::vector<float>{5.0f});
  EXPECT_TRUE(cidFrom(field, {0.0f, 0.0f, 0.0f}, {}, 100).empty());
}

TEST(CIDFrom, RefusesSamplesOutOfRange)
{
  const Points points{{0.0f, 0.0f, 0.0f}};
  const DistanceField field(points);
  EXPECT_THROW(cidFrom(field, points[0], points, min_samples - 1), CIDException);
  EXPECT_THROW(cidFrom(field, points[0], points, max_samples + 1), CIDException);
}

TEST(CIDFromThreads, GiveTheSameBits)
{
  const Points points = twoBoxes(3000, 5);
  const DistanceField field(points);
  const std::vector<float> expected =
      cidFrom(field, points[7], points, 100, onThreads(1));
  for (const unsigned int threads : {2u, 3u, 8u})
    EXPECT_EQ(cidFrom(field, points[7], points, 100, onThreads(threads)), expected);
}

TEST(CIDFromThreads, CancelAndReportProgress)
{
  const Points points = twoBoxes(3000, 5);
  const DistanceField field(points);
  ExecutionOptions execution = onThreads(2);
  double last = 0.0;
  execution.progress = [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return true;
  };
  cidFrom(field, points[0], points, 100, execution);
  EXPECT_EQ(last, 1.0);
  execution.progress = [](double) { return false; };
  EXPECT_THROW(cidFrom(field, points[0], points, 100, execution), CIDCancelled);
}

} // namespace
} // namespace pcl_cid::test
