/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Farthest-first sampling in Euclidean distance: what CID is compared with.
 */

#include "euclidean_sampling.h"

#include <algorithm>
#include <limits>

namespace pcl_cid::benchmarks {

EuclideanSample
sampleFarthestFirst(const Points& points, pcl::index_t start, std::size_t seeds)
{
  EuclideanSample sample;
  sample.group.assign(points.size(), 0);
  std::vector<float> squared(points.size(), std::numeric_limits<float>::infinity());
  pcl::index_t next = start;
  do {
    const auto number = static_cast<pcl::index_t>(sample.seeds.size());
    const Eigen::Vector3f seed = points[static_cast<std::size_t>(next)];
    sample.seeds.push_back(next);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (const float d = (points[i] - seed).squaredNorm(); d < squared[i]) {
        squared[i] = d;
        sample.group[i] = number;
      }
    const auto farthest = std::max_element(squared.begin(), squared.end());
    if (*farthest == 0.0f)
      break;
    next = static_cast<pcl::index_t>(farthest - squared.begin());
  } while (sample.seeds.size() < seeds);
  return sample;
}

} // namespace pcl_cid::benchmarks
