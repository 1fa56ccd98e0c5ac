/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What several methods need.
 */

#include "peer_method.h"

#include "base/random.h"
#include <pcl_cid/core/distance_field.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>

#include <pcl/kdtree/kdtree_flann.h>

namespace pcl_cid::benchmarks {

pcl::index_t
drawStart(const PeerScan& scan, std::uint64_t random_seed)
{
  RandomGenerator generator(random_seed);
  return static_cast<pcl::index_t>(drawBelow(generator, scan.cloud->size()));
}

std::vector<std::uint32_t>
labelsOfGroups(const std::vector<pcl::index_t>& group)
{
  std::vector<std::uint32_t> labels;
  for (const pcl::index_t k : group)
    labels.push_back(static_cast<std::uint32_t>(k + 1));
  return labels;
}

double
pointSpacing(const Cloud& cloud)
{
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud.makeShared());
  pcl::Indices neighbors;
  std::vector<float> squared;
  std::vector<float> nearest;
  for (const pcl::PointXYZ& point : cloud)
    if (tree.nearestKSearch(point, 2, neighbors, squared) == 2)
      nearest.push_back(squared[1]);
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  if (nearest.empty() || *middle <= 0.0f)
    throw CIDException("the scan has no spacing: most of its points are equal, and the "
                       "lengths of the peers' settings are multiples of it");
  return std::sqrt(*middle);
}

void
labelTheRest(const Cloud& cloud, std::vector<std::uint32_t>& labels)
{
  Points labelled;
  std::vector<std::uint32_t> known;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != 0) {
      labelled.emplace_back(cloud[i].getVector3fMap());
      known.push_back(labels[i]);
    }
  if (labelled.empty() || labelled.size() == labels.size())
    return;
  DistanceField::Options options;
  options.execution.threads = 1; // the next measurement forks this process
  const DistanceField field(labelled, options);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == 0)
      labels[i] =
          known[static_cast<std::size_t>(field.nearest(cloud[i].getVector3fMap()))];
}

} // namespace pcl_cid::benchmarks
