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
#include <pcl_cid/core/label_cleaning.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <pcl/common/io.h>
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
 *  \endcode
 *
 *  Where the result is wrong, seeds correct it, at the cost of what they change:
 *
 *  \code
 *    propagation.addSeeds({1234}, {7});
 *    propagation.segment(labelled);
 *  \endcode
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
   *  \throws CIDException when there are none, when the sizes differ, or when a seed is
   *  listed with two labels (one that is listed twice with one label counts once) */
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

  /** \brief Label these groups, of a sampler for instance, on the scan that they are
   *  on, instead of making any. Call it after setInputCloud(). Seeds that are set must
   *  be theirs, in the same order; with others, or another number of samples, seeding
   *  rule, setting of the preparation or input, groups are made again.
   *  \throws CIDException when it is null */
  void
  setGrouping(const Grouping::ConstPtr& grouping)
  {
    this->adoptGrouping(grouping);
  }

  /** \brief Whether getProposal() has the CID of every point to its seed; the default,
   *  false, saves a good part of the time. */
  void
  setKeepCID(bool keep_cid)
  {
    this->setKeepCIDs(keep_cid);
  }

  bool
  getKeepCID() const
  {
    return this->keepsCIDs();
  }

  /** \brief Whether segment() mends ragged boundaries between labels (*ours*), see
   *  cleanBoundaries(); the default, false, is the paper. Groups stay as they are. */
  void
  setCleanUp(bool clean_up)
  {
    clean_up_ = clean_up;
  }

  bool
  getCleanUp() const
  {
    return clean_up_;
  }

  void
  setPaperSettings() override
  {
    CIDParameters::setPaperSettings();
    setCleanUp(setting::clean_up.paper());
  }

  /** \brief Label every point.
   *  \param[out] labels one for each point of the input cloud
   *  \throws CIDException, CIDCancelled, and whatever the annotator throws */
  void
  segment(std::vector<std::uint32_t>& labels);

  /** \brief Label every point.
   *  \param[out] labelled the points of the input cloud, in order and shape, with the
   *  fields that both point types have, and labels; empty when an exception is thrown
   */
  template <typename PointOutT>
  void
  segment(pcl::PointCloud<PointOutT>& labelled)
  {
    static_assert(pcl::traits::has_label_v<PointOutT>,
                  "pcl_cid writes labels into point types that have the field `label`, "
                  "such as pcl::PointXYZL or pcl::PointXYZRGBL");
    labelled = pcl::PointCloud<PointOutT>();
    std::vector<std::uint32_t> labels;
    segment(labels);
    pcl::copyPointCloud(this->preparedInput(), labelled);
    for (std::size_t i = 0; i < labels.size(); ++i)
      labelled[i].label = labels[i];
  }

  /** \brief Correct the last segment(): these seeds join its own, and all of them are
   *  given ones (getSeeds()) from then on. The next segment() returns the result at no
   *  further cost. (A subsample is drawn again, so that it holds the seeds, at the cost
   *  of a whole run.)
   *  \param[in] seeds finite, selected points that are no seeds yet
   *  \param[in] labels one for each
   *  \throws CIDException when nothing was segmented yet, or for seeds that are not
   *  allowed, and then changes nothing; CIDCancelled */
  void
  addSeeds(const pcl::Indices& seeds, const std::vector<std::uint32_t>& labels);

  /** \brief Take seeds of the last segment() away, as addSeeds() adds them; at least
   *  one must remain.
   *  \param[in] seeds indices of the input cloud */
  void
  removeSeeds(const pcl::Indices& seeds);

  /** \brief Give a seed of the last segment() another label; no group changes.
   *  \param[in] seed an index of the input cloud */
  void
  setLabel(pcl::index_t seed, std::uint32_t label);

private:
  std::vector<std::uint32_t>
  labelsOfSeeds(const pcl::Indices& seeds) const;

  /** \brief The labels of all points, from those of the seeds. */
  std::vector<std::uint32_t>
  labelsOfPoints() const;

  /** \brief The number of a seed of the last segment().
   *  \throws CIDException when it is none */
  std::size_t
  numberOfSeed(pcl::index_t seed) const;

  /** \brief Change the seeds of the result, which become those of the settings.
   *  \param[in] seeds,labels all of them, as they will be
   *  \param[in] change called with the grouping and how to run */
  template <typename Change>
  void
  correct(pcl::Indices seeds, std::vector<std::uint32_t> labels, const Change& change);

  pcl::Indices seeds_;
  std::vector<std::uint32_t> seed_labels_;
  Annotator annotator_;
  bool clean_up_ = setting::clean_up.initial;
  std::vector<std::uint32_t> result_labels_; ///< of the seeds of the last segment()
};

} // namespace pcl_cid

#ifdef PCL_NO_PRECOMPILE
#include <pcl_cid/impl/cid_label_propagation.hpp>
#endif
