/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithm 1: seeds by farthest-first traversal in CID, and the group of each point.
 */

#include "seed_proposal.h"

#include <algorithm>

namespace pcl_cid {
namespace {

/** The share of the progress that the seeds take; the rest is for the last decisions.
 */
constexpr double seeds_share = 0.6;

} // namespace

ProposalStop
Traversal::run(pcl::index_t start, const TraversalOptions& options)
{
  if (groups_.numberOfSeeds() == 0)
    addSeed(start, 0, options.seeds);             // "S_l <- {p*}"
  while (coverage_ > options.coverage) {          // ours
    if (groups_.numberOfSeeds() >= options.seeds) // Algorithm 1, "while"
      return ProposalStop::seeds;
    const pcl::index_t farthest = next(options);
    if (farthest < 0)
      return ProposalStop::no_gain;
    addSeed(farthest, groups_.numberOfSeeds(), options.seeds);
  }
  // Coverage 0 is no stop: whoever reaches it has no point left that would gain.
  return options.coverage > 0.0f                   ? ProposalStop::coverage
         : groups_.numberOfSeeds() < options.seeds ? ProposalStop::no_gain
                                                   : ProposalStop::seeds;
}

void
Traversal::addSeed(pcl::index_t seed, std::size_t rank, std::size_t planned)
{
  planned_ = std::max(planned, groups_.numberOfSeeds() + 1);
  groups_.addSeed(seed, rank, planned_ - groups_.numberOfSeeds() - 1, work_, step());
  coverage_ = groups_.coverage(work_, step());
  coverages_.push_back(coverage_);
}

/** "p* <- argmax D_min": the next seed, -1 when no candidate would gain by being one.
 */
pcl::index_t
Traversal::next(const TraversalOptions& options)
{
  if (options.rule == SeedingRule::farthest)
    return groups_.farthest(work_, step()).point;
  const SoftDraw draw(options.random_seed, groups_.numberOfSeeds());
  return groups_.draw(draw, work_, step()).point;
}

void
Traversal::finish(bool exactly)
{
  groups_.decideAll(exactly, work_, {planned_ > 0 ? seeds_share : 0.0, 1.0});
}

ProgressSpan
Traversal::step() const
{
  const auto done = static_cast<double>(groups_.numberOfSeeds());
  const auto all = static_cast<double>(std::max<std::size_t>(planned_, 1));
  const double fraction = seeds_share * std::min(done / all, 1.0);
  return {fraction, fraction};
}

} // namespace pcl_cid
