/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The argmax of D_min: which point is the farthest from its seed.
 */

#include "base/rounding.h"
#include "block_groups.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace pcl_cid {
namespace {

/** Blocks that the search for the farthest point begins with. */
constexpr std::size_t most_promising = 128;

/** Blocks that a thread takes at a time: neighbors, whose segments from a seed pass
 *  through the same cells. */
constexpr std::size_t blocks_at_once = 4;

/** With more seeds than this to come, a point with a large upper bound is examined
 *  again and again: its exact value is worth the cost. */
constexpr std::size_t many_to_come = 100;

} // namespace

/** Carry a block's new upper bound up the tree. */
void
BlockGroups::updateAbove(std::size_t node)
{
  for (node /= 2; node > 0; node /= 2) {
    const float upper = std::max(upper_[2 * node], upper_[2 * node + 1]);
    if (upper == upper_[node])
      return;
    upper_[node] = upper;
  }
}

/** A point cannot come nearer to any seed than CID_p(p, p) = d(p; S), which is 0 for
 *  the points of S; one that is already as near as that gains nothing by being a seed.
 */
bool
BlockGroups::gains(std::size_t b, int row) const
{
  const Target point = target(b, row);
  return states_[slotOf(b, row)].low >
         points_.costs()
             .between(point.index, point.index)
             .of(points_.field().distance(point.position));
}

/** Whether some seed brings D_min of a point below a floor: one is enough, most often
 *  the one that did so for the previous point of the block.
 *  \return the seed, or none; the point's upper bound then takes it into account */
BlockGroups::Closeness
BlockGroups::fallsShort(std::size_t b, int row, float floor, Scratch& scratch)
{
  State& state = states_[slotOf(b, row)];
  const Target point = target(b, row);
  std::vector<Contender>& open = scratch.contenders;
  open.clear();
  const float most = atMost(b, state);
  std::vector<Rival>& rivals = rivals_[b];
  for (std::size_t k = 0; k < rivals.size(); ++k)
    if (rivals[k].id >= std::max(state.decided, state.tried) && rivals[k].low < floor &&
        rivals[k].low <= most) {
      open.push_back(contender(rivals[k].id, rivals[k].low, rivals[k].hint));
      open.back().rival = static_cast<std::int32_t>(k);
    }
  sortFrom(likely_[b], open);
  const UpperBound how =
      to_come_ > many_to_come ? UpperBound::exact : UpperBound::quick;
  state.tried = endOfIds();
  for (const Contender& each : open) {
    const PairCost cost = costOf(each.id, point);
    const float below = cost.cidBelow(floor);
    std::size_t& hint = rivals[static_cast<std::size_t>(each.rival)].hint;
    scratch.search.follow(static_cast<std::size_t>(each.id));
    const float cid =
        scratch.search.upperBound(segmentTo(each.id, point), below, how, hint);
    if (cid < below) {
      state.high = std::min(state.high, cost.of(cid));
      return {each.id, cid};
    }
  }
  return {};
}

/** The seed that a decided point belongs to. */
BlockGroups::Closeness
BlockGroups::closenessOf(const Target& point, const State& state) const
{
  return {state.group, costOf(state.group, point).cidWithin(state.low)};
}

/** The point of a block with the largest D_min, or product of that and its factor of a
 *  draw, if that is at least \a floor. */
BlockGroups::Farthest
BlockGroups::farthestOfBlock(std::size_t b,
                             float floor,
                             const Query& query,
                             Scratch& scratch)
{
  const PointBlock& block = tree().block(b);
  const int left_out = query.seeds ? isolated | no_candidate | no_gain : isolated;
  std::array<float, PointBlock::capacity> factor;
  for (int row = 0; row < block.count; ++row)
    factor[static_cast<std::size_t>(row)] =
        query.draw ? query.draw->factor(target(b, row).index) : 1.0f;
  float& upper = upper_[tree().nodeOfBlock(b)];
  for (;;) {
    float largest = -1.0f;
    float overall = 0.0f;
    int best = -1;
    for (int row = 0; row < block.count; ++row) {
      const State& state = states_[slotOf(b, row)];
      overall = std::max(overall, state.high);
      if (marks_[slotOf(b, row)] & left_out)
        continue;
      const float value = state.high * factor[static_cast<std::size_t>(row)];
      const bool tied = value == largest && block.index[row] < block.index[best];
      if (value > largest || tied) {
        largest = value;
        best = row;
      }
    }
    upper = std::min(upper, overall);
    if (best < 0 || largest < floor)
      return {};
    const State& state = states_[slotOf(b, best)];
    if (!isDecided(state, true)) {
      const float least =
          PairCost{factor[static_cast<std::size_t>(best)]}.cidBelow(floor);
      Closeness closest = fallsShort(b, best, least, scratch);
      if (closest.id < 0) {
        decide(b, best, true, scratch);
        closest = closenessOf(target(b, best), state);
      }
      likely_[b] = closest.id;
      shareWithNeighbors(b, best, closest);
    }
    else if (query.seeds && !gains(b, best))
      marks_[slotOf(b, best)] |= no_gain;
    else
      return {largest, block.index[best]};
  }
}

