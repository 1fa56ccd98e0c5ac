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

#include <memory>
#include <mutex>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief Makes groups connected (*ours*): what hangs together on the surface with its
 *  seed stays, every other piece of a group, an *island*, goes to a group next to it.
 *
 *  Islands are taken in the order of the least cost of a seed and a point of the island
 *  that is next to the seed's group, the cheapest first; what they join makes further
 *  islands adjacent. An island that no group comes next to stays where it is. The
 *  result depends on the groups, the seeds and the costs alone, not on what came before
 *  nor on the threads.
 *
 *  From click to click most islands stay as they are: they are kept, and those are
 *  found again that a change touches.
 *  \note Thread safety: connect() may be called concurrently. One call at a time has
 *  the islands that are kept, any other one begins with none.
 *  \note Memory: at most about 50 bytes a point for islands, and as much for costs. */
class ConnectedGroups {
public:
  /** \param[in] graph of the points; must outlive this
   *  \param[in] points must outlive this
   *  \param[in] samples M */
  ConnectedGroups(const SurfaceGraph& graph, const WorkingPoints& points, int samples);
  ~ConnectedGroups();

  /** \param[in] seeds by number, indices among the points; without any, groups stay as
   *  they are
   *  \param[in] groups the number of the seed of each point; that of a seed is its own
   *  \param[in] threads as from threadCount()
   *  \throws CIDCancelled
   *  \note Cost: a look at each point, and the search for the islands that changed; the
   *  first time for all, O(N) beside the costs of points where they border on groups.
   */
  std::vector<pcl::index_t>
  connect(const pcl::Indices& seeds,
          std::vector<pcl::index_t> groups,
          int threads,
          Progress& progress);

private:
  class Connection;

  std::unique_ptr<Connection>
  exchange(std::unique_ptr<Connection> connection);

  const SurfaceGraph& graph_;
  KnownCosts costs_;
  std::mutex mutex_;
  /** Null while a call has it, and where none is kept. */
  std::unique_ptr<Connection> last_;
};

} // namespace pcl_cid
