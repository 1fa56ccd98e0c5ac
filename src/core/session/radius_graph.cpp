/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which points of a scan are neighbors.
 */

#include "base/parallel_for.h"
#include "scan/nearest_neighbors.h"

#include "radius_graph.h"

#include <algorithm>
#include <utility>

namespace pcl_cid {
namespace {

/** The radius of a point, in local spacings. */
constexpr float spacings = 2.0f;

/** Points that a thread takes at a time. */
constexpr std::size_t points_at_a_time = 256;

/** Call `take(index, squared distance)` for the points below a node within a squared
 *  radius of p. */
template <typename Take>
void
visitBall(const BlockTree& tree,
          std::size_t node,
          const Eigen::Array4f& p,
          float squared_radius,
          const Take& take)
{
  if (tree.box(node).squaredDistance(p) > squared_radius * rounding::widening)
    return;
  if (!tree.isBlock(node)) {
    visitBall(tree, 2 * node, p, squared_radius, take);
    visitBall(tree, 2 * node + 1, p, squared_radius, take);
    return;
  }
  const PointBlock& block = tree.block(node - tree.size());
  const auto squared = block.squaredDistances(p.matrix().head<3>());
  for (int row = 0; row < block.count; ++row)
    if (squared[row] <= squared_radius)
      take(static_cast<std::size_t>(block.index[row]), squared[row]);
}

/** The squared radius of each point, metres squared. */
std::vector<float>
squaredRadii(const Points& points, const ExecutionOptions& execution)
{
  const NearestNeighbors neighbors(points, execution);
  std::vector<float> radii;
  radii.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float radius = spacings * neighbors.reach(i);
    radii.push_back(radius * radius);
  }
  return radii;
}

} // namespace

RadiusGraph::RadiusGraph(const Points& points,
                         const BlockTree& tree,
                         const ExecutionOptions& execution)
: earlier_(points.size())
{
  const std::vector<float> radius = squaredRadii(points, partOf(execution, 0.0, 0.5));
  Progress progress(execution.progress);
  const auto connect = [&](std::size_t begin, std::size_t end) {
    pcl::Indices earlier;
    for (std::size_t i = begin; i < end; ++i) {
      earlier.clear();
      visitBall(
          tree, 1, padded(points[i]), radius[i], [&](std::size_t j, float squared) {
            if (j < i && squared <= radius[j])
              earlier.push_back(static_cast<pcl::index_t>(j));
          });
      earlier_[i] = earlier; // a copy has no more room than it needs
    }
  };
  parallelFor(points.size(),
              points_at_a_time,
              threadCount(execution.threads),
              progress,
              {0.5, 1.0},
              connect);
}

} // namespace pcl_cid
