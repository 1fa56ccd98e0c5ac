/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Farthest-first sampling in Euclidean distance: what CID is compared with.
 */

#pragma once

#include <pcl_cid/core/point_set.h>

#include <cstddef>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid::benchmarks {

/** \brief Seeds in the order they were chosen, and the nearest seed of each point. */
struct EuclideanSample {
  pcl::Indices seeds;
  std::vector<pcl::index_t> group;
};

/** \brief Algorithm 1 with the Euclidean distance in the place of CID: the point that
 *  is farthest from all seeds becomes the next one, at equal distance the one of lowest
 *  index; a duplicate of a seed never does. At equal distance the earlier seed keeps a
 *  point.
 *  \param[in] points at least 1
 *  \param[in] start index of the first seed
 *  \param[in] seeds K, at least 1; fewer come back when there are fewer distinct points
 *  \note Cost: K N distances. */
EuclideanSample
sampleFarthestFirst(const Points& points, pcl::index_t start, std::size_t seeds);

} // namespace pcl_cid::benchmarks
