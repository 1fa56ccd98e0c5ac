/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Noise and thinning: as much as was asked for, and nothing else.
 */

#include <cmath>

#include <gtest/gtest.h>

#include <pcl_cid/exceptions.h>

#include "cloud_files.h"
#include "perturbation.h"

namespace pcl_cid::test {
namespace {

constexpr std::size_t points = 20000;

/// All points at one place, in float x, double y and z, each with its number.
pcl::PCLPointCloud2
stack()
{
  pcl::PCLPointCloud2 cloud;
  std::vector<std::uint32_t> number(points);
  for (std::size_t i = 0; i < points; ++i)
    number[i] = static_cast<std::uint32_t>(i);
  appendField("number", number, cloud);
  appendField("x", std::vector<float>(points, 1.0f), cloud);
  appendField("y", std::vector<double>(points, -2.0), cloud);
  appendField("z", std::vector<double>(points, 500000.0), cloud);
  return cloud;
}

std::vector<std::uint32_t>
numbersIn(const pcl::PCLPointCloud2& cloud)
{
  std::vector<std::uint32_t> numbers(std::size_t{cloud.width} * cloud.height);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    std::memcpy(&numbers[i], &cloud.data[i * cloud.point_step], sizeof(numbers[i]));
  return numbers;
}

/// Shifts along y, where rounding is far below them.
std::vector<double>
shiftsIn(const pcl::PCLPointCloud2& cloud)
{
  std::vector<double> shifts(std::size_t{cloud.width} * cloud.height);
  for (std::size_t i = 0; i < shifts.size(); ++i) {
    std::memcpy(&shifts[i],
                &cloud.data[i * cloud.point_step + cloud.fields[2].offset],
                sizeof(double));
    shifts[i] += 2.0;
  }
  return shifts;
}

TEST(Perturbation, OfNothingChangesNothing)
{
  pcl::PCLPointCloud2 cloud = stack();
  cloud.width = points / 100;
  cloud.height = 100;
  const pcl::PCLPointCloud2 result = perturbed(cloud, {});
  EXPECT_EQ(result.data, cloud.data);
  EXPECT_EQ(result.height, 100u);
}

TEST(Perturbation, NoiseHasTheDeviationAskedFor)
{
  const double noise = 0.01;
  const pcl::PCLPointCloud2 result = perturbed(stack(), {noise, 1.0, 3});
  EXPECT_EQ(numbersIn(result), numbersIn(stack()));
  double sum = 0.0;
  double squares = 0.0;
  for (const double shift : shiftsIn(result)) {
    sum += shift;
    squares += shift * shift;
  }
  // Five standard errors: of a mean, and of a variance of normal draws.
  const double count = points;
  EXPECT_NEAR(sum / count, 0.0, 5 * noise / std::sqrt(count));
  EXPECT_NEAR(
      squares / count, noise * noise, 5 * noise * noise * std::sqrt(2.0 / count));
}

TEST(Perturbation, MovesInProportionWhateverIsKept)
{
  const std::vector<double> all = shiftsIn(perturbed(stack(), {0.01, 1.0, 3}));
  const pcl::PCLPointCloud2 thin = perturbed(stack(), {0.03, 0.2, 3});
  const std::vector<double> few = shiftsIn(thin);
  const std::vector<std::uint32_t> kept = numbersIn(thin);
  for (std::size_t i = 0; i < kept.size(); ++i)
    EXPECT_NEAR(few[i], 3 * all[kept[i]], 1e-12);
}

TEST(Perturbation, KeepsTheShareAskedForInOrder)
{
  const double count = points;
  std::vector<std::uint32_t> more = numbersIn(stack());
  for (const double keep : {0.9, 0.5, 0.1}) {
    const pcl::PCLPointCloud2 thin = perturbed(stack(), {0.0, keep, 4});
    const std::vector<std::uint32_t> kept = numbersIn(thin);
    EXPECT_NEAR(static_cast<double>(kept.size()),
                keep * count,
                5 * std::sqrt(keep * (1 - keep) * count));
    EXPECT_EQ(thin.data.size(), kept.size() * thin.point_step);
    EXPECT_TRUE(std::includes(more.begin(), more.end(), kept.begin(), kept.end()));
    more = kept;
  }
}

TEST(Perturbation, DependsOnTheSeed)
{
  EXPECT_NE(perturbed(stack(), {0.01, 1.0, 3}).data,
            perturbed(stack(), {0.01, 1.0, 4}).data);
}

TEST(Perturbation, RefusesCloudsWithoutCoordinatesOrPointsLeft)
{
  pcl::PCLPointCloud2 flat;
  appendField("x", std::vector<float>(3, 0.0f), flat);
  appendField("y", std::vector<float>(3, 0.0f), flat);
  EXPECT_THROW(perturbed(flat, {}), CIDException);
  appendField("z", std::vector<std::int32_t>(3, 0), flat);
  EXPECT_THROW(perturbed(flat, {}), CIDException);
  EXPECT_THROW(perturbed(stack(), {0.0, 1e-12, 0}), CIDException);
}

} // namespace
} // namespace pcl_cid::test
