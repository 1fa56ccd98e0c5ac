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

namespace pcl_cid {

template <typename PointT>
void
CIDSampler<PointT>::sample(pcl::Indices& seeds)
{
  seeds.clear();
  this->proposeSeeds("CIDSampler::sample", this->execution(0.0, 1.0));
  seeds = this->getProposal().seeds;
}

template <typename PointT>
void
CIDSampler<PointT>::extend(int number_of_seeds, pcl::Indices& seeds)
{
  seeds.clear();
  this->extendSeeds(number_of_seeds, "CIDSampler::extend", this->execution(0.0, 1.0));
  seeds = this->getProposal().seeds;
}

} // namespace pcl_cid

#define PCL_INSTANTIATE_CIDSampler(T)                                                  \
  template class PCL_CID_EXPORT pcl_cid::CIDSampler<T>;
