/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points between patches go to the nearest of them.
 */

#include "filled_patches.h"

#include "base/parallel_for.h"
#include "base/progress.h"

#include <pcl_cid/core/distance_field.h>

#include <functional>
#include <queue>
#include <tuple>

namespace pcl_cid {
namespace {

/** Dijkstra's algorithm from all patches at once. */
class WaysAlongSurface {
public:
  WaysAlongSurface(const SurfaceGraph& graph,
                   const Points& points,
                   std::vector<pcl::index_t>& patches)
  : graph_(graph), points_(points), patches_(patches)
  {
  }

  void
  follow(Progress& progress)
  {
    for (std::size_t p = 0; p < patches_.size(); ++p)
      if (patches_[p] >= 0)
        goOn({0.0f, patches_[p], p});
    while (!ways_.empty()) {
      progress.poll();
      const Way shortest = ways_.top();
      ways_.pop();
      if (patches_[shortest.to] >= 0)
        continue;
      patches_[shortest.to] = shortest.patch;
      goOn(shortest);
    }
  }

private:
  struct Way {
    float length;
    pcl::index_t patch; ///< where it begins
    std::size_t to;     ///< a point

    bool
    operator>(const Way& other) const
    {
      return std::tie(length, patch, to) >
             std::tie(other.length, other.patch, other.to);
    }
  };

  void
  goOn(const Way& way)
  {
    graph_.forEachEdge(graph_.vertexOf(way.to), [&](SurfaceGraph::Vertex vertex) {
      const std::size_t q = graph_.pointOf(vertex);
      if (patches_[q] < 0)
        ways_.push({way.length + (points_[q] - points_[way.to]).norm(), way.patch, q});
    });
  }

  const SurfaceGraph& graph_;
  const Points& points_;
  std::vector<pcl::index_t>& patches_;
  std::priority_queue<Way, std::vector<Way>, std::greater<>> ways_;
};

void
followNearest(const Points& points,
              const ExecutionOptions& execution,
              std::vector<pcl::index_t>& patches)
{
  Points reached;
  std::vector<pcl::index_t> patch_of_reached;
  std::vector<std::size_t> others;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (patches[p] < 0) {
      others.push_back(p);
      continue;
    }
    reached.push_back(points[p]);
    patch_of_reached.push_back(patches[p]);
  }
  if (others.empty())
    return;
  DistanceField::Options options;
  options.execution = execution;
  const DistanceField field(reached, options);
  Progress progress(execution.progress);
  const int threads = threadCount(execution.threads);
  parallelForEach(others.size(), threads, progress, {1.0, 1.0}, [&](std::size_t k) {
    const pcl::index_t nearest = field.nearest(points[others[k]]);
    patches[others[k]] = patch_of_reached[static_cast<std::size_t>(nearest)];
  });
}

} // namespace

void
fillPatches(const SurfaceGraph& graph,
            const Points& points,
            const ExecutionOptions& execution,
            std::vector<pcl::index_t>& patches)
{
  Progress progress(execution.progress);
  WaysAlongSurface(graph, points, patches).follow(progress);
  followNearest(points, execution, patches);
  progress.check(1.0);
}

} // namespace pcl_cid
