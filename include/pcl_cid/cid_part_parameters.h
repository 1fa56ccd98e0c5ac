/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The settings of parts and hulls, and the way from groups to them.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/hull_fitting.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/core/smooth_patches.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <memory>
#include <vector>

#include <pcl/types.h>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief The part of CIDConvexAbstraction that does not depend on the point type.
 *  Every setter refuses a bad value at once with a CIDException and then changes
 *  nothing. */
class PCL_CID_EXPORT CIDPartParameters {
public:
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

  /** \brief Let the tree say where to cut again (the default). */
  void
  resetMergeCut()
  {
    merge_cut_ = MergeCut();
  }

  const MergeCut&
  getMergeCut() const
  {
    return merge_cut_;
  }

  /** \brief Whether to stop merging where the cut is, which is several times faster
   *  than making the whole tree; getMergeTree() then holds the merges up to there. The
   *  default is false: one tree for every cut. */
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

  /** \brief What reconstruct() puts parts together by: their group CID (the paper, and
   *  the default), or the hull that comes out, which leaves more free space free (see
   *  fitHulls()). By hull, it needs setNumberOfParts() or setMaxError(), or both: the
   *  bound comes first then. segment() always goes by CID.
   */
  void
  setMergingRule(MergingRule merging_rule)
  {
    merging_rule_ = merging_rule;
  }

  MergingRule
  getMergingRule() const
  {
    return merging_rule_;
  }

  /** \brief The bound T on CID_h of every hull without its padding, when merging by
   *  hull: metres, above 0. The default is none. */
  void
  setMaxError(double max_error);

  /** \brief No bound again. */
  void
  resetMaxError()
  {
    fitting_settings_.max_error = HullFittingSettings().max_error;
  }

  /** \brief Infinite for none. */
  double
  getMaxError() const
  {
    return fitting_settings_.max_error;
  }

  /** \brief The robot that places shall stay free for, when merging by hull: its
   * radius, metres, 0 or more; default 0.15. */
  void
  setRobotRadius(double robot_radius);

  double
  getRobotRadius() const
  {
    return fitting_settings_.robot_radius;
  }

  /** \brief Where the scan was taken from, in the frame of the input cloud, when
   *  merging by hull: only places that were seen count as free. The default is none:
   *  all count.
   *  \throws CIDException when one is not finite */
  void
  setViewpoints(const std::vector<Eigen::Vector3d>& viewpoints);

  const std::vector<Eigen::Vector3d>&
  getViewpoints() const
  {
    return fitting_settings_.viewpoints;
  }

  /** \brief The last result of merging by hull; its `part` is empty before. */
  const HullFitting&
  getHullFitting() const
  {
    return fitting_;
  }

  /** \brief Which groups are merged by CID: those of seeds (the paper, and the
   * default), or smooth patches of the surface, as many as setNumberOfSeeds() says.
   * Patches have no seeds: no other setting of seeds matters then, but for a subsample
   * that is drawn with the start in it, and getProposal() is empty. */
  void
  setGroupRule(GroupRule group_rule)
  {
    group_rule_ = group_rule;
  }

  GroupRule
  getGroupRule() const
  {
    return group_rule_;
  }

  /** \brief The patches that the last merging by CID began with, also when it was
   *  cancelled; null where it began with groups of seeds, and before. */
  const SmoothPatches::ConstPtr&
  getPatches() const
  {
    return patches_;
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
   *  default, for any number. CIDConvexAbstraction::simplify() finds numbers itself. */
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

  /** \brief The merge tree of the last segment() or reconstruct(). Its sizes count the
   *  points worked on: those of the subsample where one was drawn. */
  const MergeTree&
  getMergeTree() const
  {
    return merge_tree_;
  }

protected:
  CIDPartParameters() = default;

  /** \brief Algorithm 2 on groups, unless its last result still holds, and the cut that
   *  the settings ask for: the number of the part of each group. */
  std::vector<int>
  cutGroups(const Grouping::ConstPtr& grouping, const ExecutionOptions& execution);

  /** \brief The same on patches of a scan, which are found unless the last ones are
   *  those.
   *  \param[in] most K
   *  \param[in] samples M */
  std::vector<int>
  cutPatches(const PreparedScan::ConstPtr& scan,
             int most,
             int samples,
             const ExecutionOptions& execution);

  /** \brief The part of each point of the input cloud, -1 for none; small parts are
   *  dropped.
   *  \param[in] group of each point
   *  \param[in] cut number of the part of each group
   *  \throws CIDException when the cut does not fit the tree or nothing is left */
  std::vector<int>
  partOfEachPoint(const std::vector<pcl::index_t>& group, const std::vector<int>& cut);

  /** \brief The part of each point of the input cloud, chosen by hulls, -1 for none;
   *  small parts are dropped.
   *  \throws CIDException without a number of parts or a bound, CIDCancelled */
  std::vector<int>
  fitParts(const PreparedScan& scan, const ExecutionOptions& execution);

  /** \brief The parts with their hulls. */
  std::vector<ConvexPart>
  makeParts(const PreparedScan& scan,
            const std::vector<int>& part_of_each_point,
            const ExecutionOptions& execution) const;

  /** \brief Simpler hulls of the parts (see simplifyHulls()), within the bound where
   *  there is one: padding comes on top of it. */
  void
  simplifyParts(const PreparedScan::ConstPtr& scan,
                const ExecutionOptions& to_prepare,
                const ExecutionOptions& to_simplify,
                std::vector<ConvexPart>& parts) const;

private:
  /** \brief Algorithm 2 on groups, unless its last result still holds, and the cut.
   *  \param[in] groups what the tree is of
   *  \param[in] number K
   *  \param[in] samples M
   *  \param[in] merge called with the settings of Algorithm 2 */
  template <typename Merge>
  std::vector<int>
  cutTree(const std::shared_ptr<const void>& groups,
          std::size_t number,
          int samples,
          const Merge& merge);

  /** \brief Change one hull option, unless it is out of its range. */
  template <typename Value>
  void
  setHullOption(Value ConvexPartOptions::*option, Value value);

  /** \brief Take parts of too few points out and close the gaps in the numbers. */
  void
  dropSmallParts(std::vector<int>& part);

  MergeCut merge_cut_;
  bool stop_at_cut_ = false;
  GroupRule group_rule_ = setting::groups.initial;
  int group_sample_size_ = setting::group_samples.initial;
  int min_points_ = setting::min_points.initial;
  std::size_t dropped_points_ = 0;
  ConvexPartOptions hull_options_;
  MergingRule merging_rule_ = setting::merging.initial;
  HullFittingSettings fitting_settings_;
  HullFitting fitting_;
  MergeTree merge_tree_;
  SmoothPatches::ConstPtr patches_;
  int most_patches_ = 0;               ///< what these were asked for
  std::shared_ptr<const void> merged_; ///< the grouping or patches of merge_tree_
  int merged_samples_ = 0;
  MergingSettings merged_with_;
};

} // namespace pcl_cid
