/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithm 2: groups merged by group CID, as a dendrogram that can be cut anywhere.
 */

#include "parallel_for.h"
#include "validation.h"

#include <pcl_cid/core/concavity.h>
#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/random.h>

#include <numeric>
#include <utility>

namespace pcl_cid {
namespace {

/** CID_g of every pair of groups; symmetric, the diagonal unused. */
class GroupMatrix {
public:
  explicit GroupMatrix(std::size_t groups) : groups_(groups), values_(groups * groups)
  {
  }

  double&
  operator()(std::size_t i, std::size_t j)
  {
    return values_[i * groups_ + j];
  }

  void
  set(std::size_t i, std::size_t j, double value)
  {
    (*this)(i, j) = value;
    (*this)(j, i) = value;
  }

  std::size_t
  size() const
  {
    return groups_;
  }

private:
  std::size_t groups_;
  std::vector<double> values_;
};

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

/** One point from each of \a count runs of equal length, or all of them. */
Points
stratifiedDraw(const Points& points,
               const pcl::Indices& members,
               std::size_t count,
               RandomGenerator& generator)
{
  Points drawn;
  const std::size_t runs = std::min(count, members.size());
  for (std::size_t run = 0; run < runs; ++run) {
    const std::size_t begin = run * members.size() / runs;
    const std::size_t end = (run + 1) * members.size() / runs;
    const std::size_t chosen = begin + drawBelow(generator, end - begin);
    drawn.push_back(points[static_cast<std::size_t>(members[chosen])]);
  }
  return drawn;
}

std::vector<Points>
drawFromGroups(const Points& points,
               const std::vector<pcl::Indices>& members,
               const GroupMergingOptions& options)
{
  RandomGenerator generator(options.random_seed);
  std::vector<Points> drawn;
  for (const pcl::Indices& group : members)
    drawn.push_back(stratifiedDraw(points, group, options.group_samples, generator));
  return drawn;
}

/** "D[G_i, G_j] <- CID_g(G_i, G_j | S)" of Algorithm 2, for all i < j. */
GroupMatrix
groupMatrix(const DistanceField& field,
            const std::vector<Points>& drawn,
            const GroupMergingOptions& options)
{
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    for (std::size_t j = i + 1; j < drawn.size(); ++j)
      pairs.emplace_back(i, j);
  GroupMatrix matrix(drawn.size());
  Progress progress(options.execution.progress);
  parallelFor(pairs.size(),
              1,
              threadCount(options.execution.threads),
              progress,
              {0.0, 1.0},
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end; ++k) {
                  const auto [i, j] = pairs[k];
                  matrix.set(
                      i, j, groupCID(field, drawn[i], drawn[j], options.samples));
                }
              });
  return matrix;
}

/** Average linkage: the merges that Algorithm 2 makes on the matrix, lowest first. */
class AverageLinkage {
public:
  AverageLinkage(GroupMatrix matrix, std::vector<std::size_t> sizes)
  : matrix_(std::move(matrix)), sizes_(std::move(sizes)), nearest_(matrix_.size())
  {
    alive_.resize(matrix_.size());
    std::iota(alive_.begin(), alive_.end(), std::size_t{0});
    for (std::size_t i = 0; i < matrix_.size(); ++i)
      findNearest(i);
  }

  std::vector<MergeStep>
  run()
  {
    std::vector<MergeStep> steps;
    while (alive_.size() > 1)
      steps.push_back(mergeClosest());
    return steps;
  }

private:
  /** "argmin D": each group knows its nearest of higher number, so one pass finds
   *  it. */
  MergeStep
  mergeClosest()
  {
    std::size_t i = alive_.front();
    for (std::size_t k = 0; k + 1 < alive_.size(); ++k)
      if (matrix_(alive_[k], nearest_[alive_[k]]) < matrix_(i, nearest_[i]))
        i = alive_[k];
    const std::size_t j = nearest_[i];
    const double height = matrix_(i, j);
    join(i, j);
    return {static_cast<int>(i), static_cast<int>(j), height, sizes_[i]};
  }

