/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithm 2: groups merged by group CID, as a dendrogram that can be cut anywhere.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/core/smooth_patches.h>
#include <pcl_cid/pcl_cid_export.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief One merge of Algorithm 2. */
struct MergeStep {
  /** Numbers of the two that are joined, first < second. A joined group goes by its
   *  smallest group number, so the result is called `first`. */
  int first;
  int second;
  /** CID_g of the two, metres. */
  double height;
  /** Points in the result. */
  std::size_t size;
};

/** \brief Where a merge tree is cut: the three stops of Algorithm 2, and one that the
 *  tree itself proposes. */
struct MergeCut {
  enum class Rule {
    elbow,    ///< before the merges become expensive: cutAtElbow()
    merges,   ///< after `count` merges (T)
    parts,    ///< when `count` parts remain (K')
    threshold ///< when the smallest CID_g exceeds `height` metres
  };
  Rule rule = Rule::elbow;
  std::size_t count = 0;
  double height = 0.0;
};

/** \brief The whole history of Algorithm 2: K groups, K - 1 merges, lowest CID_g first.
 *
 *  CID_g is a mean over pairs (Eq. 3), so the merges are an average linkage, whose
 *  heights never fall (up to rounding): one dendrogram holds the result for every
 *  number of merges, number of parts and threshold (*ours*). A cut gives the number of
 *  the part of each group; parts are numbered 0, 1, ... by their lowest group. A tree
 *  that was stopped early refuses a cut that needs more merges than it has. */
class PCL_CID_EXPORT MergeTree {
public:
  /** \brief No groups. */
  MergeTree() = default;

  /** \param[in] group_sizes points in each of the K groups
   *  \param[in] steps the merges in order; at most K - 1
   *  \param[in] known_height no merge up to this height is missing, metres */
  MergeTree(std::vector<std::size_t> group_sizes,
            std::vector<MergeStep> steps,
            double known_height = std::numeric_limits<double>::infinity());

  /** \brief K. */
  std::size_t
  numberOfGroups() const
  {
    return group_sizes_.size();
  }

  /** \brief Points in each group, by group number. */
  const std::vector<std::size_t>&
  groupSizes() const
  {
    return group_sizes_;
  }

  /** \brief The merges in order. */
  const std::vector<MergeStep>&
  steps() const
  {
    return steps_;
  }

  /** \brief The part of each group after T merges, the stop of Algorithm 2.
   *  \param[in] merges T; more than there are means all of them */
  std::vector<int>
  cutAfterMerges(std::size_t merges) const;

  /** \brief The part of each group when K' parts remain (all groups when there are
   *  fewer).
   *  \param[in] parts K', at least 1
   *  \throws CIDException when it is 0 */
  std::vector<int>
  cutAtParts(std::size_t parts) const;

  /** \brief The part of each group when the smallest CID_g exceeds a threshold.
   *  \param[in] threshold metres, 0 or more
   *  \throws CIDException when it is negative or not a number */
  std::vector<int>
  cutAtHeight(double threshold) const;

  /** \brief The part of each group where the tree itself bends (*ours*): after the
   *  merges that cost little more than the first one, before those whose cost climbs.
   *
   *  Drawn over their number, the heights of the merges rise slowly while groups of one
   *  convex piece come together, and steeply once the pieces themselves have to. The
   *  cut is after the merge that is deepest below the straight line from the first to
   *  the last. It does not change with the unit of length; fewer than three merges have
   *  no bend, and none is made; when all cost the same, all are made.
   *  \throws CIDException when the tree was stopped early */
  std::vector<int>
  cutAtElbow() const;

  /** \brief The part of each group by whichever of the rules. */
  std::vector<int>
  cut(const MergeCut& where) const;

private:
  void
  requireKnown(bool known, const std::string& cut) const;

  std::vector<std::size_t> group_sizes_;
  std::vector<MergeStep> steps_;
  double known_height_ = std::numeric_limits<double>::infinity();
};

/** \brief How CID_g is estimated, and how far the merges go. */
struct MergingSettings {
  /** Points drawn from each group (G' in the paper), at least 1. The CID_g of two
   *  groups is the mean of as many pairs, or of all of them where there are no more:
   *  then it is exact. */
  std::size_t group_samples = setting::group_samples.initial;
  /** Where Algorithm 2 stops: when so many parts remain, at least 1, or when the
   *  smallest CID_g exceeds so many metres. The defaults make the whole tree, for which
   *  the CID_g of every pair is computed; a tree that stops early leaves most of them
   *  out. */
  std::size_t stop_at_parts = 1;
  double stop_at_height = std::numeric_limits<double>::infinity();

  bool
  operator==(const MergingSettings& other) const
  {
    return group_samples == other.group_samples &&
           stop_at_parts == other.stop_at_parts &&
           stop_at_height == other.stop_at_height;
  }

  /** \brief Whether all merges are made. */
  bool
  makesWholeTree() const
  {
    return stop_at_parts <= 1 &&
           stop_at_height == std::numeric_limits<double>::infinity();
  }

  /** \brief Stop where a cut of the whole tree would be; the elbow needs all of it.
   *  \param[in] cut where
   *  \param[in] groups K */
  void
  stopAt(const MergeCut& cut, std::size_t groups)
  {
    if (cut.rule == MergeCut::Rule::threshold)
      stop_at_height = cut.height;
    else if (cut.rule == MergeCut::Rule::parts)
      stop_at_parts = cut.count;
    else if (cut.rule == MergeCut::Rule::merges)
      stop_at_parts = groups - std::min(cut.count, groups - 1);
  }
};

/** \brief Algorithm 2 (group merging), run to the end or to the stop asked for.
 *
 *  The K x K matrix of CID_g is that of `group_samples` points of each group, which are
 *  spread over all of it, each in one pair for every other group (*ours*; Eq. 4 takes
 *  all pairs of random points, and is farther from Eq. 3 with eight times as many). A
 *  merge replaces two rows by their mean weighted with the true group sizes
 *  (Lance-Williams), which is what computing CID_g again would give. A pair of groups
 *  is compared exactly only when the next merge depends on it; certified lower bounds
 *  hold the others back (*ours*). Equal CID_g: the pair of lowest numbers first.
 *  \param[in] grouping its groups, M, costs and random seed; at least 1 seed. Sizes
 *  count the points that are worked on: those of the subsample where one was drawn
 *  \param[in] settings see MergingSettings
 *  \param[in] execution threads and progress; never change the result
 *  \throws CIDException for a setting out of its range, without seeds, or when a group
 *  has no point; CIDCancelled
 *  \note Cost: at most K^2 / 2 x group_samples CID evaluations, for the whole tree,
 *  O(K^2 log K), and O(N log group_samples) for the draw. O(K^2) memory. */
PCL_CID_EXPORT MergeTree
mergeGroups(const Grouping& grouping,
            const MergingSettings& settings = {},
            const ExecutionOptions& execution = {});

/** \brief The same for patches in the place of the groups of seeds (*ours*).
 *  \param[in] samples M */
PCL_CID_EXPORT MergeTree
mergeGroups(const SmoothPatches& patches,
            int samples = setting::samples.initial,
            const MergingSettings& settings = {},
            const ExecutionOptions& execution = {});

} // namespace pcl_cid
