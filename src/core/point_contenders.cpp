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

namespace pcl_cid {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/** More contenders than this are many. */
constexpr std::size_t few_contenders = 16;

} // namespace

/** The seeds that a point may belong to: the best of those that it was compared with,
 *  and the rivals since. */
std::vector<BlockGroups::Contender>&
BlockGroups::contenders(std::size_t b, const State& state)
{
  thread_local std::vector<Contender> contenders;
  contenders.clear();
  float high = state.high;
  for (const Rival& rival : rivals_[b])
    high = std::min(high, rival.high);
  if (state.group >= 0 && state.cid <= high)
    contenders.push_back({state.group, state.cid, true, nullptr});
  for (Rival& rival : rivals_[b])
    if (rival.number >= state.decided && rival.low <= high)
      contenders.push_back({rival.number, rival.low, false, &rival});
  return contenders;
}

/** Whether some seed brings D_min of a point below a floor: one is enough. Most often
 *  it is the one that did for the point of the block before.
 *  \param[in] likely the number of that seed; -1 for none
 *  \return the seed, or none; the point's upper bound then takes it into account */
BlockGroups::Closeness
BlockGroups::fallsShort(const Target& point,
                        float floor,
                        std::int32_t likely,
                        std::vector<Contender>& open,
                        State& state)
{
  std::sort(open.begin(), open.end(), [likely](const auto& a, const auto& b) {
    return std::make_pair(a.number != likely, a) <
           std::make_pair(b.number != likely, b);
  });
  Closeness closest;
  for (const Contender& contender : open) {
    if (contender.settled || contender.low >= floor || contender.number < state.tried)
      continue;
    const PairCost cost = costOf(contender, point);
    const float below = cost.cidBelow(floor);
    const float cid = boundPointCID(
        field_, segmentTo(contender, point), order_, below, contender.rival->hint);
    if (cid < below) {
      closest = {contender.number, cid};
      state.high = std::min(state.high, cost.of(cid));
      break;
    }
  }
  state.tried = static_cast<std::int32_t>(seeds_.size());
  return closest;
}

/** The seed that a decided point belongs to. */
BlockGroups::Closeness
BlockGroups::closenessOf(const Target& point, const State& state) const
{
  const Seed& seed = seeds_[static_cast<std::size_t>(state.group)];
  return {state.group, costs_.between(seed.index, point.index).cidWithin(state.cid)};
}

/** Compare a point with all seeds that it was not compared with, best first. Of a few,
 *  whoever has the smallest lower bound is compared with the second smallest, which
 *  shows that its CID is the smallest of all, or raises its bound. Of many, that would
 *  raise bounds by little, again and again: they are compared with the smallest CID so
 *  far.
 *  \param[in] keep_cid else the winner's CID may be left at a lower bound */
void
BlockGroups::decide(const Target& point,
                    bool keep_cid,
                    std::vector<Contender>& open,
                    State& state)
{
  for (Contender& contender : open)
    if (!contender.settled)
      contender.low = std::max(contender.low, boundAtHint(contender, point));
  const bool few = open.size() <= few_contenders;
  for (;;) {
    std::iter_swap(open.begin(), std::min_element(open.begin(), open.end()));
    Contender& first = open.front();
    if (first.settled) {
      state.group = first.number;
      state.cid = state.high = first.low;
      state.decided = static_cast<std::int32_t>(seeds_.size());
      return;
    }
    const float limit = limitFor(first, open, few);
    const float cid = compare(first, point, limit, keep_cid || !few);
    first.settled = cid < limit;
    first.low = std::max(first.low, cid);
  }
}

/** From which CID on another contender is better than the first one.
 *  \param[in] any also those of which only a lower bound is known */
float
BlockGroups::limitFor(const Contender& first,
                      const std::vector<Contender>& open,
                      bool any)
{
  const Contender* best = nullptr;
  for (const Contender& other : open)
    if (&other != &first && (any || other.settled) && (!best || other < *best))
      best = &other;
  if (!best)
    return infinity;
  return first.number < best->number ? std::nextafter(best->low, infinity) : best->low;
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
  if (limit == infinity && !keep_cid)
    return 0.0f;
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
