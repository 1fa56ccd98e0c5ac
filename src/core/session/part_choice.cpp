/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts as nodes of a merge tree, or of what was joined by hand.
 */

#include "part_choice.h"

#include <algorithm>
#include <utility>

namespace pcl_cid {

bool
isLower(const PartChoice& a, const PartChoice& b)
{
  return a.node->lowest_group < b.node->lowest_group;
}

std::vector<int>
groupsOf(const PartNode& root)
{
  std::vector<int> groups;
  std::vector<const PartNode*> open{&root};
  while (!open.empty()) {
    const PartNode& node = *open.back();
    open.pop_back();
    if (!node.first)
      groups.push_back(node.lowest_group);
    else
      open.insert(open.end(), {node.first.get(), node.second.get()});
  }
  std::sort(groups.begin(), groups.end());
  return groups;
}

PartChoices
cut(const MergeTree& tree, std::size_t parts)
{
  std::vector<std::shared_ptr<const PartNode>> at(
      tree.numberOfGroups()); // by lowest group; null: merged
  for (std::size_t k = 0; k < at.size(); ++k)
    at[k] = std::make_shared<PartNode>(PartNode{static_cast<int>(k)});
  for (std::size_t k = 0; k < at.size() - parts; ++k) {
    const MergeStep& step = tree.steps()[k];
    std::shared_ptr<const PartNode>& first = at[static_cast<std::size_t>(step.first)];
    std::shared_ptr<const PartNode>& second = at[static_cast<std::size_t>(step.second)];
    first = std::make_shared<PartNode>(
        PartNode{step.first, step.height, std::move(first), std::move(second)});
    second.reset();
  }
  PartChoices choices;
  for (std::shared_ptr<const PartNode>& node : at)
    if (node)
      choices.push_back({std::move(node)});
  return choices;
}

std::size_t
partsAtElbow(const MergeTree& tree)
{
  const std::vector<int> part = tree.cutAtElbow();
  return static_cast<std::size_t>(*std::max_element(part.begin(), part.end())) + 1;
}

void
copyMarks(const PartChoices& from, PartChoices& to)
{
  for (PartChoice& choice : to) {
    const auto same = std::lower_bound(from.begin(), from.end(), choice, isLower);
    if (same == from.end() || groupsOf(*same->node) != groupsOf(*choice.node))
      continue;
    choice.dropped = same->dropped;
    choice.exact = same->exact;
  }
}

} // namespace pcl_cid
