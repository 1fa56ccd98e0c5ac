/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points between patches go to the nearest of them.
 */

#pragma once

#include "scan/surface_graph.h"

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/point_set.h>

#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief Give each point that is in no patch to one (*ours*): to the patch with the
 *  shortest way to it along edges of the graph, added up in float from the patch on; of
 *  equally short ways to that of lowest number. What no way leads to goes to the patch
 *  of the nearest of all points that were in one or were reached; at equal distance to
 *  that of lowest number.
 *  \param[in] points of the graph
 *  \param[in,out] patches the number of the patch of each point, -1 for none; at least
 *  one is in a patch
 *  \throws CIDCancelled
 *  \note Cost: O(N log N). */
void
fillPatches(const SurfaceGraph& graph,
            const Points& points,
            const ExecutionOptions& execution,
            std::vector<pcl::index_t>& patches);

} // namespace pcl_cid
