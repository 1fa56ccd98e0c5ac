/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points in, core call, indices out: seeds.
 */

#pragma once

#include <pcl_cid/cid_sampler.h>
#include <pcl_cid/impl/cid_base.hpp>

#include <string>

namespace pcl_cid {

template <typename PointT>
void
CIDSampler<PointT>::sample(pcl::Indices& seeds)
{
  seeds.clear();
  proposal_ = SeedProposal();
  prepared_.reset();
  auto prepared = std::make_shared<const Preparation>(this->prepareCompute({}));
  working_proposal_ =
      propose(*prepared, *this, true, this->execution(0.0, 1.0), "CIDSampler::sample");
  prepared_ = std::move(prepared);
  sampled_ = this->input_;
  sampled_with_ = this->getNumberOfSamples();
  sampled_as_ = this->getRawScanSettings();
  publish(seeds);
  this->deinitCompute();
}

template <typename PointT>
void
CIDSampler<PointT>::extend(int number_of_seeds, pcl::Indices& seeds)
{
  seeds.clear();
  if (!prepared_ || sampled_ != this->input_)
    throw CIDException("there is no sample of this input cloud to extend; call sample");
  if (sampled_with_ != this->getNumberOfSamples())
    throw CIDException("the number of samples on a segment has changed from " +
                       std::to_string(sampled_with_) + " to " +
                       std::to_string(this->getNumberOfSamples()) +
                       "; what is extended must keep it");
  if (!(sampled_as_ == this->getRawScanSettings()))
    throw CIDException(
        "the density weight or power, the isolated neighbours, the seeding "
        "rule, the color weight or the filling of the blind spot has changed since "
        "the sample; what is extended must keep them");
  this->setNumberOfSeeds(number_of_seeds);
  pcl_cid::extend(*prepared_,
                  *this,
                  this->execution(0.0, 1.0),
                  "CIDSampler::extend",
                  working_proposal_);
  publish(seeds);
}

template <typename PointT>
void
CIDSampler<PointT>::publish(pcl::Indices& seeds)
{
  proposal_ = prepared_->working->carryOn(working_proposal_, this->input_->size());
  seeds = proposal_.seeds;
}

} // namespace pcl_cid

#define PCL_INSTANTIATE_CIDSampler(T)                                                  \
  template class PCL_CID_EXPORT pcl_cid::CIDSampler<T>;
