/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The nearest seed of one point, among those that its block could not tell apart.
 */

#include "block_groups.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace pcl_cid {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/** More seeds than this are many: those of one wall, whose CIDs are about the spacing
 * of the points, and differ by chance. */
constexpr std::size_t few = 16;
/** With more seeds than this to come, a point will come up again and again, the more
 * often the larger its upper bound: the exact value is worth its cost. */
constexpr std::size_t many_to_come = 100;

} // namespace

/** One of the seeds first, then those with the smallest bounds. */
void
BlockGroups::sortFrom(std::int32_t first, std::vector<Contender>& contenders)
{
  std::sort(contenders.begin(),
            contenders.end(),
            [first](const Contender& left, const Contender& right) {
              return std::make_pair(left.number != first, left) <
                     std::make_pair(right.number != first, right);
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

/** Whether some seed brings D_min of a point below a floor: one is enough. Most often
 *  it is the one that did for the point of the block before.
 *  \return the seed, or none; the point's upper bound then takes it into account */
BlockGroups::Closeness
BlockGroups::fallsShort(std::size_t b, int row, float floor)
{
  State& state = states_[slotOf(b, row)];
  const Target point = target(b, row);
  thread_local std::vector<Contender> open;
  open.clear();
  const float most = atMost(b, state);
  for (Rival& rival : rivals_[b])
    if (rival.number >= std::max(state.decided, state.tried) && rival.low < floor &&
        rival.low <= most)
      open.push_back({rival.number, rival.low, false, &rival});
  sortFrom(likely_[b], open);
  const Tightness tightness =
      to_come_ > many_to_come ? Tightness::exact : Tightness::looks;
  state.tried = static_cast<std::int32_t>(seeds_.size());
  for (const Contender& contender : open) {
    const PairCost cost = costOf(contender, point);
    const float below = cost.cidBelow(floor);
    const float cid = boundPointCID(field_,
                                    segmentTo(contender, point),
                                    order_,
                                    below,
                                    tightness,
                                    contender.rival->hint);
    if (cid < below) {
      state.high = std::min(state.high, cost.of(cid));
      return {contender.number, cid};
    }
  }
  return {};
}

/** The seed that a decided point belongs to. */
BlockGroups::Closeness
BlockGroups::closenessOf(const Target& point, const State& state) const
{
  const Seed& seed = seeds_[static_cast<std::size_t>(state.group)];
  return {state.group, costs_.between(seed.index, point.index).cidWithin(state.cid)};
}

/** Compare a point with all seeds that it was not compared with.
 *  \param[in] keep_cid else the winner's CID may be left at a lower bound */
void
BlockGroups::decide(std::size_t b, int row, bool keep_cid)
{
  State& state = states_[slotOf(b, row)];
  if (state.decided == static_cast<std::int32_t>(seeds_.size()))
    return;
  const Target point = target(b, row);
  std::vector<Contender>& open = contenders(b, point, state);
  const std::optional<Contender> found = nearestOfFew(point, keep_cid, open);
  const Contender nearest =
      found ? *found : nearestOfMany(point, likely_[b], state.high, open);
  state.group = likely_[b] = nearest.number;
  state.cid = state.high = nearest.low;
  state.decided = static_cast<std::int32_t>(seeds_.size());
}

/** The seeds that a point may belong to: the best of those that it was compared with,
 *  and the rivals since. */
std::vector<BlockGroups::Contender>&
BlockGroups::contenders(std::size_t b, const Target& point, State& state)
{
  thread_local std::vector<Contender> contenders;
  contenders.clear();
  state.high = atMost(b, state);
  if (state.group >= 0 && state.cid <= state.high)
    contenders.push_back({state.group, state.cid, true, nullptr});
  for (Rival& rival : rivals_[b])
    if (rival.number >= state.decided && rival.low <= state.high)
      contenders.push_back({rival.number, rival.low, false, &rival});
  for (Contender& contender : contenders)
    if (!contender.settled)
      contender.low = std::max(contender.low, boundAtHint(contender, point));
  return contenders;
}

/** Whoever has the smallest lower bound is compared with the second smallest, which
 *  shows that its cost is the smallest of all, or raises its bound.
 *  \return nothing when that takes many rounds; the more seeds, the fewer are tried */
std::optional<BlockGroups::Contender>
BlockGroups::nearestOfFew(const Target& point,
                          bool keep_cid,
                          std::vector<Contender>& open) const
{
  for (std::size_t round = open.size(); round <= few; ++round) {
    std::iter_swap(open.begin(), std::min_element(open.begin(), open.end()));
    Contender& first = open.front();
    if (first.settled)
      return first;
    const auto second = std::min_element(open.begin() + 1, open.end());
    const bool alone = second == open.end();
    if (alone && !keep_cid)
      return first;
    const float limit = alone ? infinity : first.limitAgainst(*second);
    const float cost = compare(first, point, limit, keep_cid);
    first.settled = cost < limit;
    first.low = std::max(first.low, cost);
  }
  return std::nullopt;
}

/** Of many seeds, the second smallest bound is hardly larger than the smallest and
 * would raise it by little, again and again: each is compared with the best so far,
 * once.
 * \param[in] likely the first one; who wins depends on its cost alone
 * \param[in] high at least the winner's cost */
BlockGroups::Contender
BlockGroups::nearestOfMany(const Target& point,
                           std::int32_t likely,
                           float high,
                           std::vector<Contender>& open) const
{
  sortFrom(likely, open);
  // Nobody yet, and beaten by whoever costs no more than the winner may.
  Contender best{-1, std::nextafter(high, infinity), true, nullptr};
  for (Contender& contender : open) {
    if (best < contender)
      continue;
    const float limit = contender.limitAgainst(best);
    if (!contender.settled)
      contender.low = compare(contender, point, limit, true);
    if (contender.low < limit)
      best = contender;
  }
  return best;
}

/** A lower bound of the cost to a contender, from one look. */
float
BlockGroups::boundAtHint(const Contender& contender, const Target& point) const
{
  const SegmentSamples samples(
      seedOf(contender).position, point.position, order_.samples());
  const float low = grid_.lowerBound(samples.at(contender.rival->hint)) - samples.slack;
  return costOf(contender, point).of(std::max(low, 0.0f));
}

/** The cost to a contender, or a lower bound of it that is at least \a limit; without
 *  \a keep_cid, anything below the limit for a cost below it. */
float
BlockGroups::compare(const Contender& contender,
                     const Target& point,
                     float limit,
                     bool keep_cid) const
{
  const Segment segment = segmentTo(contender, point);
  const PairCost cost = costOf(contender, point);
  std::size_t& hint = contender.rival->hint;
  const float below = cost.cidBelow(limit);
  const float cid =
      keep_cid ? pointCID(field_, segment, order_, below, hint)
               : findCIDAtLeast(field_, segment, order_, below, hint).value_or(0.0f);
  if (cid < below || cost.of(cid) >= limit)
    return cost.of(cid);
  return cost.of(
      pointCID(field_, segment, order_, infinity, hint)); // too close to tell
}

} // namespace pcl_cid
