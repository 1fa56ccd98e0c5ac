/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How far apart the points of a cloud are, from place to place.
 */

#include "base/requirements.h"

#include "local_spacing.h"
#include <pcl_cid/core/settings.h>

#include <algorithm>
#include <cmath>

namespace pcl_cid {
namespace {

/** Share of the points that are sparse enough to be stray. */
constexpr double stray_share = 0.02;

double
areaOf(float reach)
{
  return static_cast<double>(reach) * static_cast<double>(reach);
}

/** Reaches of the points that count, ascending. */
std::vector<float>
reachesThatCount(const NearestNeighbors& neighbors, const pcl::Indices& isolated)
{
  std::vector<float> reaches;
  auto next_isolated = isolated.begin();
  for (std::size_t i = 0; i < neighbors.size(); ++i)
    if (next_isolated != isolated.end() &&
        static_cast<std::size_t>(*next_isolated) == i)
      ++next_isolated;
    else
      reaches.push_back(neighbors.reach(i));
  std::sort(reaches.begin(), reaches.end());
  const auto stray =
      static_cast<std::size_t>(stray_share * static_cast<double>(reaches.size()));
  reaches.resize(reaches.size() - stray);
  return reaches;
}

/** Of ascending spacings, the one that this share of the area does not exceed. */
float
quantileByArea(const std::vector<float>& ascending, double total, double share)
{
  double area = 0.0;
  for (const float reach : ascending) {
    area += areaOf(reach);
    if (area >= share * total)
      return reach;
  }
  return ascending.back();
}

} // namespace

float
medianReach(const NearestNeighbors& neighbors)
{
  std::vector<float> reaches;
  for (std::size_t i = 0; i < neighbors.size(); ++i)
    reaches.push_back(neighbors.reach(i));
  if (reaches.empty())
    return 0.0f;
  const auto middle = reaches.begin() + (reaches.size() - 1) / 2;
  std::nth_element(reaches.begin(), middle, reaches.end());
  return *middle;
}

std::vector<float>
localSpacing(const NearestNeighbors& neighbors, float power)
{
  require(setting::density_power, power);
  std::vector<float> spacing(neighbors.size(), 1.0f);
  const float median = medianReach(neighbors);
  if (!(median > 0.0f) || power == 0.0f)
    return spacing;
  for (std::size_t i = 0; i < spacing.size(); ++i) {
    const float relative =
        std::clamp(neighbors.reach(i) / median, least_spacing, most_spacing);
    spacing[i] = power == 1.0f ? relative : std::pow(relative, power);
  }
  return spacing;
}

float
spacingSpread(const NearestNeighbors& neighbors, const pcl::Indices& isolated)
{
  const std::vector<float> ascending = reachesThatCount(neighbors, isolated);
  double total = 0.0;
  for (const float reach : ascending)
    total += areaOf(reach);
  if (!(total > 0.0))
    return 1.0f;
  return quantileByArea(ascending, total, 0.9) / quantileByArea(ascending, total, 0.1);
}

} // namespace pcl_cid
