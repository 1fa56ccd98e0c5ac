/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID the literal way: Eq. 2 with one tree query a sample.
 */

#include "literal_method.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_cid::benchmarks {

LiteralMethod::LiteralMethod(const Cloud::ConstPtr& surface, int samples)
: samples_(samples)
{
  tree_.setInputCloud(surface);
}

float
LiteralMethod::pointCID(const pcl::PointXYZ& p, const pcl::PointXYZ& q) const
{
  thread_local pcl::Indices nearest(1);
  thread_local std::vector<float> squared_distance(1);
  float largest = 0.0f;
  for (int l = 0; l < samples_; ++l) {
    const float t = static_cast<float>(l) / static_cast<float>(samples_ - 1);
    const pcl::PointXYZ x(
        p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t, p.z + (q.z - p.z) * t);
    tree_.nearestKSearch(x, 1, nearest, squared_distance);
    largest = std::max(largest, squared_distance[0]);
  }
  return std::sqrt(largest);
}

} // namespace pcl_cid::benchmarks
