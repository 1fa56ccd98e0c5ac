/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The cost of a seed and of any point below a node of a block tree.
 */

#include "node_costs.h"

#include "base/infinity.h"
#include "base/parallel_for.h"
#include "base/sentence.h"

#include <algorithm>

namespace pcl_cid {
void
requireCosts(const PairCosts& costs, std::size_t points)
{
  const auto requireAll = [points](std::size_t values) {
    if (values != points)
      throw CIDException(sentence("the costs have values of ",
                                  values,
                                  " points; they must be of all ",
                                  points,
                                  " points"));
  };
  if (!costs.spacing.empty())
    requireAll(costs.spacing.size());
  for (const Cue& cue : costs.cues)
    requireAll(cue.values.size());
  for (const float spacing : costs.spacing)
    if (!(spacing > 0.0f) || !(spacing <= std::numeric_limits<float>::max()))
      throw CIDException(sentence(
          "the spacing of a point is ", spacing, "; it must be a number above 0"));
  for (const Cue& cue : costs.cues)
    for (const Eigen::Vector3f& value : cue.values)
      if (!value.allFinite())
        throw CIDException("a color or a normal of a point is not a number; it must be "
                           "finite");
}

NodeCosts::NodeCosts(const PairCosts* costs,
                     const BlockTree& tree,
                     int threads,
                     Progress& progress)
: costs_(costs)
{
  if (!costs)
    return;
  if (!costs->spacing.empty())
    spacing_.resize(2 * tree.size());
  const PointBox nothing{Eigen::Array4f::Constant(infinity),
                         Eigen::Array4f::Constant(-infinity)};
  boxes_.assign(costs->cues.size(), std::vector<PointBox>(2 * tree.size(), nothing));
  parallelFor(tree.size(), 256, threads, progress, {}, [&](auto begin, auto end) {
    for (std::size_t b = begin; b < end; ++b)
      gather(tree, b);
  });
  for (std::size_t node = tree.size() - 1; node > 0; --node)
    join(node);
}

void
NodeCosts::gather(const BlockTree& tree, std::size_t block)
{
  const std::size_t node = tree.nodeOfBlock(block);
  for (int row = 0; row < tree.block(block).count; ++row) {
    const auto p = static_cast<std::size_t>(tree.block(block).index[row]);
    if (!spacing_.empty()) {
      spacing_[node].low = std::min(spacing_[node].low, costs_->spacing[p]);
      spacing_[node].high = std::max(spacing_[node].high, costs_->spacing[p]);
    }
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
      PointBox& box = boxes_[k][node];
      const Eigen::Array4f value = padded(costs_->cues[k].values[p]);
      box = {box.low.min(value), box.high.max(value)};
    }
  }
}

void
NodeCosts::join(std::size_t node)
{
  if (!spacing_.empty())
    spacing_[node] = {std::min(spacing_[2 * node].low, spacing_[2 * node + 1].low),
                      std::max(spacing_[2 * node].high, spacing_[2 * node + 1].high)};
  for (std::vector<PointBox>& box : boxes_)
    box[node] = {box[2 * node].low.min(box[2 * node + 1].low),
                 box[2 * node].high.max(box[2 * node + 1].high)};
}

PairCost
NodeCosts::least(std::size_t node, std::size_t seed) const
{
  PairCost cost;
  if (!spacing_.empty())
    cost.weight = 2.0f / (spacing_[node].high + costs_->spacing[seed]);
  for (std::size_t k = 0; k < boxes_.size(); ++k)
    cost.cue += costs_->cues[k].least(boxes_[k][node], seed);
  return cost;
}

PairCost
NodeCosts::most(std::size_t node, std::size_t seed) const
{
  PairCost cost;
  if (!spacing_.empty())
    cost.weight = 2.0f / (spacing_[node].low + costs_->spacing[seed]);
  for (std::size_t k = 0; k < boxes_.size(); ++k)
    cost.cue += costs_->cues[k].most(boxes_[k][node], seed);
  return cost;
}

} // namespace pcl_cid
