/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithm 1: seeds by farthest-first traversal in CID, and the group of each point.
 */

#include "parallel_for.h"
#include "validation.h"

#include <pcl_cid/core/concavity.h>
#include <pcl_cid/core/seed_proposal.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl_cid {
namespace {

constexpr std::size_t grain = 256;

/** The state of Algorithm 1: D_min and its argument for every point. */
class Traversal {
public:
  Traversal(const DistanceField& field,
            const Points& points,
            int samples,
            const ExecutionOptions& execution,
            SeedProposal proposal)
  : field_(field)
  , points_(points)
  , samples_(samples)
  , threads_(threadCount(execution.threads))
  , progress_(execution.progress)
  , proposal_(std::move(proposal))
  {
    proposal_.group.resize(points.size(), -1);
    proposal_.cid.resize(points.size(), std::numeric_limits<float>::infinity());
  }

  /** Take in a seed: it wins every point to which its CID is smaller than that of all
   *  earlier seeds. A seed that is given up (pointCID at its limit) has lost. */
  void
  addSeed(pcl::index_t seed, std::size_t planned)
  {
    const auto number = static_cast<pcl::index_t>(proposal_.seeds.size());
    const Eigen::Vector3f s = points_[static_cast<std::size_t>(seed)];
    forAllPoints(progressSpan(planned), [&](std::size_t i) {
      const float cid = pointCID(field_, points_[i], s, samples_, proposal_.cid[i]);
      if (cid < proposal_.cid[i]) {
        proposal_.cid[i] = cid;
        proposal_.group[i] = number;
      }
    });
    proposal_.seeds.push_back(seed);
    proposal_.coverage.push_back(
        *std::max_element(proposal_.cid.begin(), proposal_.cid.end()));
  }

  /** The next seed: argmax of D_min, lowest index first; -1 when no candidate would
   * gain by being a seed itself. */
  pcl::index_t
  farthest(const pcl::Indices& candidates)
  {
    pcl::index_t best = argmax(candidates);
    // A point cannot come nearer to any seed than CID_p(p, p) = d(p; S). For the points
    // of S that is 0; the distances of all the others are needed only once one is the
    // farthest.
    if (best >= 0 && own_cid_.empty() && !gains(best)) {
      own_cid_.resize(points_.size());
      forAllPoints({1.0, 1.0},
                   [&](std::size_t i) { own_cid_[i] = field_.distance(points_[i]); });
      best = argmax(candidates);
    }
    return best;
  }

  SeedProposal&
  proposal()
  {
    return proposal_;
  }

private:
  template <typename Visit>
  void
  forAllPoints(ProgressSpan span, const Visit& visit)
  {
    parallelFor(points_.size(),
                grain,
                threads_,
                progress_,
                span,
                [&](std::size_t begin, std::size_t end) {
                  for (std::size_t i = begin; i < end; ++i)
                    visit(i);
                });
  }

  bool
  gains(pcl::index_t point) const
  {
    const auto i = static_cast<std::size_t>(point);
    const float own = own_cid_.empty() ? field_.distance(points_[i]) : own_cid_[i];
    return proposal_.cid[i] > own;
  }

  pcl::index_t
  argmax(const pcl::Indices& candidates) const
  {
    pcl::index_t best = -1;
    float largest = 0.0f;
    const auto consider = [&](pcl::index_t point) {
      const float cid = proposal_.cid[static_cast<std::size_t>(point)];
      const bool farther = cid > largest || (cid == largest && point < best);
      if (farther && (own_cid_.empty() || gains(point))) {
        largest = cid;
        best = point;
      }
    };
    if (candidates.empty())
      for (std::size_t i = 0; i < points_.size(); ++i)
        consider(static_cast<pcl::index_t>(i));
    else
      for (const pcl::index_t point : candidates)
        consider(point);
    return best;
  }

  ProgressSpan
  progressSpan(std::size_t planned) const
  {
    const auto done = static_cast<double>(proposal_.seeds.size());
    const auto all = static_cast<double>(std::max<std::size_t>(planned, 1));
    return {std::min(done / all, 1.0), std::min((done + 1.0) / all, 1.0)};
  }

  const DistanceField& field_;
  const Points& points_;
  int samples_;
  int threads_;
  Progress progress_;
  SeedProposal proposal_;
  std::vector<float> own_cid_; ///< CID_p(p, p) of each point; empty until needed
};

/** The loop of Algorithm 1, from whatever seeds the traversal holds. */
void
traverse(Traversal& traversal, const SeedProposalOptions& options)
{
  const SeedProposal& proposal = traversal.proposal();
  while (proposal.seeds.size() < options.seeds &&       // Algorithm 1, "while"
         proposal.coverage.back() > options.coverage) { // ours
    const pcl::index_t next = traversal.farthest(options.candidates); // "argmax"
    if (next < 0)
      break;
    traversal.addSeed(next, options.seeds); // "D[p, q]", "D_min", "S_l U {p*}"
  }
}

void
check(const Points& points, const SeedProposalOptions& options)
{
  requirePoints(points);
  requireSamples(options.samples);
  requireAtLeast("number of seeds", options.seeds, std::size_t{1});
  requireNotNegative("coverage", options.coverage, "metres");
  for (const pcl::index_t candidate : options.candidates)
    requireIndex("seed candidate", candidate, points.size());
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
  Traversal traversal(field, points, options.samples, options.execution, {});
  traversal.addSeed(start, options.seeds); // "S_l <- {p*}"
  traverse(traversal, options);
  return std::move(traversal.proposal());
}

SeedProposal
groupBySeeds(const DistanceField& field,
             const Points& points,
             const pcl::Indices& seeds,
             int samples,
             const ExecutionOptions& execution)
{
  requirePoints(points);
  requireSamples(samples);
  requireAtLeast("number of seeds", seeds.size(), std::size_t{1});
  for (const pcl::index_t seed : seeds)
    requireIndex("seed", seed, points.size());
  Traversal traversal(field, points, samples, execution, {});
  for (const pcl::index_t seed : seeds)
    traversal.addSeed(seed, seeds.size());
  return std::move(traversal.proposal());
}

void
extendProposal(const DistanceField& field,
               const Points& points,
               const SeedProposalOptions& options,
               SeedProposal& proposal)
{
  check(points, options);
  if (proposal.seeds.empty() || proposal.group.size() != points.size())
    throw CIDException("the proposal to extend holds " +
                       std::to_string(proposal.seeds.size()) + " seeds of " +
                       std::to_string(proposal.group.size()) +
                       " points; it must be a finished one of the same " +
                       std::to_string(points.size()) + " points");
  Traversal traversal(field, points, options.samples, options.execution, proposal);
  traverse(traversal, options);
  proposal = std::move(traversal.proposal());
}

} // namespace pcl_cid
