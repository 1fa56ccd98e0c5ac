/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the CID of a pair costs: where raw scans go beyond the paper.
 */

#pragma once

#include "cue.h"

#include "base/rounding.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace pcl_cid {

/** \brief `cost = weight * CID + cue` of one pair of points (*ours*); the paper has a
 *  weight of 1 and no cue. It never falls when the CID, the weight or the cue grows, in
 *  float too, so bounds of those are bounds of it. */
struct PairCost {
  float weight = 1.0f; ///< above 0
  float cue = 0.0f;    ///< metres, 0 or more

  float
  of(float cid) const
  {
    return weight * cid + cue;
  }

  /** \brief A CID below which the cost is certainly below a limit: the inverse of of(),
   *  less a slack for rounding. */
  float
  cidBelow(float limit) const
  {
    const float rest =
        limit * (1.0f - rounding::of_product) - cue * (1.0f + rounding::of_product);
    return std::max(rest / weight * (1.0f - rounding::of_product), 0.0f);
  }

  /** \brief A CID that no pair of this cost exceeds: the inverse of of(), plus a slack
   *  for rounding. */
  float
  cidWithin(float cost) const
  {
    const float rest =
        cost * (1.0f + rounding::of_product) - cue * (1.0f - rounding::of_product);
    return rest / weight * (1.0f + rounding::of_product);
  }
};

/** \brief The cost of every pair of a set of points: `cost(p, q) = w(p, q) CID_p(p, q)
 *  + cue_1(p, q) + cue_2(p, q) + ...` (*ours*), symmetric to the last bit. Without both
 *  members it is CID_p itself. */
struct PairCosts {
  /** s(p) of each point, its spacing in relation to that of the cloud, above 0; empty
   *  means 1 everywhere. `w(p, q) = 2 / (s(p) + s(q))`: where points are far apart,
   *  distances to the surface are large without any concavity. */
  std::vector<float> spacing;

  /** What is added, each cue of all points: color, normals. Empty means nothing. */
  std::vector<Cue> cues;

  /** \brief Whether the cost is the CID, as in the paper. */
  bool
  isPlain() const
  {
    return spacing.empty() && cues.empty();
  }

  PairCost
  between(std::size_t p, std::size_t q) const
  {
    PairCost cost;
    if (!spacing.empty())
      cost.weight = 2.0f / (spacing[p] + spacing[q]);
    for (const Cue& cue : cues)
      cost.cue += cue.between(p, q);
    return cost;
  }
};

} // namespace pcl_cid
