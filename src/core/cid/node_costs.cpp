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
  if ((!costs.spacing.empty() && costs.spacing.size() != points) ||
      (!costs.color.empty() && costs.color.size() != points))
    throw CIDException(sentence("the costs have the spacing of ",
                                costs.spacing.size(),
                                " and the color of ",
                                costs.color.size(),
                                " points; they must be of all ",
                                points,
                                " points, or of none"));
  for (const float spacing : costs.spacing)
    if (!(spacing > 0.0f) || !(spacing <= std::numeric_limits<float>::max()))
      throw CIDException(sentence(
          "the spacing of a point is ", spacing, "; it must be a number above 0"));
  for (const Eigen::Vector3f& color : costs.color)
    if (!color.allFinite())
      throw CIDException("the color of a point is not a number; it must be finite");
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
  if (!costs->color.empty())
    color_.resize(
        2 * tree.size(),
        {Eigen::Array4f::Constant(infinity), Eigen::Array4f::Constant(-infinity)});
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
    if (!color_.empty()) {
      color_[node].low = color_[node].low.min(padded(costs_->color[p]));
      color_[node].high = color_[node].high.max(padded(costs_->color[p]));
    }
  }
}

void
NodeCosts::join(std::size_t node)
{
  if (!spacing_.empty())
    spacing_[node] = {std::min(spacing_[2 * node].low, spacing_[2 * node + 1].low),
                      std::max(spacing_[2 * node].high, spacing_[2 * node + 1].high)};
  if (!color_.empty())
    color_[node] = {color_[2 * node].low.min(color_[2 * node + 1].low),
                    color_[2 * node].high.max(color_[2 * node + 1].high)};
}

PairCost
NodeCosts::least(std::size_t node, std::size_t seed) const
{
  PairCost cost;
  if (!spacing_.empty())
    cost.weight = 2.0f / (spacing_[node].high + costs_->spacing[seed]);
  if (!color_.empty()) {
    const Eigen::Array4f color = padded(costs_->color[seed]);
    cost.cue = roundedDistance((color_[node].low - color)
                                   .max(color - color_[node].high)
                                   .max(0.0f)
                                   .matrix()
                                   .head<3>());
  }
  return cost;
}

PairCost
NodeCosts::most(std::size_t node, std::size_t seed) const
{
  PairCost cost;
  if (!spacing_.empty())
    cost.weight = 2.0f / (spacing_[node].low + costs_->spacing[seed]);
  if (!color_.empty()) {
    const Eigen::Array4f color = padded(costs_->color[seed]);
    cost.cue = roundedDistance(
        (color - color_[node].low).max(color_[node].high - color).matrix().head<3>());
  }
  return cost;
}

} // namespace pcl_cid