/** The CIDs of two points to one seed differ by no more than the points are apart: no
 *  sample moves farther, and d is 1-Lipschitz. So what is known of one point of a block
 *  bounds D_min of the others. */
void
BlockGroups::shareWithNeighbors(std::size_t b, int row, const Closeness& closest)
{
  const PointBlock& block = tree().block(b);
  const Eigen::Array<float, PointBlock::capacity, 1> cid =
      (block.squaredDistances(block.point(row)).sqrt() + closest.cid) *
          rounding::widening +
      slack_;
  for (int other = 0; other < block.count; ++other) {
    float& high = states_[slotOf(b, other)].high;
    high = std::min(high, costOf(closest.id, target(b, other)).of(cid[other]));
  }
}

/** The blocks that may hold a point with a D_min of at least \a floor, neighbors
 *  together. */
std::vector<std::size_t>
BlockGroups::blocksAbove(float floor) const
{
  std::vector<std::size_t> blocks;
  std::vector<std::size_t> open = {1};
  while (!open.empty()) {
    const std::size_t node = open.back();
    open.pop_back();
    if (upper_[node] < floor)
      continue;
    if (tree().isBlock(node))
      blocks.push_back(node - tree().size());
    else
      open.insert(open.end(), {2 * node + 1, 2 * node});
  }
  return blocks;
}

/** A few of the blocks, those that may hold the largest D_min. */
std::vector<std::size_t>
BlockGroups::mostPromising(const std::vector<std::size_t>& blocks) const
{
  std::vector<std::size_t> best(std::min(blocks.size(), most_promising));
  std::partial_sort_copy(blocks.begin(),
                         blocks.end(),
                         best.begin(),
                         best.end(),
                         [this](std::size_t a, std::size_t b) {
                           const float upper_a = upper_[tree().nodeOfBlock(a)];
                           const float upper_b = upper_[tree().nodeOfBlock(b)];
                           return upper_a > upper_b || (upper_a == upper_b && a < b);
                         });
  return best;
}

/** The farthest point of some blocks, in parallel.
 *  \param[in] blocks each once
 *  \param[in] best of all others so far
 *  \return the best of these, too */
BlockGroups::Farthest
BlockGroups::farthestOfBlocks(const std::vector<std::size_t>& blocks,
                              const Query& query,
                              Work work,
                              ProgressSpan span,
                              Farthest best)
{
  std::vector<Farthest> found(blocks.size());
  std::atomic<float> reached{std::max(best.value, 0.0f)};
  const int team = blocks.size() < 4 * blocks_at_once ? 1 : work.threads;
  parallelFor(blocks.size(),
              blocks_at_once,
              team,
              work.progress,
              span,
              [&](std::size_t begin, std::size_t end) {
                Scratch scratch(*this);
                for (std::size_t k = begin; k < end; ++k) {
                  const float floor = reached;
                  if (upper_[tree().nodeOfBlock(blocks[k])] < floor / query.most())
                    continue;
                  found[k] = farthestOfBlock(blocks[k], floor, query, scratch);
                  float so_far = reached;
                  while (found[k].value > so_far &&
                         !reached.compare_exchange_weak(so_far, found[k].value))
                    ;
                }
              });
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    updateAbove(tree().nodeOfBlock(blocks[k]));
    const bool tied = found[k].value == best.value && found[k].point < best.point;
    if (found[k].value > best.value || tied)
      best = found[k];
  }
  return best;
}

/** The most promising blocks first: they give a value that most others fall short of.
 */
BlockGroups::Farthest
BlockGroups::argmax(const Query& query, Work work, ProgressSpan span)
{
  std::size_t node = 1;
  while (!tree().isBlock(node))
    node = upper_[2 * node] >= upper_[2 * node + 1] ? 2 * node : 2 * node + 1;
  Farthest best = farthestOfBlocks({node - tree().size()}, query, work, span, {});
  const auto rest = [&] {
    return blocksAbove(std::max(best.value, 0.0f) / query.most());
  };
  best = farthestOfBlocks(mostPromising(rest()), query, work, span, best);
  return farthestOfBlocks(rest(), query, work, span, best);
}

float
BlockGroups::coverage(Work work, ProgressSpan span)
{
  return argmax({false}, work, span).value;
}

BlockGroups::Farthest
BlockGroups::farthest(Work work, ProgressSpan span)
{
  return argmax({true}, work, span);
}

BlockGroups::Farthest
BlockGroups::draw(const SoftDraw& draw, Work work, ProgressSpan span)
{
  return argmax({true, &draw}, work, span);
}

} // namespace pcl_cid
