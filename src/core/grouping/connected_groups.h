/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Groups in one piece.
 */

#pragma once

#include "known_costs.h"

#include "scan/surface_graph.h"

#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief Make groups connected (*ours*): what hangs together on the surface with its
 *  seed stays, every other piece of a group, an *island*, goes to a group next to it.
 *
 *  Islands are taken in the order of the least cost of a seed and a point of the island
 *  that is next to the seed's group, the cheapest first; what they join makes further
 *  islands adjacent. An island that no group comes next to stays where it is. A
 * function of the groups, the seeds and the costs alone: of no history, and no threads.
 *  \param[in] graph of the points
 *  \param[in,out] costs of pairs of the points
 *  \param[in] seeds by number, indices among the points
 *  \param[in] groups the number of the seed of each point; that of a seed is its own
 *  \param[in] threads as from threadCount()
 *  \throws CIDCancelled
 *  \note Cost: O(N) beside the costs of points where islands border on groups. */
std::vector<pcl::index_t>
connectGroups(const SurfaceGraph& graph,
              KnownCosts& costs,
              const pcl::Indices& seeds,
              std::vector<pcl::index_t> groups,
              int threads,
              Progress& progress);

} // namespace pcl_cid
