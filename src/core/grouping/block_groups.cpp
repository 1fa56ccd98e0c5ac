/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The nearest seed of every point: seeds come and go, points are decided.
 */

#include "block_groups.h"
#include "base/infinity.h"
#include "base/rounding.h"

#include <algorithm>

namespace pcl_cid {
namespace {

/** A seed is compared with this many subtrees in parallel. */
constexpr std::size_t most_subtrees = 1024;

/** Blocks that a thread looks through at a time. */
constexpr std::size_t many_blocks = 256;

/** Blocks whose points a thread decides at a time. */
constexpr std::size_t few_blocks = 8;

} // namespace

const BlockGroups::State BlockGroups::unknown = {infinity, infinity, -1, 0, 0};

BlockGroups::BlockGroups(const WorkingPoints& points, int samples)
: points_(points)
, order_(samples)
, slack_(rounding::ofTwoSamples(std::max(tree().box(1).low.abs().maxCoeff(),
                                         tree().box(1).high.abs().maxCoeff())))
, states_(tree().size() * PointBlock::capacity, unknown)
, rivals_(tree().size())
, likely_(tree().size(), -1)
, upper_(2 * tree().size(), infinity)
, marks_(states_.size(), 0)
, exact_(tree().size(), 0)
{
}

void
BlockGroups::setIsolated(const pcl::Indices& isolated_points)
{
  for (const pcl::index_t point : isolated_points)
    marks_[points_.slotOf(static_cast<std::size_t>(point))] |= isolated;
}

void
BlockGroups::setCandidates(const pcl::Indices& candidates)
{
  for (std::uint8_t& marks : marks_)
    marks |= no_candidate;
  for (const pcl::index_t point : candidates)
    marks_[points_.slotOf(static_cast<std::size_t>(point))] &=
        static_cast<std::uint8_t>(~no_candidate);
}

void
BlockGroups::clear() noexcept
{
  seeds_.clear();
  ranked_.clear();
  std::fill(states_.begin(), states_.end(), unknown);
  for (std::vector<Rival>& rivals : rivals_)
    rivals.clear();
  std::fill(likely_.begin(), likely_.end(), -1);
  std::fill(upper_.begin(), upper_.end(), infinity);
  std::fill(exact_.begin(), exact_.end(), std::uint8_t{0});
  for (std::uint8_t& marks : marks_)
    marks &= static_cast<std::uint8_t>(~no_gain);
}

pcl::Indices
BlockGroups::seeds() const
{
  pcl::Indices seeds;
  for (const std::int32_t id : ranked_)
    seeds.push_back(static_cast<pcl::index_t>(seed(id).point.index));
  return seeds;
}

void
BlockGroups::setRanks()
{
  for (std::size_t rank = 0; rank < ranked_.size(); ++rank)
    seeds_[static_cast<std::size_t>(ranked_[rank])].rank = rank;
}

void
BlockGroups::addSeed(pcl::index_t point,
                     std::size_t rank,
                     std::size_t to_come,
                     Work work,
                     ProgressSpan span)
{
  const auto index = static_cast<std::size_t>(point);
  const auto slot = static_cast<std::int32_t>(points_.slotOf(index));
  const Newcomer newcomer{
      {tree().position(slot), index}, endOfIds(), rank == ranked_.size()};
  seeds_.push_back({newcomer.point, rank});
  ranked_.insert(ranked_.begin() + static_cast<std::ptrdiff_t>(rank), newcomer.id);
  setRanks();
  to_come_ = to_come;

  // "D[p, q] <- CID_p(p, q)", for the new seed q, as far as it is needed
  std::size_t subtrees = 1;
  while (2 * subtrees <= std::min(tree().size(), most_subtrees))
    subtrees *= 2;
  parallelFor(subtrees,
              1,
              work.threads,
              work.progress,
              span,
              [&](std::size_t begin, std::size_t end) {
                Scratch scratch(*this);
                for (std::size_t k = begin; k < end; ++k)
                  compareBelow(subtrees + k, newcomer, order_.last() / 2, scratch);
              });
  for (std::size_t node = subtrees - 1; node > 0; --node)
    upper_[node] = std::max(upper_[2 * node], upper_[2 * node + 1]);
}

void
BlockGroups::removeSeeds(const std::vector<std::size_t>& ranks, bool exactly, Work work)
{
  std::vector<bool> removed(seeds_.size(), false);
  for (const std::size_t rank : ranks)
    removed[static_cast<std::size_t>(ranked_[rank])] = true;
  ranked_.erase(
      std::remove_if(ranked_.begin(),
                     ranked_.end(),
                     [&](auto id) { return removed[static_cast<std::size_t>(id)]; }),
      ranked_.end());
  setRanks();

  std::vector<std::uint8_t> touched(tree().size(), 0);
  const auto orphan_range = [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b)
      touched[b] = orphan(b, removed) ? 1 : 0;
  };
  parallelFor(
      tree().size(), many_blocks, work.threads, work.progress, {}, orphan_range);
  std::vector<std::size_t> blocks;
  for (std::size_t b = 0; b < tree().size(); ++b)
    if (touched[b])
      blocks.push_back(b);
  const auto adopt_range = [&](std::size_t begin, std::size_t end) {
    Scratch scratch(*this);
    for (std::size_t k = begin; k < end; ++k)
      adopt(blocks[k], exactly, scratch);
  };
  parallelFor(blocks.size(), few_blocks, work.threads, work.progress, {}, adopt_range);
  updateAllNodes();
}

