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
#include "field/block_tree.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

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

/** The points that are in patches, by place. */
class PatchedPoints {
public:
  /** \param[in] patches of the points, of lowest number first at equal distance */
  PatchedPoints(const Points& points,
                std::vector<pcl::index_t> patches,
                int threads,
                Progress& progress)
  : tree_(points, threads, progress), patches_(std::move(patches))
  {
  }

  pcl::index_t
  patchOfNearest(const Eigen::Vector3f& p) const
  {
    BlockTree::Nearest nearest;
    tree_.descend(1, padded(p), nearest);
    return lowestPatch(1, p, nearest.squared_distance);
  }

private:
  /** The lowest patch of the points below a node that are at a distance, which is the
   *  least there is. */
  pcl::index_t
  lowestPatch(std::size_t node, const Eigen::Vector3f& p, float squared_distance) const
  {
    if (tree_.box(node).squaredDistance(padded(p)) >
        squared_distance * rounding::widening)
      return none;
    if (!tree_.isBlock(node))
      return std::min(lowestPatch(2 * node, p, squared_distance),
                      lowestPatch(2 * node + 1, p, squared_distance));
    const PointBlock& block = tree_.block(node - tree_.size());
    const auto squared = block.squaredDistances(p);
    pcl::index_t lowest = none;
    for (int row = 0; row < block.count; ++row)
      if (squared[row] == squared_distance)
        lowest = std::min(lowest, patches_[static_cast<std::size_t>(block.index[row])]);
    return lowest;
  }

  static constexpr pcl::index_t none = std::numeric_limits<pcl::index_t>::max();

  BlockTree tree_;
  std::vector<pcl::index_t> patches_;
};

void
followNearest(const Points& points,
              int threads,
              Progress& progress,
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
  const PatchedPoints patched(reached, std::move(patch_of_reached), threads, progress);
  parallelFor(others.size(),
              256,
              threads,
              progress,
              {0.0, 0.0},
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end; ++k)
                  patches[others[k]] = patched.patchOfNearest(points[others[k]]);
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
  followNearest(points, threadCount(execution.threads), progress, patches);
  progress.check(1.0);
}

} // namespace pcl_cid
