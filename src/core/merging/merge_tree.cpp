/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The dendrogram of Algorithm 2 and its cuts.
 */

#include "base/requirements.h"

#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/settings.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl_cid {

MergeTree::MergeTree(std::vector<std::size_t> group_sizes,
                     std::vector<MergeStep> steps,
                     double known_height)
: group_sizes_(std::move(group_sizes))
, steps_(std::move(steps))
, known_height_(known_height)
{
}

std::vector<int>
MergeTree::cutAfterMerges(std::size_t merges) const
{
  if (numberOfGroups() > 0)
    requireKnown(std::min(merges, numberOfGroups() - 1) <= steps_.size(),
                 sentence("after ", merges, " merges"));
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

void
MergeTree::requireKnown(bool known, const std::string& cut) const
{
  if (!known)
    throw CIDException(sentence("the merge tree has ",
                                steps_.size(),
                                " of ",
                                numberOfGroups() - 1,
                                " merges, since it was stopped early; a cut ",
                                cut,
                                " needs more of them"));
}

std::vector<int>
MergeTree::cutAtParts(std::size_t parts) const
{
  requireAtLeast("number of parts", parts, std::size_t{1});
  const std::size_t groups = numberOfGroups();
  const std::size_t merges = groups > parts ? groups - parts : 0;
  requireKnown(merges <= steps_.size(), sentence("at ", parts, " parts"));
  return cutAfterMerges(merges);
}

std::vector<int>
MergeTree::cutAtHeight(double threshold) const
{
  require(setting::threshold, threshold);
  requireKnown(threshold <= known_height_, sentence("at ", threshold, " metres"));
  std::size_t merges = 0;
  while (merges < steps_.size() && steps_[merges].height <= threshold)
    ++merges;
  return cutAfterMerges(merges);
}

std::vector<int>
MergeTree::cutAtElbow() const
{
  constexpr std::size_t fewest_merges = 3; // two heights have no bend
  const auto all = static_cast<double>(numberOfGroups()) - 1.0;
  if (numberOfGroups() > 0)
    requireKnown(steps_.size() + 1 == numberOfGroups(), "at the elbow");
  if (steps_.size() < fewest_merges)
    return cutAfterMerges(0);
  const double lowest = steps_.front().height;
  const double range = steps_.back().height - lowest;
  if (!(range > 0.0))
    return cutAfterMerges(steps_.size()); // all merges cost the same
  std::size_t merges = 0;
  double deepest = 0.0;
  for (std::size_t n = 0; n < steps_.size(); ++n) {
    const double below_chord =
        static_cast<double>(n) / (all - 1.0) - (steps_[n].height - lowest) / range;
    if (below_chord > deepest) {
      deepest = below_chord;
      merges = n + 1;
    }
  }
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
  case MergeCut::Rule::merges:
    return cutAfterMerges(where.count);
  default:
    return cutAtElbow();
  }
}

} // namespace pcl_cid
