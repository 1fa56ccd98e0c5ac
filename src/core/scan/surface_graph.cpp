/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which points are next to each other on the surface.
 */

#include "surface_graph.h"

#include <algorithm>

namespace pcl_cid {
namespace {

/** Times the distance of the last near neighbor, which is about 1.6 spacings of an even
 *  surface: edges of three spacings. */
constexpr float longest_edge = 2.0f;

} // namespace

SurfaceGraph::SurfaceGraph(const Points& points, const NearestNeighbors& neighbors)
{
  const std::size_t edges = std::min(most_edges, neighbors.count());
  begin_.reserve(points.size() + 1);
  ends_.reserve(points.size() * edges);
  for (std::size_t i = 0; i < points.size(); ++i) {
    begin_.push_back(ends_.size());
    if (neighbors.firstAt(i) != static_cast<pcl::index_t>(i))
      ends_.push_back(neighbors.firstAt(i));
    const float longest = longest_edge * neighbors.reach(i);
    for (std::size_t k = 0; k < edges; ++k) {
      const pcl::index_t q = neighbors.neighbor(i, k);
      if ((points[i] - points[static_cast<std::size_t>(q)]).norm() > longest)
        break; // they are in the order of their distances
      ends_.push_back(q);
    }
  }
  begin_.push_back(ends_.size());
}

} // namespace pcl_cid
