/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points in, core call, indices out: labels.
 */

#pragma once

#include <pcl_cid/cid_label_propagation.h>
#include <pcl_cid/impl/cid_base.hpp>

#include <map>

namespace pcl_cid {

template <typename PointT>
void
CIDLabelPropagation<PointT>::setSeeds(const pcl::Indices& seeds,
                                      const std::vector<std::uint32_t>& labels)
{
  if (seeds.empty() || seeds.size() != labels.size())
    throw CIDException("there are " + std::to_string(seeds.size()) + " seeds and " +
                       std::to_string(labels.size()) +
                       " labels; there must be at least 1 seed and a label for each");
  pcl::Indices distinct;
  std::vector<std::uint32_t> distinct_labels;
  std::map<pcl::index_t, std::uint32_t> label_of;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const auto [known, is_new] = label_of.emplace(seeds[i], labels[i]);
    if (known->second != labels[i])
      throw CIDException("seed " + std::to_string(seeds[i]) + " has the labels " +
                         std::to_string(known->second) + " and " +
                         std::to_string(labels[i]) + "; a seed must have one");
    if (!is_new)
      continue;
    distinct.push_back(seeds[i]);
    distinct_labels.push_back(labels[i]);
  }
  seeds_ = std::move(distinct);
  seed_labels_ = std::move(distinct_labels);
}

template <typename PointT>
void
CIDLabelPropagation<PointT>::clearSeeds()
{
  seeds_.clear();
  seed_labels_.clear();
}

template <typename PointT>
SeedProposal
CIDLabelPropagation<PointT>::groupPoints()
{
  const Preparation ready = this->prepareCompute(seeds_);
  const ExecutionOptions execution = this->execution(0.0, 1.0);
  const SeedProposal proposal =
      seeds_.empty()
          ? propose(ready, *this, keep_cid_, execution, "CIDLabelPropagation::segment")
          : group(ready, *this, keep_cid_, execution);
  return ready.working->carryOn(proposal, this->input_->size());
}

template <typename PointT>
std::vector<std::uint32_t>
CIDLabelPropagation<PointT>::labelsOfSeeds(const pcl::Indices& seeds) const
{
  if (!seeds_.empty())
    return seed_labels_;
  std::vector<std::uint32_t> labels;
  for (const pcl::index_t seed : seeds)
    labels.push_back(annotator_ ? annotator_(seed)
                                : static_cast<std::uint32_t>(labels.size() + 1));
  return labels;
}

template <typename PointT>
void
CIDLabelPropagation<PointT>::segment(std::vector<std::uint32_t>& labels)
{
  labels.clear();
  proposal_ = SeedProposal();
  SeedProposal proposal = groupPoints();
  const std::vector<std::uint32_t> of_seed = labelsOfSeeds(proposal.seeds);
  labels.resize(proposal.group.size(), 0);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (proposal.group[i] >= 0)
      labels[i] = of_seed[static_cast<std::size_t>(proposal.group[i])];
  proposal_ = std::move(proposal);
  this->deinitCompute();
}

template <typename PointT>
void
CIDLabelPropagation<PointT>::segment(pcl::PointCloud<pcl::PointXYZL>& labelled)
{
  labelled.clear();
  std::vector<std::uint32_t> labels;
  segment(labels);
  const auto& input = *this->input_;
  labelled.header = input.header;
  labelled.sensor_origin_ = input.sensor_origin_;
  labelled.sensor_orientation_ = input.sensor_orientation_;
  labelled.reserve(input.size());
  for (std::size_t i = 0; i < input.size(); ++i)
    labelled.emplace_back(input[i].x, input[i].y, input[i].z, labels[i]);
  labelled.width = input.width;
  labelled.height = input.height;
  labelled.is_dense = input.is_dense;
}

} // namespace pcl_cid

#define PCL_INSTANTIATE_CIDLabelPropagation(T)                                         \
  template class PCL_CID_EXPORT pcl_cid::CIDLabelPropagation<T>;
