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
#include <iterator>

namespace pcl_cid {
namespace {

/** Share of the points that are sparse enough to be stray. */
constexpr double stray_share = 0.02;

/** A region is this share of a scan, and at least so many places in a row. */
constexpr std::size_t regions_of_scan = 400;
constexpr std::size_t least_places_of_region = 192;

/** Even a regular cloud counts as spreading this much within a region. */
constexpr float least_spread = 1.4f;

/** A part of the surface. */
struct Region {
  double area;
  float spacing; ///< the median of its points
  float spread;  ///< of the spacings of its points
};

/** Of values in any order, the one that this share does not exceed; reorders them. */
float
quantileOf(std::vector<float>& values, double share)
{
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(
                                       share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/** Reaches of the places that are not isolated, in the order of the places. */
std::vector<float>
reachesThatCount(const NearestNeighbors& neighbors, const pcl::Indices& isolated)
{
  std::vector<float> reaches;
  for (const pcl::index_t place : neighbors.places())
    if (!std::binary_search(isolated.begin(), isolated.end(), place))
      reaches.push_back(neighbors.reach(static_cast<std::size_t>(place)));
  return reaches;
}

/** Without the largest few, in the same order. */
std::vector<float>
withoutStray(const std::vector<float>& reaches)
{
  const auto stray =
      static_cast<std::size_t>(stray_share * static_cast<double>(reaches.size()));
  std::vector<float> ascending = reaches;
  std::sort(ascending.begin(), ascending.end());
  const float most = ascending[ascending.size() - 1 - stray];
  std::vector<float> kept;
  std::copy_if(reaches.begin(),
               reaches.end(),
               std::back_inserter(kept),
               [most](float reach) { return reach <= most; });
  return kept;
}

/** How many times a larger value is a smaller one; 1 where that is 0. */
float
ratioOf(float larger, float smaller)
{
  return smaller > 0.0f ? larger / smaller : 1.0f;
}

Region
regionOf(std::vector<float> reaches)
{
  double area = 0.0;
  for (const float reach : reaches)
    area += static_cast<double>(reach) * static_cast<double>(reach);
  const float low = quantileOf(reaches, 0.1);
  return {area, quantileOf(reaches, 0.5), ratioOf(quantileOf(reaches, 0.9), low)};
}

std::vector<Region>
regionsOf(const std::vector<float>& reaches)
{
  std::vector<Region> regions;
  const std::size_t step =
      std::max(reaches.size() / regions_of_scan, least_places_of_region);
  for (std::size_t begin = 0; begin < reaches.size(); begin += step) {
    const std::size_t end = std::min(begin + step, reaches.size());
    regions.push_back(regionOf({reaches.begin() + static_cast<std::ptrdiff_t>(begin),
                                reaches.begin() + static_cast<std::ptrdiff_t>(end)}));
  }
  return regions;
}

/** The value of a region that this share of the area does not exceed. */
float
quantileByArea(std::vector<Region> regions, float Region::*value, double share)
{
  std::sort(regions.begin(), regions.end(), [&](const Region& a, const Region& b) {
    return a.*value < b.*value;
  });
  double total = 0.0;
  for (const Region& region : regions)
    total += region.area;
  double area = 0.0;
  for (const Region& region : regions) {
    area += region.area;
    if (area >= share * total)
      return region.*value;
  }
  return regions.back().*value;
}

} // namespace

float
medianReach(const NearestNeighbors& neighbors)
{
  std::vector<float> reaches;
  for (std::size_t i = 0; i < neighbors.size(); ++i)
    reaches.push_back(neighbors.reach(i));
  return reaches.empty() ? 0.0f : quantileOf(reaches, 0.5);
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
  const std::vector<float> reaches = reachesThatCount(neighbors, isolated);
  if (reaches.empty())
    return 0.0f;
  const std::vector<Region> regions = regionsOf(withoutStray(reaches));
  const auto at = [&](float Region::*value, double share) {
    return quantileByArea(regions, value, share);
  };
  const float between = ratioOf(at(&Region::spacing, 0.9), at(&Region::spacing, 0.1));
  return between / std::max(at(&Region::spread, 0.5), least_spread);
}

} // namespace pcl_cid
