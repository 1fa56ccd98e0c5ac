/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithms 1 and 2 on bare points.
 */

#include "seeds_on_points.h"

#include "grouping/seed_proposal.h"

#include <limits>

namespace pcl_cid::test {
namespace {

WorkingPoints::Place
placeOf(const DistanceField& field,
        const Points& points,
        const std::optional<WorkingPoints::Place>& given)
{
  if (given)
    return *given;
  if (field.size() != points.size())
    return WorkingPoints::Place::anywhere;
  const BlockTree& tree = field.blocks();
  for (std::size_t b = 0; b < tree.size(); ++b)
    for (int row = 0; row < tree.block(b).count; ++row)
      if (points[static_cast<std::size_t>(tree.block(b).index[row])] !=
          tree.block(b).point(row))
        return WorkingPoints::Place::anywhere;
  return WorkingPoints::Place::are_surface;
}

/** Groups on bare points, and the traversals that change them. */
class Groups {
public:
  Groups(const DistanceField& field,
         const Points& points,
         const GroupingOptions& options)
  : options_(options)
  , progress_(options.execution.progress)
  , work_{threadCount(options.execution.threads), progress_}
  , points_(field,
            points,
            placeOf(field, points, options.place),
            options.costs,
            work_.threads,
            progress_)
  , groups_(points_, options.samples)
  {
    groups_.setIsolated(options.isolated);
  }

  void
  setCandidates(const pcl::Indices& candidates)
  {
    if (!candidates.empty())
      groups_.setCandidates(candidates);
  }

  void
  propose(pcl::index_t start, const SeedProposalOptions& options)
  {
    Traversal traversal = makeTraversal();
    traversal.run(start,
                  {options.seeds, options.coverage, options.rule, options.random_seed});
    takeOver(traversal);
  }

  void
  add(const pcl::Indices& seeds)
  {
    Traversal traversal = makeTraversal();
    const std::size_t planned = groups_.numberOfSeeds() + seeds.size();
    for (const pcl::index_t seed : seeds)
      traversal.addSeed(seed, groups_.numberOfSeeds(), planned);
    takeOver(traversal);
  }

  SeedProposal
  proposal() const
  {
    SeedProposal proposal{groups_.seeds(), groups_.groups(work_), {}, coverage_};
    if (options_.keep_cid)
      proposal.cid = groups_.cids(work_);
    return proposal;
  }

private:
  Traversal
  makeTraversal()
  {
    const float coverage =
        coverage_.empty() ? std::numeric_limits<float>::quiet_NaN() : coverage_.back();
    return Traversal(groups_, coverage, work_);
  }

  void
  takeOver(Traversal& traversal)
  {
    traversal.finish(options_.keep_cid);
    coverage_.insert(
        coverage_.end(), traversal.coverages().begin(), traversal.coverages().end());
  }

  const GroupingOptions& options_;
  Progress progress_;
  BlockGroups::Work work_;
  WorkingPoints points_;
  BlockGroups groups_;
  std::vector<float> coverage_;
};

} // namespace

SeedProposal
proposeSeeds(const DistanceField& field,
             const Points& points,
             pcl::index_t start,
             const SeedProposalOptions& options)
{
  Groups groups(field, points, options);
  groups.setCandidates(options.candidates);
  groups.propose(start, options);
  return groups.proposal();
}

SeedProposal
groupBySeeds(const DistanceField& field,
             const Points& points,
             const pcl::Indices& seeds,
             const GroupingOptions& options)
{
  Groups groups(field, points, options);
  groups.add(seeds);
  return groups.proposal();
}

void
extendProposal(const DistanceField& field,
               const Points& points,
               const SeedProposalOptions& options,
               SeedProposal& proposal)
{
  Groups groups(field, points, options);
  groups.setCandidates(options.candidates);
  groups.add(proposal.seeds);
  groups.propose(proposal.seeds.front(), options);
  proposal = groups.proposal();
}

void
addSeeds(const DistanceField& field,
         const Points& points,
         const pcl::Indices& seeds,
         const GroupingOptions& options,
         SeedProposal& proposal)
{
  Groups groups(field, points, options);
  groups.add(proposal.seeds);
  groups.add(seeds);
  proposal = groups.proposal();
}

MergeTree
mergeGroups(const DistanceField& field,
            const Points& points,
            const std::vector<pcl::index_t>& group,
            std::size_t groups,
            const GroupMergingOptions& options)
{
  Progress progress(options.execution.progress);
  const WorkingPoints working(field,
                              points,
                              placeOf(field, points, options.place),
                              options.costs,
                              threadCount(options.execution.threads),
                              progress);
  return pcl_cid::mergeGroups(working, group, groups, options);
}

} // namespace pcl_cid::test
