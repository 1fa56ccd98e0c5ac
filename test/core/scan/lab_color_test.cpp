/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * L*a*b* against published values, and smooth.
 */

#include "scan/lab_color.h"

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

void
expectLab(const ColorRGB& color, float l, float a, float b)
{
  const Eigen::Vector3f lab = labOf(color);
  // The published values know the matrix to more digits than the standard.
  constexpr float tolerance = 0.02f;
  EXPECT_NEAR(lab.x(), l, tolerance);
  EXPECT_NEAR(lab.y(), a, tolerance);
  EXPECT_NEAR(lab.z(), b, tolerance);
}

/// The primaries of sRGB, whose L*a*b* is found in many tables.
TEST(LabColor, IsAsPublished)
{
  expectLab({255, 0, 0}, 53.2408f, 80.0925f, 67.2032f);
  expectLab({0, 255, 0}, 87.7347f, -86.1827f, 83.1793f);
  expectLab({0, 0, 255}, 32.2970f, 79.1875f, -107.8602f);
}

/// By hand: a grey of 128 lets ((128 / 255 + 0.055) / 1.055)^2.4 = 0.215861 of the
/// light through, so L* = 116 cbrt(0.215861) - 16 = 53.585; one of 2 lets
/// 2 / 255 / 12.92 = 0.000607 through, so L* = 116 (0.000607 841 / 108) = 0.5483.
TEST(LabColor, OfGreysIsLightnessOnly)
{
  expectLab({255, 255, 255}, 100.0f, 0.0f, 0.0f);
  expectLab({128, 128, 128}, 53.585f, 0.0f, 0.0f);
  expectLab({2, 2, 2}, 0.5483f, 0.0f, 0.0f);
  expectLab({0, 0, 0}, 0.0f, 0.0f, 0.0f);
}

/// By hand: ten points in a row, of which the first is white and the others black. An
/// end's neighbors are the next eight, so the mean of the first is 100 / 9, and the
/// last does not see it.
TEST(SmoothLab, IsTheMeanOfAPointAndItsNeighbors)
{
  Points row;
  std::vector<ColorRGB> colors(10, ColorRGB{0, 0, 0});
  colors.front() = {255, 255, 255};
  for (int i = 0; i < 10; ++i)
    row.emplace_back(static_cast<float>(i), 0.0f, 0.0f);
  const auto lab = smoothLab(colors, NearestNeighbors(row, {}));
  ASSERT_EQ(lab.size(), 10u);
  EXPECT_FLOAT_EQ(lab.front().x(), 100.0f / 9.0f);
  EXPECT_EQ(lab.back().x(), 0.0f);
}

TEST(SmoothLab, OfOnePointIsItsOwn)
{
  const std::vector<ColorRGB> colors{{10, 200, 30}};
  const auto lab = smoothLab(colors, NearestNeighbors({{1.0f, 2.0f, 3.0f}}, {}));
  EXPECT_EQ(lab.front(), labOf(colors.front()));
}

} // namespace
} // namespace pcl_cid::test
