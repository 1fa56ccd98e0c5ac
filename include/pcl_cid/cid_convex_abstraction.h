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
#include <pcl_cid/cid_part_parameters.h>

#include <vector>

#include <pcl/PointIndices.h>

namespace pcl_cid {

/** \brief Abstraction (section IV.B of the paper): groups merged by group CID into
 *  approximately convex parts (Algorithm 2), one convex hull each.
 *
 *  \code
 *    pcl_cid::CIDConvexAbstraction<pcl::PointXYZ> abstraction;
 *    abstraction.setInputCloud(cloud);
 *    abstraction.setNumberOfParts(30);
 *    std::vector<pcl_cid::ConvexPart> parts;
 *    abstraction.reconstruct(parts);
 *  \endcode
 *
 *  The merge tree is computed once and can be cut anywhere: getMergeTree(), then
 *  reconstruct(cut, parts) for each cut. Parts are ordered by their lowest group; every
 *  finite, selected point belongs to exactly one, unless small parts are dropped. See
 *  CIDBase for the input, errors, determinism and thread safety.
 *  \ingroup segmentation */
template <typename PointT>
class CIDConvexAbstraction : public CIDBase<PointT>, public CIDPartParameters {
public:
  using Ptr = pcl::shared_ptr<CIDConvexAbstraction<PointT>>;
  using ConstPtr = pcl::shared_ptr<const CIDConvexAbstraction<PointT>>;

  /** \brief Merge these groups, of a sampler or a label propagation, on the scan that
   *  they are on, instead of making any. Call it after setInputCloud(). With another
   *  number of samples, seeding rule, setting of the preparation or input, groups are
   *  made again. With GroupRule::patches, segment() refuses it, and reconstruct() by
   *  CID.
   *  \throws CIDException when it is null */
  void
  setGrouping(const Grouping::ConstPtr& grouping)
  {
    this->adoptGrouping(grouping);
  }

  void
  setPaperSettings() override
  {
    CIDParameters::setPaperSettings();
    setMergingRule(setting::merging.paper());
    setGroupRule(setting::groups.paper());
  }

  /** \brief The points of each part.
   *  \param[out] parts indices of the input cloud, ascending within a part
   *  \throws CIDException, CIDCancelled */
  void
  segment(std::vector<pcl::PointIndices>& parts);

  /** \brief The parts and their hulls, by whichever rule setMergingRule() says.
   *  \param[out] parts each with its hull, ordered by their lowest groups, or by their
   *  first points; what was trimmed from a part is listed in it apart
   *  \throws CIDException, CIDCancelled */
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

  /** \brief Give the hulls of parts as few vertices as the error allows: that of
   *  setMaxError() where parts are merged by hull, else a share of each hull's size
   * (see simplifyHulls()). They hold their points as before.
   *
   *  \param[in,out] parts of the last reconstruct(); the input must still be the same
   *
   *  \throws CIDException, CIDCancelled */
  void
  simplify(std::vector<ConvexPart>& parts);

private:
  /** \brief Algorithms 1 and 2, and the cut that the settings ask for.
   *  \param[in] until the share of the verb's progress that this makes up */
  std::vector<int>
  decompose(double until);

  /** \brief The group of each point of the input cloud, from the last decompose(); -1
   *  for none, and empty where the input is another one by now. */
  std::vector<pcl::index_t>
  groupOfEachPoint() const;
};

} // namespace pcl_cid

#ifdef PCL_NO_PRECOMPILE
#include <pcl_cid/impl/cid_convex_abstraction.hpp>
#endif
