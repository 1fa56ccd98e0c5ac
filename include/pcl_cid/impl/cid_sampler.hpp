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

namespace pcl_cid {

template <typename PointT>
void
CIDSampler<PointT>::sample(pcl::Indices& seeds)
{
  seeds.clear();
  proposal_ = SeedProposal();
  const Preparation ready = this->prepareCompute({});
  const SeedProposal proposal =
      propose(ready, *this, this->execution(0.0, 1.0), "CIDSampler::sample");
  proposal_ = ready.working->carryOn(proposal, this->input_->size());
  seeds = proposal_.seeds;
  this->deinitCompute();
}

} // namespace pcl_cid

#define PCL_INSTANTIATE_CIDSampler(T)                                                  \
  template class PCL_CID_EXPORT pcl_cid::CIDSampler<T>;
