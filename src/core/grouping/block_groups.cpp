/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The nearest seed of every point, block by block, decided as late as possible.
 */

#include "block_groups.h"
#include "cid/sample_caps.h"

#include <algorithm>
#include <array>
#include <limits>

namespace pcl_cid {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/** Levels of samples that a node of the tree, which is no block, is tried with. */
constexpr std::size_t node_levels = 4;

/** A surface point is of use for this many samples before and after the one that it was
 *  found at, about. */
constexpr std::size_t neighboring_samples = 16;

/** A seed is compared with this many subtrees side by side. */
constexpr std::size_t most_subtrees = 1024;

/** With how many blocks the search for the farthest point begins. */
constexpr std::size_t most_promising = 128;

/** Blocks that a thread settles at a time: neighbours, whose segments from a seed pass
 *  through the same cells. */
constexpr std::size_t blocks_at_once = 4;

/** Whether points are those of the surface, in their order. */
bool
areSurface(const Points& points,
           const DistanceField& field,
           int threads,
           Progress& progress)
{
  const BlockTree& tree = field.blocks();
  std::atomic<bool> same{points.size() == field.size()};
  if (same)
    parallelFor(tree.size(), 256, threads, progress, {}, [&](auto begin, auto end) {
      for (std::size_t b = begin; b < end; ++b)
        for (int row = 0; row < tree.block(b).count; ++row)
          if (tree.block(b).point(row) !=
              points[static_cast<std::size_t>(tree.block(b).index[row])])
            same = false;
    });
  return same;
}

} // namespace

BlockGroups::BlockGroups(const DistanceField& field,
                         const Points& points,
                         const GroupingOptions& options,
                         Progress& progress)
: field_(field)
, grid_(field.grid())
, threads_(threadCount(options.execution.threads))
, own_tree_(areSurface(points, field, threads_, progress)
                ? nullptr
                : std::make_unique<BlockTree>(points, threads_, progress))
, tree_(own_tree_ ? *own_tree_ : field.blocks())
, costs_(options.costs, tree_, threads_, progress)
, order_(options.samples)
, slack_(
      32.0f * std::numeric_limits<float>::epsilon() *
      std::max(tree_.box(1).low.abs().maxCoeff(), tree_.box(1).high.abs().maxCoeff()))
, progress_(progress)
, states_(tree_.size() * PointBlock::capacity, State{infinity, infinity, -1, 0, 0})
, rivals_(tree_.size())
, likely_(tree_.size(), -1)
, upper_(2 * tree_.size(), infinity)
, slot_of_point_(points.size())
, marks_(states_.size(), 0)
{
  parallelFor(tree_.size(), 256, threads_, progress, {}, [&](auto begin, auto end) {
    for (std::size_t b = begin; b < end; ++b)
      for (int row = 0; row < tree_.block(b).count; ++row)
        slot_of_point_[static_cast<std::size_t>(tree_.block(b).index[row])] =
            static_cast<std::int32_t>(slotOf(b, row));
  });
  mark(options.isolated, isolated);
}

void
BlockGroups::mark(const pcl::Indices& points, std::uint8_t marks)
{
  for (const pcl::index_t point : points)
    marks_[static_cast<std::size_t>(slot_of_point_[static_cast<std::size_t>(point)])] =
        marks;
}

void
BlockGroups::restore(const SeedProposal& proposal)
{
  for (const pcl::index_t seed : proposal.seeds)
    seeds_.push_back(seedAt(seed));
  const auto all = static_cast<std::int32_t>(seeds_.size());
  for (std::size_t i = 0; i < slot_of_point_.size(); ++i)
    states_[static_cast<std::size_t>(slot_of_point_[i])] = {
        proposal.cid[i], proposal.cid[i], proposal.group[i], all, all};
  for (std::size_t b = 0; b < tree_.size(); ++b) {
    float& upper = upper_[tree_.nodeOfBlock(b)];
    upper = 0.0f;
    for (int row = 0; row < tree_.block(b).count; ++row)
      upper = std::max(upper, states_[slotOf(b, row)].cid);
  }
  for (std::size_t node = tree_.size() - 1; node > 0; --node)
    upper_[node] = std::max(upper_[2 * node], upper_[2 * node + 1]);
}

void
BlockGroups::setCandidates(const pcl::Indices& candidates)
{
  for (std::uint8_t& marks : marks_)
    marks |= barred;
  for (const pcl::index_t candidate : candidates)
    marks_[static_cast<std::size_t>(
        slot_of_point_[static_cast<std::size_t>(candidate)])] &= isolated;
}

