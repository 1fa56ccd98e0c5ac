/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithm 2: groups merged by group CID, as a dendrogram that can be cut anywhere.
 */

#include "base/parallel_for.h"
#include "base/random.h"
#include "base/requirements.h"
#include "group_cids.h"
#include "group_draw.h"

#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/settings.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

namespace pcl_cid {
namespace {

std::vector<pcl::Indices>
membersOfGroups(const std::vector<pcl::index_t>& group, std::size_t groups)
{
  std::vector<pcl::Indices> members(groups);
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (group[i] < 0)
      continue;
    requireIndex("group number of a point", group[i], groups);
    members[static_cast<std::size_t>(group[i])].push_back(static_cast<pcl::index_t>(i));
  }
  for (std::size_t g = 0; g < groups; ++g)
    if (members[g].empty())
      throw CIDException(sentence(
          "group ", g, " has no point; group merging needs at least 1 in each"));
  return members;
}

/** "G'" of Eq. 4. */
std::vector<pcl::Indices>
drawFromGroups(const Points& points,
               std::vector<pcl::Indices> members,
               const GroupMergingOptions& options,
               Progress& progress)
{
  RandomGenerator generator(options.random_seed);
  std::vector<RandomGenerator::result_type> random_seeds(members.size());
  for (auto& random_seed : random_seeds)
    random_seed = generator();
  parallelForEach(members.size(),
                  threadCount(options.execution.threads),
                  progress,
                  {},
                  [&](std::size_t g) {
                    RandomGenerator of_group(random_seeds[g]);
                    members[g] = drawSpread(
                        points, std::move(members[g]), options.group_samples, of_group);
                  });
  return members;
}

/** Pairs of groups that are tightened in parallel, when the next merge depends on one.
 */
constexpr std::size_t most_at_once = 16;

/** Average linkage on values of which most are lower bounds: a value is tightened only
 *  when it is the smallest, so the merges are those of the exact matrix.
 *
 *  Clusters 0 .. K - 1 are the groups; each merge makes a new one. */
class AverageLinkage {
public:
  AverageLinkage(GroupCIDs& cids, const std::vector<std::size_t>& sizes)
  : cids_(cids), groups_(sizes.size()), known_(groups_ * groups_)
  {
    for (std::size_t g = 0; g < sizes.size(); ++g) {
      clusters_.push_back({g, sizes[g], none, none});
      alive_.push_back(g);
    }
    for (std::size_t i = 0; i < sizes.size(); ++i)
      for (std::size_t j = i + 1; j < sizes.size(); ++j) {
        known(i, j) = fromGroups(i, j);
        push(i, j);
      }
  }

