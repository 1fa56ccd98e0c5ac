/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Samples of hulls: where they should be, and evenly.
 */

#include "hull/hull_mesh.h"
#include "hull/hull_samples.h"
#include "hulls.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

constexpr std::size_t sample_count = 3000;

TEST(HullSamples, LieOnTheSurfaceOrInside)
{
  for (const NamedPoints& cloud : allClouds()) {
    const TriangleMesh hull = partOf(cloud.points).hull;
    const double tolerance = hull_tolerance * diagonalOf(hull);
    const auto on_surface = surfaceSamples(hull, sample_count);
    ASSERT_EQ(on_surface.size(), sample_count);
    for (const Eigen::Vector3d& x : on_surface)
      EXPECT_NEAR(excess(hull, x), 0.0, tolerance) << cloud.name;
    const auto inside = volumeSamples(hull, sample_count);
    ASSERT_EQ(inside.size(), sample_count);
    for (const Eigen::Vector3d& x : inside)
      EXPECT_LE(excess(hull, x), tolerance) << cloud.name;
  }
}

/** A box from the origin to (4, 2, 1). */
TriangleMesh
box()
{
  Points corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? 4.0f : 0.0f, i & 2 ? 2.0f : 0.0f, i & 4 ? 1.0f : 0.0f);
  return partOf(corners).hull;
}

TEST(HullSamples, OnTheSurfaceEachRegionHasItsShareByArea)
{
  const double area = 2.0 * (8.0 + 4.0 + 2.0);
  const auto samples = surfaceSamples(box(), sample_count);
  const auto share = [&](const auto& is_in) {
    return static_cast<double>(std::count_if(samples.begin(), samples.end(), is_in)) /
           static_cast<double>(sample_count);
  };
  EXPECT_NEAR(share([](const auto& x) { return x.z() > 0.9999; }), 8.0 / area, 1e-3);
  EXPECT_NEAR(share([](const auto& x) { return x.x() < 1e-4; }), 2.0 / area, 1e-3);
  const auto quarter = [](const auto& x) {
    return x.z() > 0.9999 && x.x() < 2.0 && x.y() > 1.0;
  };
  EXPECT_NEAR(share(quarter), 2.0 / area, 5e-3);
}

TEST(HullSamples, InsideEachRegionHasItsShareByVolume)
{
  const auto samples = volumeSamples(box(), sample_count);
  for (const Eigen::Vector3d& corner :
       {Eigen::Vector3d(1.0, 1.0, 0.5), Eigen::Vector3d(4.0, 0.5, 1.0)}) {
    const auto count =
        std::count_if(samples.begin(), samples.end(), [&](const auto& x) {
          return (x.array() < corner.array()).all();
        });
    EXPECT_NEAR(static_cast<double>(count) / static_cast<double>(sample_count),
                corner.prod() / 8.0,
                1e-2);
  }
}

TEST(HullSamples, CubeSamplesFillEveryCell)
{
  constexpr int side = 8;
  std::vector<int> count(side * side * side, 0);
  for (std::size_t n = 0; n < 8 * count.size(); ++n) {
    const Eigen::Vector3i cell = (side * evenInCube(n)).cast<int>();
    ++count[static_cast<std::size_t>((cell.x() * side + cell.y()) * side + cell.z())];
  }
  const auto [least, most] = std::minmax_element(count.begin(), count.end());
  EXPECT_GE(*least, 1); // 8 on average; independent draws would leave some empty
  EXPECT_LE(*most, 24);
}

} // namespace
} // namespace pcl_cid::test
