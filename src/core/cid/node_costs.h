/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The cost of a seed and of any point below a node of a block tree.
 */

#pragma once

#include "field/block_tree.h"

#include "pair_cost.h"

#include <vector>

namespace pcl_cid {

/** \brief Refuse costs that are not of these points, or are not numbers.
 *  \throws CIDException */
void
requireCosts(const PairCosts& costs, std::size_t points);

/** \brief Bounds of PairCosts::between() for whole nodes: w is smallest where the
 *  spacing is largest, a cue is within what the box of the node's values allows. */
class NodeCosts {
public:
  /** \param[in] costs of the points of the tree; null: the cost is the CID; must
   *  outlive this
   *  \param[in] tree what the nodes are of */
  NodeCosts(const PairCosts* costs,
            const BlockTree& tree,
            int threads,
            Progress& progress);

  /** \brief The cost of a pair of points. */
  PairCost
  between(std::size_t p, std::size_t q) const
  {
    return costs_ ? costs_->between(p, q) : PairCost();
  }

  /** \brief The costs of all pairs; null: the cost is the CID. */
  const PairCosts*
  ofPairs() const
  {
    return costs_;
  }

  /** \brief Lower bound of the cost of a seed and any point below a node. */
  PairCost
  least(std::size_t node, std::size_t seed) const;

  /** \brief Upper bound of the same. */
  PairCost
  most(std::size_t node, std::size_t seed) const;

private:
  struct Range {
    float low = std::numeric_limits<float>::infinity();
    float high = 0.0f;
  };

  void
  gather(const BlockTree& tree, std::size_t block);

  void
  join(std::size_t node);

  const PairCosts* costs_;
  std::vector<Range> spacing_;               ///< by node; empty without spacing
  std::vector<std::vector<PointBox>> boxes_; ///< of the values of each cue, by node
};

} // namespace pcl_cid
