/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Farthest-first sampling in Concavity-Induced Distance.
 */

#pragma once

#include <pcl_cid/cid_base.h>

namespace pcl_cid {

/** \brief Seeds by farthest-first sampling in CID (CID-FPS, Algorithm 1 of the paper),
 *  and the group of every point: the seed with the smallest CID to it.
 *
 *  \code
 *    pcl_cid::CIDSampler<pcl::PointXYZ> sampler;
 *    sampler.setInputCloud(cloud);
 *    sampler.setNumberOfSeeds(100);
 *    pcl::Indices seeds;
 *    sampler.sample(seeds);
 *    const std::vector<pcl::index_t>& group = sampler.getProposal().group;
 *  \endcode
 *
 *  The seeds are nested: the first k of them are what k seeds would have been.
 *  Degenerate input: duplicates never become seeds, so a cloud with fewer distinct
 *  points than seeds gives one seed for each of them, with a warning. See CIDBase for
 *  the input, errors, determinism and thread safety.
 *  \ingroup segmentation */
template <typename PointT>
class CIDSampler : public CIDBase<PointT> {
public:
  using Ptr = pcl::shared_ptr<CIDSampler<PointT>>;
  using ConstPtr = pcl::shared_ptr<const CIDSampler<PointT>>;

  CIDSampler() { this->setKeepCIDs(true); }

  /** \brief Run Algorithm 1.
   *  \param[out] seeds indices of the input cloud, in the order they were chosen
   *  \throws CIDException, CIDCancelled */
  void
  sample(pcl::Indices& seeds);

  /** \brief Continue where the last sample() ended, at the cost of the new seeds only:
   *  an annotator asks for ten more. The result is that of one sample() with all of
   *  them; getNumberOfSeeds() does not change.
   *  \param[in] number_of_seeds K, all in all
   *  \param[out] seeds all of them
   *  \throws CIDException when nothing was sampled yet, or when the number of samples,
   *  the seeding rule, the input or a setting of the preparation has been set since */
  void
  extend(int number_of_seeds, pcl::Indices& seeds);
};

} // namespace pcl_cid

#ifdef PCL_NO_PRECOMPILE
#include <pcl_cid/impl/cid_sampler.hpp>
#endif
