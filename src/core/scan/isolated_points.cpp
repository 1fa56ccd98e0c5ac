/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Isolated points: those with too few others near them.
 */

#include "base/requirements.h"

#include "isolated_points.h"
#include <pcl_cid/core/settings.h>

#include <algorithm>
#include <array>

namespace pcl_cid {
namespace {

/** The spacing that the neighbors of a point have among themselves. */
float
spacingAround(const NearestNeighbors& neighbors, std::size_t point)
{
  std::array<float, NearestNeighbors::most_near> reaches;
  for (std::size_t k = 0; k < reaches.size(); ++k)
    reaches[k] =
        neighbors.reach(static_cast<std::size_t>(neighbors.neighbor(point, k)));
  const auto middle = reaches.begin() + reaches.size() / 2;
  std::nth_element(reaches.begin(), middle, reaches.end());
  return *middle;
}

} // namespace

pcl::Indices
isolatedPoints(const Points& points, const NearestNeighbors& neighbors, int least)
{
  require(setting::isolated_neighbors, least);
  pcl::Indices isolated;
  if (least == 0 || neighbors.nearCount() < NearestNeighbors::most_near)
    return isolated;
  const auto last = static_cast<std::size_t>(least) - 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto q = static_cast<std::size_t>(neighbors.neighbor(i, last));
    if ((points[i] - points[q]).norm() > isolation_radius * spacingAround(neighbors, i))
      isolated.push_back(static_cast<pcl::index_t>(i));
  }
  return isolated;
}

} // namespace pcl_cid
