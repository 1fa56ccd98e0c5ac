/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A new seed against whole blocks of points, down the tree.
 */

#include "base/infinity.h"
#include "block_groups.h"
#include "cid/sample_caps.h"

#include <algorithm>
#include <cmath>

namespace pcl_cid {
namespace {

/** Levels of samples that are tried at an inner node of the tree. */
constexpr std::size_t node_levels = 4;

/** A surface point lowers the caps of about this many samples on either side of the one
 *  where it was found. */
constexpr std::size_t neighboring_samples = 16;

} // namespace

/** The cost from which on a seed loses every point below a node. At equal cost the
 *  earlier seed wins, so the last seed loses at the upper bound already, others only
 *  above it. */
float
BlockGroups::beatenAt(std::size_t node, const Newcomer& seed) const
{
  return seed.is_last ? upper_[node] : std::nextafter(upper_[node], infinity);
}

/** Whether the seed has lost every point below a node.
 *  \param[in,out] hint the sample to try first, and the one that came nearest to it */
bool
BlockGroups::compareNode(std::size_t node,
                         const Newcomer& seed,
                         std::size_t& hint) const
{
  const float beaten_at = beatenAt(node, seed);
  const Eigen::Vector3f center = tree().box(node).center();
  const float radius = tree().box(node).radius();
  if (beaten_at == infinity || 2.0f * radius > (center - seed.point.position).norm())
    return false; // too coarse to tell
  const PairCost least = points_.costs().least(node, seed.point.index);
  const SegmentSamples segment(seed.point.position, center, order_.samples());
  float largest = -infinity;
  std::size_t largest_at = hint;
  const auto loses = [&](std::size_t l) {
    const float low = points_.field().grid().lowerBound(segment.at(l)) - segment.slack -
                      segment.fraction(l) * radius;
    if (low > largest) {
      largest = low;
      largest_at = l;
    }
    return least.of(low) >= beaten_at;
  };
  if (loses(hint))
    return true;
  for (std::size_t k = 0; k < std::min(order_.levels().size(), node_levels); ++k)
    for (const std::size_t l : order_.levels()[k])
      if (loses(l))
        return true;
  hint = largest_at;
  return false;
}

void
BlockGroups::compareBelow(std::size_t node,
                          const Newcomer& seed,
                          std::size_t hint,
                          Scratch& scratch)
{
  if (tree().isBlock(node)) {
    compareBlock(node, seed, hint, scratch);
    return;
  }
  const bool spares_many = !tree().isBlock(2 * node);
  if (spares_many && compareNode(node, seed, hint))
    return;
  compareBelow(2 * node, seed, hint, scratch);
  compareBelow(2 * node + 1, seed, hint, scratch);
  upper_[node] = std::max(upper_[2 * node], upper_[2 * node + 1]);
}

void
BlockGroups::compareBlock(std::size_t node,
                          const Newcomer& seed,
                          std::size_t hint,
                          Scratch& scratch)
{
  const float beaten_at = beatenAt(node, seed);
  const Eigen::Vector3f center = tree().box(node).center();
  const float radius = tree().box(node).radius();
  const PairCost least = points_.costs().least(node, seed.point.index);
  const SegmentSamples segment(seed.point.position, center, order_.samples());
  SampleCaps caps(segment, order_, scratch.caps);
  caps.reset();
  Rival rival{seed.id, 0.0f, 0.0f, hint};
  const auto loses = [&](std::size_t l) {
    const float reach = segment.fraction(l) * radius + segment.slack;
    const DistanceGrid::Look look = points_.field().grid().look(segment.at(l));
    if (look.bounds.low - reach > rival.low) {
      rival.low = look.bounds.low - reach;
      rival.hint = l;
    }
    rival.high = std::max(rival.high, look.bounds.high + reach);
    if (least.of(rival.low) >= beaten_at)
      return true;
    caps.lower(look.point, l, neighboring_samples);
    return false;
  };
  if (loses(hint) || loses(order_.last()))
    return;
  if (points_.areOnSurface()) // the seed is its own nearest point
    caps.lower(seed.point.position, 0, neighboring_samples);
  else if (loses(0))
    return;
  for (const SampleOrder::Level& level : order_.levels())
    for (const std::size_t l : level)
      if (caps[l] >= caps.squareOf(rival.high - segment.fraction(l) * radius) &&
          loses(l))
        return;

  rival.low = least.of(rival.low);
  rival.high = points_.costs().most(node, seed.point.index).of(rival.high);
  upper_[node] = std::min(upper_[node], rival.high);
  std::vector<Rival>& rivals = rivals_[node - tree().size()];
  const auto beaten = [limit = upper_[node]](const Rival& r) { return r.low > limit; };
  rivals.erase(std::remove_if(rivals.begin(), rivals.end(), beaten), rivals.end());
  rivals.push_back(rival);
}

} // namespace pcl_cid
