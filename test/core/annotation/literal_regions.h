/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Where a simulated annotator clicks, as it is defined.
 */

#pragma once

#include "annotation/wrong_regions.h"
#include "scan/nearest_neighbors.h"
#include "session/inmost_point.h"

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

namespace pcl_cid::test {

/** Rounded as the library rounds it, so that equal is equal. */
inline float
squaredBetween(const Eigen::Vector3f& p, const Eigen::Vector3f& q)
{
  const Eigen::Vector3f d = p - q;
  return (d.x() * d.x() + d.y() * d.y()) + d.z() * d.z();
}

/** All pairs that are within two local spacings of each other. */
inline std::vector<std::set<std::size_t>>
literalNeighbors(const Points& points)
{
  const NearestNeighbors nearest(points, {1, {}});
  std::vector<std::set<std::size_t>> neighbors(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < points.size(); ++j) {
      const float radius = 2.0f * std::min(nearest.reach(i), nearest.reach(j));
      if (i != j && squaredBetween(points[i], points[j]) <= radius * radius)
        neighbors[i].insert(j);
    }
  return neighbors;
}

/** By flooding from every point. */
inline pcl::Indices
literalWrongRegion(const std::vector<std::set<std::size_t>>& neighbors,
                   const Labels& truth,
                   const Labels& labels)
{
  std::set<std::size_t> largest;
  for (std::size_t start = 0; start < truth.size(); ++start) {
    if (truth[start] == 0 || truth[start] == labels[start])
      continue;
    std::set<std::size_t> flooded{start};
    std::vector<std::size_t> open{start};
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      for (const std::size_t j : neighbors[i])
        if (truth[j] == truth[start] && labels[j] == labels[start] &&
            flooded.insert(j).second)
          open.push_back(j);
    }
    if (flooded.size() > largest.size())
      largest = flooded;
  }
  return {largest.begin(), largest.end()};
}

inline InmostPoint
literalInmostPoint(const Points& points, const pcl::Indices& region)
{
  const std::set<pcl::index_t> inside(region.begin(), region.end());
  InmostPoint best;
  for (const pcl::index_t point : region) {
    float nearest = std::numeric_limits<float>::infinity();
    for (std::size_t j = 0; j < points.size(); ++j)
      if (inside.count(static_cast<pcl::index_t>(j)) == 0)
        nearest = std::min(
            nearest,
            squaredBetween(points[static_cast<std::size_t>(point)], points[j]));
    if (nearest > best.squared_distance)
      best = {point, nearest};
  }
  return best;
}

} // namespace pcl_cid::test
