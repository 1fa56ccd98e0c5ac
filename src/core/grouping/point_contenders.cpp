/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The nearest seed of one point, among those that its block could not tell apart.
 */

#include "base/infinity.h"
#include "block_groups.h"
#include "cid/cost_search.h"

#include <algorithm>
#include <utility>

namespace pcl_cid {
namespace {

/** More contenders than this are many: typically the seeds of one wall, whose CIDs are
 *  all about the spacing of the points. */
constexpr std::size_t few = 16;

} // namespace

/** One of the seeds first, then those with the smallest bounds. */
void
BlockGroups::sortFrom(std::int32_t first, std::vector<Contender>& contenders)
{
  std::sort(contenders.begin(),
            contenders.end(),
            [first](const Contender& left, const Contender& right) {
              return std::make_pair(left.id != first, left) <
                     std::make_pair(right.id != first, right);
            });
}

/** At least D_min of a point. */
float
BlockGroups::atMost(std::size_t b, const State& state) const
{
  float high = state.high;
  for (const Rival& rival : rivals_[b])
    high = std::min(high, rival.high);
  return high;
}

/** Compare a point with all seeds that it was not compared with.
 *  \param[in] exactly else its D_min may be left between two bounds */
void
BlockGroups::decide(std::size_t b, int row, bool exactly, Scratch& scratch)
{
  State& state = states_[slotOf(b, row)];
  if (isDecided(state, exactly))
    return;
  const Target point = target(b, row);
  state.high = atMost(b, state);
  collectContenders(b, point, state, scratch);
  // "D_min[p] <- min over q of D[p, q]"
  const std::optional<Contender> found =
      nearestOfFew(point, exactly, state.high, scratch);
  const Contender nearest =
      found ? *found : nearestOfMany(point, likely_[b], state.high, scratch);
  keepHints(b, scratch.contenders);
  state.group = likely_[b] = nearest.id;
  state.low = nearest.low;
  if (nearest.is_exact)
    state.high = nearest.low;
  state.decided = endOfIds();
}

/** The seeds that a point may belong to: the best of those that it was compared with,
 *  and the rivals since. */
void
BlockGroups::collectContenders(std::size_t b,
                               const Target& point,
                               const State& state,
                               Scratch& scratch) const
{
  std::vector<Contender>& contenders = scratch.contenders;
  contenders.clear();
  if (state.group >= 0 && state.low <= state.high) {
    const std::size_t hint =
        scratch.search.follow(static_cast<std::size_t>(state.group));
    contenders.push_back(contender(state.group, state.low, hint));
    contenders.back().is_exact = state.isExact();
  }
  const std::vector<Rival>& rivals = rivals_[b];
  for (std::size_t k = 0; k < rivals.size(); ++k)
    if (rivals[k].id >= state.decided && rivals[k].low <= state.high) {
      contenders.push_back(contender(rivals[k].id, rivals[k].low, rivals[k].hint));
      contenders.back().rival = static_cast<std::int32_t>(k);
    }
  for (Contender& each : contenders)
    if (!each.is_exact)
      each.low = std::max(each.low, boundAtHint(each, point));
}

/** Keep improved hints for the other points of the block. */
void
BlockGroups::keepHints(std::size_t b, const std::vector<Contender>& contenders)
{
  for (const Contender& each : contenders)
    if (each.rival >= 0)
      rivals_[b][static_cast<std::size_t>(each.rival)].hint = each.hint;
}

/** Whoever has the smallest lower bound is compared with the second smallest, which
 *  shows that its cost is the smallest of all, or raises its bound.
 *  \param[in,out] high at least the winner's cost
 *  \return nothing when that takes many rounds; the more seeds, the fewer are tried */
std::optional<Contender>
BlockGroups::nearestOfFew(const Target& point,
                          bool exactly,
                          float& high,
                          Scratch& scratch) const
{
  std::vector<Contender>& open = scratch.contenders;
  for (std::size_t round = open.size(); round <= few; ++round) {
    std::iter_swap(open.begin(), std::min_element(open.begin(), open.end()));
    Contender& first = open.front();
    if (first.is_exact)
      return first;
    const auto second = std::min_element(open.begin() + 1, open.end());
    const bool alone = second == open.end() || second->low > high;
    if (alone && !exactly)
      return first;
    const float limit = alone ? infinity : first.limitAgainst(*second);
    const DistanceBounds cost = compare(first, point, limit, exactly, scratch.search);
    first.low = std::max(first.low, cost.low);
    high = std::min(high, cost.high);
    if (cost.low < limit) {
      first.is_exact = exactly;
      return first;
    }
  }
  return std::nullopt;
}

/** Of many seeds, the second smallest bound is hardly larger than the smallest and
 *  would raise it by little, again and again: each is compared with the best so far,
 *  once.
 *  \param[in] likely the one to compare first; it does not decide who wins
 *  \param[in] high at least the winner's cost */
Contender
BlockGroups::nearestOfMany(const Target& point,
                           std::int32_t likely,
                           float high,
                           Scratch& scratch) const
{
  std::vector<Contender>& open = scratch.contenders;
  sortFrom(likely, open);
  // Sentinel: beaten by any contender that costs no more than the winner may.
  Contender best{-1, 0, std::nextafter(high, infinity), true, 0, -1};
  for (Contender& each : open) {
    if (best < each)
      continue;
    const float limit = each.limitAgainst(best);
    if (!each.is_exact)
      each.low = compare(each, point, limit, true, scratch.search).low;
    if (each.low < limit) {
      best = each;
      best.is_exact = true;
    }
  }
  return best;
}

/** A lower bound of the cost to a contender, from one look. */
float
BlockGroups::boundAtHint(const Contender& contender, const Target& point) const
{
  const SegmentSamples samples(
      seed(contender.id).point.position, point.position, order_.samples());
  const float low =
      points_.field().grid().lowerBound(samples.at(contender.hint)) - samples.slack;
  return costOf(contender.id, point).of(std::max(low, 0.0f));
}

/** Bounds of the cost to a contender: the cost if it is below the limit, else the lower
 *  one is at least that. Without \a exactly, a cost below the limit may be left between
 *  two bounds, the lower one below the limit. */
DistanceBounds
BlockGroups::compare(Contender& contender,
                     const Target& point,
                     float limit,
                     bool exactly,
                     SegmentSearch& search) const
{
  const Segment segment = segmentTo(contender.id, point);
  const PairCost cost = costOf(contender.id, point);
  std::size_t& hint = contender.hint;
  std::size_t& last_hint = search.follow(static_cast<std::size_t>(contender.id));
  if (!exactly) {
    const float below = cost.cidBelow(limit);
    const DistanceBounds cid = search.bounds(segment, below, hint);
    last_hint = hint;
    if (cid.low < below || cost.of(cid.low) >= limit)
      return {cost.of(cid.low), cost.of(cid.high)};
  }
  const float found = searchCost(search, segment, cost, limit, hint);
  return {found, found < limit ? found : infinity};
}

} // namespace pcl_cid