  /** "G_i <- G_i U G_j", "V <- V \ {G_j}": CID_g to the union of two groups is the mean
   *  of the CID_g to each, weighted with their sizes (Lance-Williams for Eq. 3). */
  void
  join(std::size_t i, std::size_t j)
  {
    alive_.erase(std::lower_bound(alive_.begin(), alive_.end(), j));
    const auto weight_i = static_cast<double>(sizes_[i]);
    const auto weight_j = static_cast<double>(sizes_[j]);
    for (const std::size_t k : alive_)
      if (k != i)
        matrix_.set(i,
                    k,
                    (weight_i * matrix_(i, k) + weight_j * matrix_(j, k)) /
                        (weight_i + weight_j));
    sizes_[i] += sizes_[j];
    for (const std::size_t k : alive_) {
      if (k == i || nearest_[k] == i || nearest_[k] == j)
        findNearest(k);
      else if (k < i && isNearer(k, i))
        nearest_[k] = i;
    }
  }

  bool
  isNearer(std::size_t k, std::size_t candidate)
  {
    const double now = matrix_(k, nearest_[k]);
    const double then = matrix_(k, candidate);
    return then < now || (then == now && candidate < nearest_[k]);
  }

  void
  findNearest(std::size_t k)
  {
    const auto later = std::upper_bound(alive_.begin(), alive_.end(), k);
    if (later == alive_.end())
      return;
    nearest_[k] = *later;
    for (auto other = later; other != alive_.end(); ++other)
      if (matrix_(k, *other) < matrix_(k, nearest_[k]))
        nearest_[k] = *other;
  }

  GroupMatrix matrix_;
  std::vector<std::size_t> sizes_;
  std::vector<std::size_t> alive_;   ///< groups not merged into another, ascending
  std::vector<std::size_t> nearest_; ///< of higher number; none for the last alive
};

} // namespace

MergeTree::MergeTree(std::vector<std::size_t> group_sizes, std::vector<MergeStep> steps)
: group_sizes_(std::move(group_sizes)), steps_(std::move(steps))
{
}

std::vector<int>
MergeTree::cutAfterMerges(std::size_t merges) const
{
  std::vector<int> joined_into(numberOfGroups());
  std::iota(joined_into.begin(), joined_into.end(), 0);
  for (std::size_t n = 0; n < std::min(merges, steps_.size()); ++n)
    joined_into[static_cast<std::size_t>(steps_[n].second)] = steps_[n].first;

  // A group joins one of lower number, so the part of that one is known already.
  std::vector<int> part(numberOfGroups());
  int parts = 0;
  for (std::size_t g = 0; g < part.size(); ++g) {
    const auto into = static_cast<std::size_t>(joined_into[g]);
    part[g] = into == g ? parts++ : part[into];
  }
  return part;
}

std::vector<int>
MergeTree::cutAtParts(std::size_t parts) const
{
  requireAtLeast("number of parts", parts, std::size_t{1});
  const std::size_t groups = numberOfGroups();
  return cutAfterMerges(groups > parts ? groups - parts : 0);
}

std::vector<int>
MergeTree::cutAtHeight(double threshold) const
{
  requireNotNegative("merge threshold", threshold, "metres");
  std::size_t merges = 0;
  while (merges < steps_.size() && steps_[merges].height <= threshold)
    ++merges;
  return cutAfterMerges(merges);
}

std::vector<int>
MergeTree::cut(const MergeCut& where) const
{
  switch (where.rule) {
  case MergeCut::Rule::parts:
    return cutAtParts(where.count);
  case MergeCut::Rule::threshold:
    return cutAtHeight(where.height);
  default:
    return cutAfterMerges(where.count);
  }
}

MergeTree
mergeGroups(const DistanceField& field,
            const Points& points,
            const std::vector<pcl::index_t>& group,
            std::size_t groups,
            const GroupMergingOptions& options)
{
  requirePoints(points);
  requireSamples(options.samples);
  requireAtLeast("number of samples of a group", options.group_samples, std::size_t{1});
  const std::vector<pcl::Indices> members = membersOfGroups(group, groups);
  std::vector<std::size_t> sizes;
  for (const pcl::Indices& of_group : members)
    sizes.push_back(of_group.size());

  const std::vector<Points> drawn = drawFromGroups(points, members, options);
  AverageLinkage linkage(groupMatrix(field, drawn, options), sizes); // Eq. 3
  return MergeTree(sizes, linkage.run());                            // Algorithm 2
}

} // namespace pcl_cid