/** Forget what is known of the points of a block whose seed is gone.
 *  \return whether there are any */
bool
BlockGroups::orphan(std::size_t b, const std::vector<bool>& removed)
{
  bool any = false;
  for (int row = 0; row < tree().block(b).count; ++row) {
    State& state = states_[slotOf(b, row)];
    if (!removed[static_cast<std::size_t>(state.group)])
      continue;
    state = unknown;
    marks_[slotOf(b, row)] &= static_cast<std::uint8_t>(~no_gain);
    any = true;
  }
  return any;
}

/** Compare the orphans of a block with all seeds, near ones first: they rule out most
 *  of the others. */
void
BlockGroups::adopt(std::size_t b, bool exactly, Scratch& scratch)
{
  const std::size_t node = tree().nodeOfBlock(b);
  upper_[node] = infinity;
  const Eigen::Vector3f center = tree().box(node).center();
  std::vector<std::pair<float, std::int32_t>> order;
  for (const std::int32_t id : ranked_)
    order.emplace_back((seed(id).point.position - center).squaredNorm(), id);
  std::sort(order.begin(), order.end());
  for (const auto& [squared_distance, id] : order)
    compareBlock(node, {seed(id).point, id, false}, order_.last() / 2, scratch);
  decideBlock(b, exactly, scratch);
}

void
BlockGroups::decideAll(bool exactly, Work work, ProgressSpan span)
{
  std::vector<std::size_t> open;
  for (std::size_t b = 0; b < tree().size(); ++b)
    if (!rivals_[b].empty() || (exactly && !exact_[b]))
      open.push_back(b);
  parallelFor(open.size(),
              few_blocks,
              work.threads,
              work.progress,
              span,
              [&](std::size_t begin, std::size_t end) {
                Scratch scratch(*this);
                for (std::size_t k = begin; k < end; ++k)
                  decideBlock(open[k], exactly, scratch);
              });
  updateAllNodes();
}

/** Decided points need no rivals any more, and later seeds begin with tight bounds. */
void
BlockGroups::decideBlock(std::size_t b, bool exactly, Scratch& scratch)
{
  float& upper = upper_[tree().nodeOfBlock(b)];
  upper = 0.0f;
  for (int row = 0; row < tree().block(b).count; ++row) {
    decide(b, row, exactly, scratch);
    upper = std::max(upper, states_[slotOf(b, row)].high);
  }
  rivals_[b].clear();
  exact_[b] = exactly;
}

void
BlockGroups::updateAllNodes()
{
  for (std::size_t node = tree().size() - 1; node > 0; --node)
    upper_[node] = std::max(upper_[2 * node], upper_[2 * node + 1]);
}

std::vector<pcl::index_t>
BlockGroups::groups(Work work) const
{
  std::vector<pcl::index_t> groups(points_.size());
  parallelFor(groups.size(),
              many_blocks * PointBlock::capacity,
              work.threads,
              work.progress,
              {1.0, 1.0},
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                  groups[i] = static_cast<pcl::index_t>(
                      seed(states_[points_.slotOf(i)].group).rank);
              });
  // The earlier seed keeps a point that is given twice.
  for (std::size_t rank = ranked_.size(); rank-- > 0;)
    groups[seed(ranked_[rank]).point.index] = static_cast<pcl::index_t>(rank);
  return groups;
}

std::vector<float>
BlockGroups::cids(Work work) const
{
  std::vector<float> cids(points_.size());
  parallelFor(cids.size(),
              many_blocks * PointBlock::capacity,
              work.threads,
              work.progress,
              {1.0, 1.0},
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                  cids[i] = states_[points_.slotOf(i)].low;
              });
  return cids;
}

} // namespace pcl_cid
