/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labels of a few seeds, carried to every point along CID.
 */

#pragma once

#include <pcl_cid/cid_base.h>

#include <cstdint>
#include <functional>
#include <vector>

#include <pcl/point_cloud.h>

namespace pcl_cid {

/** \brief Instance segmentation by label propagation (section IV.A of the paper): every
 *  point takes the label of its CID-nearest seed. Label 0 means "no label".
 *
 *  Three ways to label:
 *  \li setSeeds(indices, labels): seeds with their labels, from wherever they come;
 *  \li setAnnotator(ask): seeds are proposed (Algorithm 1) and each is shown to the
 *  annotator, who answers with its label;
 *  \li neither: seeds are proposed, and the label is the number of the group + 1.
 *
 *  \code
 *    pcl_cid::CIDLabelPropagation<pcl::PointXYZ> propagation;
 *    propagation.setInputCloud(cloud);
 *    propagation.setSeeds(seeds, labels);
 *    pcl::PointCloud<pcl::PointXYZL> labelled;
 *    propagation.segment(labelled);
 *    \endcode
 *
 *  Points that are not finite or not selected get label 0. See CIDBase for the input,
 *  errors, determinism and thread safety.
 *  \ingroup segmentation */
template <typename PointT>
class CIDLabelPropagation : public CIDBase<PointT> {
public:
  using Ptr = pcl::shared_ptr<CIDLabelPropagation<PointT>>;
  using ConstPtr = pcl::shared_ptr<const CIDLabelPropagation<PointT>>;
  /** \brief Asked for the label of a seed, an index of the input cloud; 0 for
   *  "none". */
  using Annotator = std::function<std::uint32_t(pcl::index_t seed)>;

  /** \brief Use these seeds instead of proposing any. At equal CID the earlier one
   *  keeps a point.
   *  \param[in] seeds indices of the input cloud; the verb requires them to be finite,
   *  selected points
   *  \param[in] labels one for each; 0 is a label too: "asked, and it is none"
   *  \throws CIDException when there are none, when the sizes differ, or when a seed
   *  stands twice with two labels (twice with one label counts once) */
  void
  setSeeds(const pcl::Indices& seeds, const std::vector<std::uint32_t>& labels);

  /** \brief Propose seeds again (the default). */
  void
  clearSeeds();

  const pcl::Indices&
  getSeeds() const
  {
    return seeds_;
  }

  /** \brief The labels that belong to getSeeds(). */
  const std::vector<std::uint32_t>&
  getSeedLabels() const
  {
    return seed_labels_;
  }

  /** \brief Who labels proposed seeds; empty, the default, numbers them. */
  void
  setAnnotator(const Annotator& annotator)
  {
    annotator_ = annotator;
  }

  Annotator
  getAnnotator() const
  {
    return annotator_;
  }

  /** \brief Whether getProposal() has the CID of every point to its seed; the default,
   *  false, saves a good part of the time. */
  void
  setKeepCID(bool keep_cid)
  {
    keep_cid_ = keep_cid;
  }

  bool
  getKeepCID() const
  {
    return keep_cid_;
  }

  /** \brief Label every point.
   *  \param[out] labelled the input cloud's points, in order and shape, with labels
   *  \throws CIDException, CIDCancelled, and whatever the annotator throws */
  void
  segment(pcl::PointCloud<pcl::PointXYZL>& labelled);

  /** \brief Label every point.
   *  \param[out] labels one for each point of the input cloud */
  void
  segment(std::vector<std::uint32_t>& labels);

  /** \brief Seeds, groups and coverage of the last segment(). */
  const SeedProposal&
  getProposal() const
  {
    return proposal_;
  }

private:
  /** \brief Seeds, given or proposed, and the groups of the whole cloud. */
  SeedProposal
  groupPoints();

  std::vector<std::uint32_t>
  labelsOfSeeds(const pcl::Indices& seeds) const;

  pcl::Indices seeds_;
  std::vector<std::uint32_t> seed_labels_;
  Annotator annotator_;
  bool keep_cid_ = false;
  SeedProposal proposal_;
};

} // namespace pcl_cid

#ifdef PCL_NO_PRECOMPILE
#include <pcl_cid/impl/cid_label_propagation.hpp>
#endif
