/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Smooth patches of the surface: groups without seeds.
 */

#include "filled_patches.h"
#include "smooth_regions.h"

#include "base/requirements.h"
#include "cid/working_points.h"
#include "scan/nearest_neighbors.h"
#include "scan/working_set.h"

#include <pcl_cid/core/smooth_patches.h>

#include <optional>
#include <utility>

namespace pcl_cid {
SmoothPatches::SmoothPatches(PreparedScan::ConstPtr scan,
                             std::size_t max_patches,
                             const ExecutionOptions& execution)
: scan_(std::move(scan))
{
  if (!scan_)
    throw CIDException("there is no prepared scan to find patches of; give one");
  requireAtLeast("number of patches", max_patches, std::size_t{1});
  const Points& points = scan_->working().points();
  const NearestNeighbors neighbors(
      points, partOf(execution, 0.0, 0.3), NearestNeighbors::most);
  const SurfaceShape shape =
      surfaceShape(points, neighbors, partOf(execution, 0.3, 0.4));
  std::optional<SurfaceGraph> own_graph;
  if (!scan_->graph())
    own_graph.emplace(points, neighbors);
  const SurfaceGraph& graph = own_graph ? *own_graph : *scan_->graph();
  Progress progress(partOf(execution, 0.4, 0.7).progress);
  SmoothRegions largest =
      largestRegions(growRegions(graph, shape, progress), max_patches);
  patches_ = std::move(largest.of_points);
  grown_sizes_ = std::move(largest.sizes);
  fillPatches(graph, points, partOf(execution, 0.7, 1.0), patches_);
}

std::vector<pcl::index_t>
SmoothPatches::groups() const
{
  return scan_->workingSet().carryOn(patches_, scan_->cloudSize(), pcl::index_t{-1});
}

} // namespace pcl_cid
