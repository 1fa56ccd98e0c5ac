/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A local frame: the way there and back.
 */

#include <pcl_cid/core/frame.h>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

TEST(FrameTest, IsThatOfTheFileUnlessMoved)
{
  const Eigen::Vector3d p(0.1, -2.0, 3.0);
  EXPECT_EQ(Frame().toLocal(p), p);
  EXPECT_EQ(Frame().toFile(p), p);
}

TEST(FrameTest, KeepsMillimetersFarAway)
{
  const Frame frame{{524288.0, 4194304.0, 0.0}};
  const Eigen::Vector3d p(524289.001, 4194306.002, 0.003);
  const Eigen::Vector3f local = frame.toLocal(p).cast<float>();
  EXPECT_NEAR(local.x(), 1.001, 1e-6);
  EXPECT_NEAR((frame.toFile(local.cast<double>()) - p).norm(), 0.0, 1e-6);
}

} // namespace
} // namespace pcl_cid::test
