/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A cloud as approximately convex parts, one hull each.
 */

#pragma once

#include <pcl_cid/cid_base.h>
#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/group_merging.h>

#include <vector>

#include <pcl/PointIndices.h>

namespace pcl_cid {

/** \brief Abstraction (section IV.B of the paper): groups merged by group CID into
 *  approximately convex parts (Algorithm 2), one convex hull each.
 *
 *  \code
 *   pcl_cid::CIDConvexAbstraction<pcl::PointXYZ> abstraction;
 *   abstraction.setInputCloud(cloud);
 *   abstraction.setNumberOfParts(30);
 *   std::vector<pcl_cid::ConvexPart> parts;
 *   abstraction.reconstruct(parts);
 *   \endcode
 *
 *  The merge tree is computed once and can be cut anywhere: getMergeTree(), then
 *  reconstruct(cut, parts) for each cut. Parts are ordered by their lowest group; every
 *  finite, selected point belongs to exactly one, unless small parts are dropped. See
 * CIDBase for the input, errors, determinism and thread safety. \ingroup segmentation
 */
template <typename PointT>
class CIDConvexAbstraction : public CIDBase<PointT> {
public:
  using Ptr = pcl::shared_ptr<CIDConvexAbstraction<PointT>>;
  using ConstPtr = pcl::shared_ptr<const CIDConvexAbstraction<PointT>>;

  /** \brief Merge until this many parts remain (K'): at least 1. The last of the three
   *  setters called counts; without any, the tree says where (MergeTree::cutAtElbow).
   */
  void
  setNumberOfParts(int number_of_parts);

  /** \brief Merge while the smallest CID_g is at most this: metres, 0 or more. */
  void
  setMergeThreshold(double merge_threshold);

  /** \brief Merge this many times (T): 0 or more. */
  void
  setNumberOfMerges(int number_of_merges);

  /** \brief Drop parts of fewer points than this: at least 1; default 1, which drops
   *  none. Their points are in no part and no hull covers them; see
   *  getNumberOfDroppedPoints(). */
  void
  setMinPoints(int min_points);

  int
  getMinPoints() const
  {
    return min_points_;
  }

  /** \brief Points in the parts that the last segment() or reconstruct() dropped. */
  std::size_t
  getNumberOfDroppedPoints() const
  {
    return dropped_points_;
  }

  const MergeCut&
  getMergeCut() const
  {
    return merge_cut_;
  }

  /** \brief Whether to stop merging where the cut is, which is several times faster
   * than making the whole tree; getMergeTree() then holds the merges up to there. The
   * default is false: one tree for every cut. */
  void
  setStopAtCut(bool stop_at_cut)
  {
    stop_at_cut_ = stop_at_cut;
  }

  bool
  getStopAtCut() const
  {
    return stop_at_cut_;
  }

  /** \brief Points drawn from each group to estimate CID_g, of as many pairs: at least
   *  1; default 32. Two groups with no more pairs than that are compared whole. */
  void
  setGroupSampleSize(int group_sample_size);

  int
  getGroupSampleSize() const
  {
    return group_sample_size_;
  }

  /** \brief How hulls are made, all options at once; they are as before when one is
   *  out of its range.
   *  \throws CIDException */
  void
  setHullOptions(const ConvexPartOptions& hull_options);

  const ConvexPartOptions&
  getHullOptions() const
  {
    return hull_options_;
  }

  /** \brief Least thickness of a hull (see ConvexPartOptions): metres, above 0; default
   *  0.005. */
  void
  setMinThickness(double min_thickness);

  double
  getMinThickness() const
  {
    return hull_options_.min_thickness;
  }

  /** \brief Most vertices of a hull (see ConvexPartOptions): at least 4, or 0, the
   *  default, for any number. */
  void
  setMaxVertices(int max_vertices);

  int
  getMaxVertices() const
  {
    return static_cast<int>(hull_options_.max_vertices);
  }

  /** \brief How far hulls reach beyond what they need to (see ConvexPartOptions):
   *  metres, 0 or more; default 0. */
  void
  setPadding(double padding);

  double
  getPadding() const
  {
    return hull_options_.padding;
  }

  /** \brief Leave stray points out of the hulls: those that no links of at most this
   *  length join to the bulk of their part (see ConvexPartOptions). Metres; 0, the
   *  default, trims nothing. */
  void
  setTrimDistance(double trim_distance);

  double
  getTrimDistance() const
  {
    return hull_options_.trim_distance;
  }

  /** \brief The points of each part.
   *  \param[out] parts indices of the input cloud, ascending within a part
   *  \throws CIDException, CIDCancelled */
  void
  segment(std::vector<pcl::PointIndices>& parts);

  /** \brief The parts and their hulls.
   *  \param[out] parts as from segment(), each with its hull; what was trimmed from a
   *  part is listed in it apart */
  void
  reconstruct(std::vector<ConvexPart>& parts);

  /** \brief The hulls of another cut of the last merge tree; the input must still be
   *  the same.
   *  \param[in] cut part number of each group, as a MergeTree gives it
   *  \param[out] parts by part number
   *  \throws CIDException when nothing was computed, or the cut does not fit the
   *  tree */
  void
  reconstruct(const std::vector<int>& cut, std::vector<ConvexPart>& parts);

  /** \brief The merge tree of the last segment() or reconstruct(). Its sizes count the
   *  points worked on: those of the subsample where one was drawn. */
  const MergeTree&
  getMergeTree() const
  {
    return merge_tree_;
  }

  /** \brief Seeds, groups and coverage of the last segment() or reconstruct(). */
  const SeedProposal&
  getProposal() const
  {
    return proposal_;
  }

private:
  /** \brief Change one hull option, unless it is out of its range. */
  template <typename Value>
  void
  setHullOption(Value ConvexPartOptions::*option, Value value);

  /** \brief Algorithms 1 and 2, and the cut that the settings ask for.
   *  \param[in] until the share of the verb's progress that this makes up */
  std::vector<int>
  decompose(double until);

  /** \brief The part of each point of the input cloud, -1 for none. */
  std::vector<int>
  partOfEachPoint(const std::vector<int>& cut);

  /** \brief Take parts of too few points out and close the gaps in the numbers. */
  void
  dropSmallParts(std::vector<int>& part);

  std::vector<ConvexPart>
  makeHulls(const std::vector<int>& cut, const ExecutionOptions& execution);

  GroupMergingOptions
  mergingOptions(std::size_t groups) const;

  MergeCut merge_cut_;
  bool stop_at_cut_ = false;
  int group_sample_size_ = 32;
  int min_points_ = 1;
  std::size_t dropped_points_ = 0;
  ConvexPartOptions hull_options_;
  SeedProposal proposal_;
  MergeTree merge_tree_;
};

} // namespace pcl_cid

#ifdef PCL_NO_PRECOMPILE
#include <pcl_cid/impl/cid_convex_abstraction.hpp>
#endif
