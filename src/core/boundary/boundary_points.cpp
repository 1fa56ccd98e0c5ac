/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The points whose labels may change, and to what.
 */

#include "boundary_points.h"

#include "base/rounding.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace pcl_cid {
namespace {

/** Blocks that a thread takes at a time. */
constexpr std::size_t blocks_at_a_time = 64;

/** The labels below a node, without 0; low > high where there is none. */
struct LabelRange {
  std::uint32_t low = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t high = 0;

  void
  take(const LabelRange& other)
  {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }

  /** Whether there is a label other than one of these. */
  bool
  addsTo(const LabelRange& other) const
  {
    return low <= high && !(low == high && other.low == low && other.high == low);
  }
};

float
squaredGap(const PointBox& a, const PointBox& b)
{
  return (a.low - b.high).max(b.low - a.high).max(0.0f).square().sum();
}

/** Looks around blocks; most see one label alone, and are done at once. */
class BoundarySearch {
public:
  BoundarySearch(const WorkingPoints& points,
                 const std::vector<std::uint32_t>& labels,
                 float reach)
  : tree_(points.tree())
  , labels_(labels)
  , squared_reach_(reach * reach)
  , ranges_(2 * tree_.size())
  {
    for (std::size_t b = 0; b < tree_.size(); ++b)
      for (int row = 0; row < tree_.block(b).count; ++row)
        if (const std::uint32_t label = labelOf(b, row))
          ranges_[tree_.nodeOfBlock(b)].take({label, label});
    for (std::size_t node = tree_.size() - 1; node > 0; --node) {
      ranges_[node] = ranges_[2 * node];
      ranges_[node].take(ranges_[2 * node + 1]);
    }
  }

  /** The points of a block that are near a boundary. */
  std::vector<BoundaryPoint>
  ofBlock(std::size_t b) const
  {
    std::vector<BoundaryPoint> found;
    std::vector<std::size_t> near;
    gather(1, tree_.nodeOfBlock(b), near);
    if (near.empty())
      return found;
    for (int row = 0; row < tree_.block(b).count; ++row)
      if (labelOf(b, row) != 0) {
        std::vector<std::uint32_t> labels = labelsAround(b, row, near);
        if (labels.size() > 1)
          found.push_back(
              {static_cast<std::size_t>(tree_.block(b).index[row]), std::move(labels)});
      }
    return found;
  }

private:
  std::uint32_t
  labelOf(std::size_t b, int row) const
  {
    return labels_[static_cast<std::size_t>(tree_.block(b).index[row])];
  }

  /** The blocks below a node that have other labels within reach of a block. */
  void
  gather(std::size_t node, std::size_t from, std::vector<std::size_t>& near) const
  {
    if (!ranges_[node].addsTo(ranges_[from]) ||
        squaredGap(tree_.box(node), tree_.box(from)) >
            squared_reach_ * rounding::widening)
      return;
    if (tree_.isBlock(node)) {
      near.push_back(node - tree_.size());
      return;
    }
    gather(2 * node, from, near);
    gather(2 * node + 1, from, near);
  }

  std::vector<std::uint32_t>
  labelsAround(std::size_t b, int row, const std::vector<std::size_t>& near) const
  {
    std::vector<std::uint32_t> around = {labelOf(b, row)};
    for (const std::size_t other : near) {
      const PointBlock& block = tree_.block(other);
      const auto squared = block.squaredDistances(tree_.block(b).point(row));
      for (int k = 0; k < block.count; ++k) {
        if (squared[k] > squared_reach_)
          continue;
        const std::uint32_t label = labelOf(other, k);
        if (label != 0 &&
            std::find(around.begin(), around.end(), label) == around.end())
          around.push_back(label);
      }
    }
    std::sort(around.begin(), around.end());
    return around;
  }

  const BlockTree& tree_;
  const std::vector<std::uint32_t>& labels_;
  float squared_reach_;
  std::vector<LabelRange> ranges_; ///< by node
};

} // namespace

std::vector<BoundaryPoint>
findBoundaryPoints(const WorkingPoints& points,
                   const std::vector<std::uint32_t>& labels,
                   const std::vector<bool>& fixed,
                   float reach,
                   int threads,
                   Progress& progress,
                   ProgressSpan span)
{
  const BoundarySearch search(points, labels, reach);
  std::vector<std::vector<BoundaryPoint>> of_block(points.tree().size());
  parallelFor(of_block.size(),
              blocks_at_a_time,
              threads,
              progress,
              span,
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t b = begin; b < end; ++b)
                  of_block[b] = search.ofBlock(b);
              });
  std::vector<BoundaryPoint> found;
  for (std::vector<BoundaryPoint>& block : of_block)
    for (BoundaryPoint& each : block)
      if (!fixed[each.point])
        found.push_back(std::move(each));
  return found;
}

} // namespace pcl_cid
