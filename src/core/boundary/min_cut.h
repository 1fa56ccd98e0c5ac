/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A minimum cut of a graph with a source and a sink.
 */

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief A graph whose nodes are tied to a source or to a sink, and to each other. */
struct CutGraph {
  /** Two nodes; the same capacity both ways, 0 or more. */
  struct Edge {
    std::size_t first;
    std::size_t second;
    std::int64_t capacity;
  };

  /** Of each node: the capacity from the source, or, below 0, less that to the sink. */
  std::vector<std::int64_t> from_source;
  std::vector<Edge> edges;
};

/** \brief The nodes on the side of the source of a minimum cut. Of several such cuts it
 *  is the one with the fewest nodes there, which is a part of each other one: what
 *  still can be reached from the source once the flow is as large as it can be.
 *  \note Cost: Boykov and Kolmogorov's maximum flow, in practice about linear. */
std::vector<bool>
smallestSourceSide(const CutGraph& graph);

} // namespace pcl_cid