  /** Merge until \a parts remain or nothing is below \a height. */
  std::vector<MergeStep>
  run(std::size_t parts, double height)
  {
    std::vector<MergeStep> steps;
    while (alive_.size() > std::max<std::size_t>(parts, 1)) {
      const Entry closest = findClosest(); // "argmin D"
      if (closest.value > height)
        break;
      steps.push_back(join(closest)); // "G_i <- G_i U G_j", "V <- V \\ {G_j}"
    }
    return steps;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  struct Cluster {
    std::size_t name;          ///< its lowest group
    std::size_t size;          ///< in points
    std::size_t first, second; ///< the clusters that it was made of
    bool alive = true;
  };

  /** CID_g of two clusters; a lower bound while not exact. */
  struct Entry {
    double value;
    bool exact;
    std::size_t a, b;           ///< clusters
    std::size_t name_a, name_b; ///< their names, the lower one first

    /** Comes later in the queue. At equal values bounds come first, since they may hide
     *  a pair of lower names; then the lowest names win. */
    bool
    operator<(const Entry& other) const
    {
      return std::tie(other.value, other.exact, other.name_a, other.name_b) <
             std::tie(value, exact, name_a, name_b);
    }
  };

  struct Linkage {
    double value;
    bool exact;
  };

  /** What is known of the CID_g of two clusters that are alive. */
  Linkage&
  known(std::size_t a, std::size_t b)
  {
    const auto names = std::minmax(clusters_[a].name, clusters_[b].name);
    return known_[names.first * groups_ + names.second];
  }

  /** CID_g to the union of two clusters is the mean of the CID_g to each, weighted with
   *  their sizes (Lance-Williams for Eq. 3). */
  Linkage
  toUnion(std::size_t first,
          const Linkage& to_first,
          std::size_t second,
          const Linkage& to_second) const
  {
    const auto weight_first = static_cast<double>(clusters_[first].size);
    const auto weight_second = static_cast<double>(clusters_[second].size);
    return {(weight_first * to_first.value + weight_second * to_second.value) /
                (weight_first + weight_second),
            to_first.exact && to_second.exact};
  }

  /** CID_g of two clusters from that of all pairs of their groups. The cluster that was
   *  made last is taken apart first: the order in which the merges added them up. */
  Linkage
  fromGroups(std::size_t a, std::size_t b) const
  {
    if (a < b)
      std::swap(a, b);
    const Cluster& made = clusters_[a];
    if (made.first == none)
      return {cids_.value({b, a}), cids_.isExact({b, a})};
    return toUnion(
        made.first, fromGroups(made.first, b), made.second, fromGroups(made.second, b));
  }

  /** The pairs of groups below two clusters whose CID_g is not known. */
  void
  collectUnknown(std::size_t a,
                 std::size_t b,
                 std::vector<GroupCIDs::Pair>& unknown) const
  {
    if (a < b)
      std::swap(a, b);
    if (clusters_[a].first != none) {
      collectUnknown(clusters_[a].first, b, unknown);
      collectUnknown(clusters_[a].second, b, unknown);
    }
    else if (!cids_.isExact({b, a}))
      unknown.push_back({b, a});
  }

  void
  push(std::size_t a, std::size_t b)
  {
    const Linkage between = known(a, b);
    const auto names = std::minmax(clusters_[a].name, clusters_[b].name);
    queue_.push({between.value, between.exact, a, b, names.first, names.second});
  }

  bool
  isCurrent(const Entry& entry) const
  {
    return clusters_[entry.a].alive && clusters_[entry.b].alive;
  }

  Entry
  findClosest()
  {
    for (;;) {
      std::vector<Entry> bounds;
      std::vector<GroupCIDs::Pair> unknown;
      while (!queue_.empty() && unknown.size() < most_at_once) {
        const Entry entry = queue_.top();
        if (isCurrent(entry) && entry.exact)
          break;
        queue_.pop();
        if (!isCurrent(entry))
          continue;
        collectUnknown(entry.a, entry.b, unknown);
        bounds.push_back(entry);
      }
      if (bounds.empty()) {
        const Entry closest = queue_.top();
        queue_.pop();
        return closest;
      }
      cids_.tighten(unknown);
      for (const Entry& entry : bounds) {
        known(entry.a, entry.b) = fromGroups(entry.a, entry.b);
        push(entry.a, entry.b);
      }
    }
  }

  MergeStep
  join(const Entry& closest)
  {
    clusters_[closest.a].alive = false;
    clusters_[closest.b].alive = false;
    const bool ordered = clusters_[closest.a].name == closest.name_a;
    const std::size_t first = ordered ? closest.a : closest.b;
    const std::size_t second = ordered ? closest.b : closest.a;
    const std::size_t size = clusters_[first].size + clusters_[second].size;
    const std::size_t made = clusters_.size();
    clusters_.push_back({closest.name_a, size, first, second});
    alive_.erase(std::remove_if(alive_.begin(),
                                alive_.end(),
                                [&](std::size_t c) { return !clusters_[c].alive; }),
                 alive_.end());
    for (const std::size_t other : alive_) {
      known(made, other) =
          toUnion(first, known(first, other), second, known(second, other));
      push(made, other);
    }
    alive_.push_back(made);
    return {static_cast<int>(closest.name_a),
            static_cast<int>(closest.name_b),
            closest.value,
            size};
  }

  GroupCIDs& cids_;
  std::size_t groups_;
  std::vector<Linkage> known_; ///< by the names of two clusters
  std::vector<Cluster> clusters_;
  std::vector<std::size_t> alive_;
  std::priority_queue<Entry> queue_;
};

/** The height up to which no merge is missing, even from a tree that was stopped. */
double
knownHeight(const std::vector<MergeStep>& steps,
            std::size_t groups,
            const GroupMergingOptions& options)
{
  if (steps.size() + 1 == groups)
    return std::numeric_limits<double>::infinity();
  if (groups - steps.size() > options.stop_at_parts)
    return options.stop_at_height;
  return steps.empty() ? 0.0 : std::nextafter(steps.back().height, 0.0);
}

GroupMergingOptions
optionsOf(const PreparedScan& scan,
          int samples,
          const MergingSettings& settings,
          const ExecutionOptions& execution)
{
  GroupMergingOptions options;
  static_cast<MergingSettings&>(options) = settings;
  options.samples = samples;
  options.random_seed = scan.settings().random_seed;
  options.execution = execution;
  return options;
}

} // namespace

MergeTree
mergeGroups(const WorkingPoints& points,
            const std::vector<pcl::index_t>& group,
            std::size_t groups,
            const GroupMergingOptions& options)
{
  require(setting::samples, options.samples);
  requireCount(setting::group_samples, options.group_samples);
  requireAtLeast("number of parts to stop at", options.stop_at_parts, std::size_t{1});
  if (!(options.stop_at_height >= 0.0))
    throw CIDException(sentence("the height to stop at is ",
                                options.stop_at_height,
                                "; it must be 0 metres or more"));
  std::vector<pcl::Indices> members = membersOfGroups(group, groups);
  std::vector<std::size_t> sizes;
  for (const pcl::Indices& of_group : members)
    sizes.push_back(of_group.size());

  Progress progress(options.execution.progress);
  GroupCIDs cids(points,
                 drawFromGroups(points.points(), std::move(members), options, progress),
                 options,
                 progress);
  AverageLinkage linkage(cids, sizes);
  std::vector<MergeStep> steps =
      linkage.run(options.stop_at_parts, options.stop_at_height);
  return MergeTree(sizes, steps, knownHeight(steps, groups, options));
}

MergeTree
mergeGroups(const Grouping& grouping,
            const MergingSettings& settings,
            const ExecutionOptions& execution)
{
  requireAtLeast("number of seeds", grouping.numberOfSeeds(), std::size_t{1});
  return mergeGroups(
      grouping.scan().working(),
      grouping.groupsOfWorkingPoints(partOf(execution, 0.0, 0.0)),
      grouping.numberOfSeeds(),
      optionsOf(grouping.scan(), grouping.settings().samples, settings, execution));
}

MergeTree
mergeGroups(const SmoothPatches& patches,
            int samples,
            const MergingSettings& settings,
            const ExecutionOptions& execution)
{
  return mergeGroups(patches.scan().working(),
                     patches.groupsOfWorkingPoints(),
                     patches.numberOfPatches(),
                     optionsOf(patches.scan(), samples, settings, execution));
}

} // namespace pcl_cid
