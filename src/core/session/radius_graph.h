/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which points of a scan are neighbors.
 */

#pragma once

#include "field/block_tree.h"

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/point_set.h>

#include <cstddef>
#include <vector>

namespace pcl_cid {

/** \brief The points as a graph: two are neighbors when each is within two local
 *  spacings of the other. The local spacing is the distance to the eighth place (see
 *  NearestNeighbors), so the graph follows the density, and a stray point joins
 *  nothing that is dense. Unlike SurfaceGraph, which has a dozen edges a point, it is
 *  what others measure clicks with: all within a radius. */
class RadiusGraph {
public:
  /** \param[in] points finite, metres
   *  \param[in] tree of these points
   *  \throws CIDCancelled
   *  \note Cost: O(N log N); 4 bytes for each pair of neighbors, and 28 for each
   *  point. */
  RadiusGraph(const Points& points,
              const BlockTree& tree,
              const ExecutionOptions& execution);

  std::size_t
  size() const
  {
    return earlier_.size();
  }

  /** \brief The neighbors of a point whose index is lower than its own, in no order. */
  const pcl::Indices&
  earlierNeighbors(std::size_t point) const
  {
    return earlier_[point];
  }

private:
  std::vector<pcl::Indices> earlier_;
};

} // namespace pcl_cid
