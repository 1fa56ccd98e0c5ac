/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithm 1: seeds by farthest-first traversal in CID, and the group of each
 * point.
 */

#include "base/requirements.h"
#include "block_groups.h"
#include "cid/node_costs.h"

#include <pcl_cid/core/seed_proposal.h>
#include <pcl_cid/core/settings.h>

#include <algorithm>
#include <set>
#include <utility>

namespace pcl_cid {
namespace {

/** The share of the progress that the seeds take; the rest is for the last
 *  decisions. */
constexpr double seeds_share = 0.6;

/** Algorithm 1 with its state, D_min of every point, in a BlockGroups. */
class Traversal {
public:
  Traversal(const DistanceField& field,
            const Points& points,
            const GroupingOptions& options)
  : progress_(options.execution.progress), groups_(field, points, options, progress_)
  {
  }

  /** Go on from a finished proposal. */
  void
  restore(const SeedProposal& proposal)
  {
    proposal_ = proposal;
    groups_.restore(proposal);
  }

  void
  setCandidates(const pcl::Indices& candidates)
  {
    if (!candidates.empty())
      groups_.setCandidates(candidates);
  }

  /** "D[p, q] <- CID_p(p, q)", "D_min", "S_l <- S_l U {p*}": each point goes to the
   *  seed if that is nearer than all before it.
   *  \param[in] planned seeds in all */
  void
  addSeed(pcl::index_t seed, std::size_t planned)
  {
    planned_ = std::max(planned, proposal_.seeds.size() + 1);
    groups_.addSeed(seed, planned_ - proposal_.seeds.size() - 1, step());
    proposal_.seeds.push_back(seed);
    proposal_.coverage.push_back(groups_.coverage(step()));
  }

  /** "p* <- argmax D_min": the next seed, -1 when no candidate would gain by being
   *  one. */
  pcl::index_t
  next(const SeedProposalOptions& options)
  {
    if (options.rule == SeedingRule::farthest)
      return groups_.farthest(step()).point;
    return groups_.draw({options.random_seed, proposal_.seeds.size()}, step()).point;
  }

  const SeedProposal&
  soFar() const
  {
    return proposal_;
  }

  /** Point grouping: the seed of every point. */
  SeedProposal
  finish(bool keep_cid)
  {
    groups_.finish({seeds_share, 1.0}, keep_cid, proposal_);
    return std::move(proposal_);
  }

private:
  ProgressSpan
  step() const
  {
    const auto done = static_cast<double>(proposal_.seeds.size());
    const auto all = static_cast<double>(std::max<std::size_t>(planned_, 1));
    const double fraction = seeds_share * std::min(done / all, 1.0);
    return {fraction, fraction};
  }

  Progress progress_;
  BlockGroups groups_;
  SeedProposal proposal_;
  std::size_t planned_ = 0;
};

/** The loop of Algorithm 1, from whatever seeds the traversal holds. */
void
traverse(Traversal& traversal, const SeedProposalOptions& options)
{
  while (traversal.soFar().seeds.size() < options.seeds &&       // Algorithm 1, "while"
         traversal.soFar().coverage.back() > options.coverage) { // ours
    const pcl::index_t next = traversal.next(options);
    if (next < 0)
      break;
    traversal.addSeed(next, options.seeds);
  }
}

void
check(const Points& points, const GroupingOptions& options)
{
  requirePoints(points);
  require(setting::samples, options.samples);
  if (options.costs)
    requireCosts(*options.costs, points.size());
  for (const pcl::index_t isolated : options.isolated)
    requireIndex("isolated point", isolated, points.size());
  const std::set<pcl::index_t> isolated(options.isolated.begin(),
                                        options.isolated.end());
  if (isolated.size() == points.size())
    throw CIDException(sentence(
        "all ", points.size(), " points are called isolated; at least 1 must not be"));
}

void
check(const Points& points, const SeedProposalOptions& options)
{
  check(points, static_cast<const GroupingOptions&>(options));
  requireAtLeast("number of seeds", options.seeds, std::size_t{1});
  require(setting::coverage, options.coverage);
  for (const pcl::index_t candidate : options.candidates)
    requireIndex("seed candidate", candidate, points.size());
}

void
check(const Points& points, const pcl::Indices& seeds, const GroupingOptions& options)
{
  check(points, options);
  requireAtLeast("number of seeds", seeds.size(), std::size_t{1});
  for (const pcl::index_t seed : seeds)
    requireIndex("seed", seed, points.size());
}

void
requireFinished(const SeedProposal& proposal, const Points& points)
{
  if (proposal.seeds.empty() || proposal.cid.size() != points.size())
    throw CIDException(
        sentence("the proposal to go on from has ",
                 proposal.seeds.size(),
                 " seeds and the CIDs of ",
                 proposal.cid.size(),
                 " points; it must be a finished one with the CIDs of all ",
                 points.size(),
                 " points"));
}

} // namespace

SeedProposal
proposeSeeds(const DistanceField& field,
             const Points& points,
             pcl::index_t start,
             const SeedProposalOptions& options)
{
  check(points, options);
  requireIndex("start index", start, points.size());
  Traversal traversal(field, points, options);
  traversal.setCandidates(options.candidates);
  traversal.addSeed(start, options.seeds); // "S_l <- {p*}"
  traverse(traversal, options);
  return traversal.finish(options.keep_cid);
}

SeedProposal
groupBySeeds(const DistanceField& field,
             const Points& points,
             const pcl::Indices& seeds,
             const GroupingOptions& options)
{
  check(points, seeds, options);
  Traversal traversal(field, points, options);
  for (const pcl::index_t seed : seeds)
    traversal.addSeed(seed, seeds.size());
  return traversal.finish(options.keep_cid);
}

void
extendProposal(const DistanceField& field,
               const Points& points,
               const SeedProposalOptions& options,
               SeedProposal& proposal)
{
  check(points, options);
  requireFinished(proposal, points);
  Traversal traversal(field, points, options);
  traversal.restore(proposal);
  traversal.setCandidates(options.candidates);
  traverse(traversal, options);
  proposal = traversal.finish(true);
}

void
addSeeds(const DistanceField& field,
         const Points& points,
         const pcl::Indices& seeds,
         const GroupingOptions& options,
         SeedProposal& proposal)
{
  check(points, seeds, options);
  requireFinished(proposal, points);
  Traversal traversal(field, points, options);
  traversal.restore(proposal);
  for (const pcl::index_t seed : seeds)
    traversal.addSeed(seed, proposal.seeds.size() + seeds.size());
  proposal = traversal.finish(true);
}

} // namespace pcl_cid
