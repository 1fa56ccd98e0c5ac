/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The points that Algorithms 1 and 2 work on: in blocks, with the costs of their pairs.
 */

#pragma once

#include "field/block_tree.h"
#include "node_costs.h"

#include "pair_cost.h"
#include <pcl_cid/core/distance_field.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl_cid {

/** \brief Points in blocks, the surface that distances are measured to, and what pairs
 *  of the points cost. Immutable: any number of groupings read one side by side. */
class WorkingPoints {
public:
  /** How the points relate to the surface S. */
  enum class Place {
    are_surface, ///< they are the points of S, in the same order
    on_surface,  ///< each is a point of S, so d is 0 there
    anywhere
  };

  /** \param[in] field of S; must outlive this
   *  \param[in] points in the frame of S, at least 1; must outlive this
   *  \param[in] costs of pairs; null: the cost is the CID; must outlive this
   *  \throws CIDException when the costs are not those of so many points, CIDCancelled
   */
  WorkingPoints(const DistanceField& field,
                const Points& points,
                Place place,
                const PairCosts* costs,
                int threads,
                Progress& progress);

  const DistanceField&
  field() const
  {
    return field_;
  }

  const Points&
  points() const
  {
    return points_;
  }

  std::size_t
  size() const
  {
    return points_.size();
  }

  /** \brief Whether d(x; S) is 0 at each of the points. */
  bool
  areOnSurface() const
  {
    return on_surface_;
  }

  const BlockTree&
  tree() const
  {
    return own_tree_ ? *own_tree_ : field_.blocks();
  }

  const NodeCosts&
  costs() const
  {
    return costs_;
  }

  /** \brief The slot of a point in the tree: block * PointBlock::capacity + row. */
  std::size_t
  slotOf(std::size_t point) const
  {
    return static_cast<std::size_t>(slots_[point]);
  }

private:
  void
  findSlots(int threads, Progress& progress);

  const DistanceField& field_;
  const Points& points_;
  bool on_surface_;
  std::unique_ptr<BlockTree> own_tree_; ///< null where the field has the same
  NodeCosts costs_;
  std::vector<std::int32_t> slots_; ///< by point
};

} // namespace pcl_cid
