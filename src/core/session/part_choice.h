/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts as nodes of a merge tree, or of what was joined by hand.
 */

#pragma once

#include <pcl_cid/core/group_merging.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace pcl_cid {

/** \brief A group, or two parts that were joined, by the tree or by hand. */
struct PartNode {
  int lowest_group = 0;
  std::optional<double> height{}; ///< CID_g, where the tree has joined them
  std::shared_ptr<const PartNode> first{};
  std::shared_ptr<const PartNode> second{};
};

/** \brief A part. */
struct PartChoice {
  std::shared_ptr<const PartNode> node;
  bool dropped = false;
  bool exact = false;
};

/** \brief By their lowest groups. */
using PartChoices = std::vector<PartChoice>;

bool
isLower(const PartChoice& a, const PartChoice& b);

/** \brief Ascending. */
std::vector<int>
groupsOf(const PartNode& root);

/** \brief What remains of the groups after as many merges as leave so many parts. */
PartChoices
cut(const MergeTree& tree, std::size_t parts);

/** \brief How many parts MergeTree::cutAtElbow() leaves. */
std::size_t
partsAtElbow(const MergeTree& tree);

/** \brief Take over the marks of parts of the same groups. */
void
copyMarks(const PartChoices& from, PartChoices& to);

} // namespace pcl_cid