void
BlockGroups::addSeed(pcl::index_t seed, std::size_t to_come, ProgressSpan span)
{
  const Seed s = seedAt(seed);
  seeds_.push_back(s);
  to_come_ = to_come;
  std::size_t subtrees = 1;
  while (2 * subtrees <= std::min(tree_.size(), most_subtrees))
    subtrees *= 2;
  parallelFor(
      subtrees, 1, threads_, progress_, span, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
          compareBelow(subtrees + k, s, order_.last() / 2);
      });
  for (std::size_t node = subtrees - 1; node > 0; --node)
    upper_[node] = std::max(upper_[2 * node], upper_[2 * node + 1]);
}

/** Whether the seed has lost every point below a node.
 *  \param[in,out] hint the sample to try first, and the one that came nearest to it */
bool
BlockGroups::compareNode(std::size_t node, const Seed& seed, std::size_t& hint) const
{
  const float worst = upper_[node];
  const Eigen::Vector3f centre = tree_.box(node).centre();
  const float radius = tree_.box(node).radius();
  if (worst == infinity || 2.0f * radius > (centre - seed.position).norm())
    return false; // too coarse to tell
  const PairCost least = costs_.least(node, seed.index);
  const SegmentSamples segment(seed.position, centre, order_.samples());
  float largest = -infinity;
  std::size_t largest_at = hint;
  const auto loses = [&](std::size_t l) {
    const float low =
        grid_.lowerBound(segment.at(l)) - segment.slack - segment.fraction(l) * radius;
    if (low > largest) {
      largest = low;
      largest_at = l;
    }
    return least.of(low) >= worst;
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
BlockGroups::compareBelow(std::size_t node, const Seed& seed, std::size_t hint)
{
  if (tree_.isBlock(node)) {
    compareBlock(node, seed, hint);
    return;
  }
  const bool spares_many = !tree_.isBlock(2 * node);
  if (spares_many && compareNode(node, seed, hint))
    return;
  compareBelow(2 * node, seed, hint);
  compareBelow(2 * node + 1, seed, hint);
  upper_[node] = std::max(upper_[2 * node], upper_[2 * node + 1]);
}

void
BlockGroups::compareBlock(std::size_t node, const Seed& seed, std::size_t hint)
{
  const float worst = upper_[node];
  const Eigen::Vector3f centre = tree_.box(node).centre();
  const float radius = tree_.box(node).radius();
  const PairCost least = costs_.least(node, seed.index);
  const SegmentSamples segment(seed.position, centre, order_.samples());
  thread_local Eigen::ArrayXf storage;
  SampleCaps caps(segment, order_, storage);
  caps.reset();
  Rival rival{static_cast<std::int32_t>(seeds_.size()) - 1, 0.0f, 0.0f, hint};
  const auto loses = [&](std::size_t l) {
    const float reach = segment.fraction(l) * radius + segment.slack;
    const DistanceGrid::Look look = grid_.look(segment.at(l));
    if (look.bounds.low - reach > rival.low) {
      rival.low = look.bounds.low - reach;
      rival.hint = l;
    }
    rival.high = std::max(rival.high, look.bounds.high + reach);
    if (least.of(rival.low) >= worst)
      return true;
    caps.lower(look.point, l, neighboring_samples);
    return false;
  };
  if (loses(hint) || loses(order_.last()))
    return;
  if (!own_tree_) // the seed is its own nearest point
    caps.lower(seed.position, 0, neighboring_samples);
  else if (loses(0))
    return;
  for (const SampleOrder::Level& level : order_.levels())
    for (const std::size_t l : level)
      if (caps[l] >= caps.squareOf(rival.high - segment.fraction(l) * radius) &&
          loses(l))
        return;

  rival.low = least.of(rival.low);
  rival.high = costs_.most(node, seed.index).of(rival.high);
  upper_[node] = std::min(worst, rival.high);
  std::vector<Rival>& rivals = rivals_[node - tree_.size()];
  const auto beaten = [limit = upper_[node]](const Rival& r) { return r.low > limit; };
  rivals.erase(std::remove_if(rivals.begin(), rivals.end(), beaten), rivals.end());
  rivals.push_back(rival);
}

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
 *  the points of S; one that is as near as that would gain nothing by being a seed. */
bool
BlockGroups::gains(std::size_t b, int row) const
{
  const Target point = target(b, row);
  return states_[slotOf(b, row)].cid >
         costs_.between(point.index, point.index).of(field_.distance(point.position));
}

/** The point of a block with the largest D_min, or product of that and its factor of a
 *  draw, if that is at least \a floor. */
BlockGroups::Farthest
BlockGroups::settle(std::size_t b, float floor, const Query& query)
{
  const PointBlock& block = tree_.block(b);
  const int left_out = query.seeds ? isolated | barred : isolated;
  std::array<float, PointBlock::capacity> factor;
  for (int row = 0; row < block.count; ++row)
    factor[static_cast<std::size_t>(row)] =
        query.draw ? query.draw->factor(target(b, row).index) : 1.0f;
  float& upper = upper_[tree_.nodeOfBlock(b)];
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
    if (state.decided < static_cast<std::int32_t>(seeds_.size())) {
      const float least =
          PairCost{factor[static_cast<std::size_t>(best)]}.cidBelow(floor);
      Closeness closest = fallsShort(b, best, least);
      if (closest.number < 0) {
        decide(b, best, true);
        closest = closenessOf(target(b, best), state);
      }
      likely_[b] = closest.number;
      shareWithNeighbors(b, best, closest);
    }
    else if (query.seeds && !gains(b, best))
      marks_[slotOf(b, best)] |= barred;
    else
      return {largest, block.index[best]};
  }
}

/** The CID to a seed changes from point to point by no more than they are apart: so do
 *  the samples, and d is 1-Lipschitz. What one point of a block has found out bounds
 *  D_min of the others. */
void
BlockGroups::shareWithNeighbors(std::size_t b, int row, const Closeness& closest)
{
  constexpr float rounding = 1.00001f;
  const PointBlock& block = tree_.block(b);
  const Eigen::Array<float, PointBlock::capacity, 1> cid =
      (block.squaredDistances(block.point(row)).sqrt() + closest.cid) * rounding +
      slack_;
  const Seed& seed = seeds_[static_cast<std::size_t>(closest.number)];
  for (int other = 0; other < block.count; ++other) {
    float& high = states_[slotOf(b, other)].high;
    const auto index = static_cast<std::size_t>(block.index[other]);
    high = std::min(high, costs_.between(seed.index, index).of(cid[other]));
  }
}

/** The blocks that may hold a point with a D_min of at least \a floor, neighbours
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
    if (tree_.isBlock(node))
      blocks.push_back(node - tree_.size());
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
                           const float upper_a = upper_[tree_.nodeOfBlock(a)];
                           const float upper_b = upper_[tree_.nodeOfBlock(b)];
                           return upper_a > upper_b || (upper_a == upper_b && a < b);
                         });
  return best;
}

/** Settle blocks side by side.
 *  \param[in] blocks each once
 *  \param[in] best of all others so far
 *  \return the best of these, too */
BlockGroups::Farthest
BlockGroups::settleAll(const std::vector<std::size_t>& blocks,
                       const Query& query,
                       ProgressSpan span,
                       Farthest best)
{
  std::vector<Farthest> found(blocks.size());
  std::atomic<float> reached{std::max(best.value, 0.0f)};
  const int team = blocks.size() < 4 * blocks_at_once ? 1 : threads_;
  parallelFor(blocks.size(),
              blocks_at_once,
              team,
              progress_,
              span,
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end; ++k) {
                  const float floor = reached;
                  if (upper_[tree_.nodeOfBlock(blocks[k])] < floor / query.most())
                    continue;
                  found[k] = settle(blocks[k], floor, query);
                  float so_far = reached;
                  while (found[k].value > so_far &&
                         !reached.compare_exchange_weak(so_far, found[k].value))
                    ;
                }
              });
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    updateAbove(tree_.nodeOfBlock(blocks[k]));
    const bool tied = found[k].value == best.value && found[k].point < best.point;
    if (found[k].value > best.value || tied)
      best = found[k];
  }
  return best;
}

