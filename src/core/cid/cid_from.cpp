/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID from one point to many, block by block of neighbors.
 */

#include <pcl_cid/core/cid_from.h>
#include <pcl_cid/core/settings.h>

#include "base/parallel_for.h"
#include "base/requirements.h"
#include "field/block_tree.h"
#include "segment_search.h"

#include <limits>

namespace pcl_cid {
namespace {

constexpr float no_limit = std::numeric_limits<float>::infinity();
/** Blocks that a thread takes at a time. */
constexpr std::size_t grain = 8;
/** Share of the work that is the tree. */
constexpr double tree_share = 0.05;

} // namespace

std::vector<float>
cidFrom(const DistanceField& field,
        const Eigen::Vector3f& p,
        const Points& points,
        int samples,
        const ExecutionOptions& execution)
{
  require(setting::samples, samples);
  if (points.empty())
    return {};
  const SampleOrder order(samples);
  const int threads = threadCount(execution.threads);
  Progress progress(execution.progress);
  const BlockTree tree(points, threads, progress);

  std::vector<float> cids(points.size());
  const auto visit = [&](std::size_t begin, std::size_t end) {
    SegmentSearch search(field, order);
    std::size_t hint = order.last() / 2;
    for (std::size_t number = begin; number < end; ++number) {
      const PointBlock& block = tree.block(number);
      for (int row = 0; row < block.count; ++row)
        cids[static_cast<std::size_t>(block.index[row])] =
            search.pointCID({p, block.point(row), false}, no_limit, hint); // Eq. 2
    }
  };
  parallelFor(tree.size(), grain, threads, progress, {tree_share, 1.0}, visit);
  return cids;
}

} // namespace pcl_cid