/** The most promising blocks first: they give a value that most others fall short of.
 */
BlockGroups::Farthest
BlockGroups::argmax(const Query& query, ProgressSpan span)
{
  std::size_t node = 1;
  while (!tree_.isBlock(node))
    node = upper_[2 * node] >= upper_[2 * node + 1] ? 2 * node : 2 * node + 1;
  Farthest best = settleAll({node - tree_.size()}, query, span, {});
  const auto rest = [&] {
    return blocksAbove(std::max(best.value, 0.0f) / query.most());
  };
  best = settleAll(mostPromising(rest()), query, span, best);
  return settleAll(rest(), query, span, best);
}

float
BlockGroups::coverage(ProgressSpan span)
{
  return argmax({false}, span).value;
}

BlockGroups::Farthest
BlockGroups::farthest(ProgressSpan span)
{
  return argmax({true}, span);
}

BlockGroups::Farthest
BlockGroups::draw(const SoftDraw& draw, ProgressSpan span)
{
  return argmax({true, &draw}, span);
}

void
BlockGroups::finish(ProgressSpan span, bool keep_cid, SeedProposal& proposal)
{
  proposal.group.resize(slot_of_point_.size());
  proposal.cid.resize(keep_cid ? slot_of_point_.size() : 0);
  parallelFor(tree_.size(), 8, threads_, progress_, span, [&](auto begin, auto end) {
    for (std::size_t b = begin; b < end; ++b)
      for (int row = 0; row < tree_.block(b).count; ++row) {
        decide(b, row, keep_cid);
        const State& state = states_[slotOf(b, row)];
        const std::size_t i = target(b, row).index;
        proposal.group[i] = state.group;
        if (keep_cid)
          proposal.cid[i] = state.cid;
      }
  });
}

} // namespace pcl_cid
