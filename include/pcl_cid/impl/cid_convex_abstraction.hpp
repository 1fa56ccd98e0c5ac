/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points in, core call, indices out: parts and hulls.
 */

#pragma once

#include <pcl_cid/cid_convex_abstraction.h>

namespace pcl_cid {

template <typename PointT>
std::vector<int>
CIDConvexAbstraction<PointT>::decompose(double until)
{
  if (this->getGroupRule() == GroupRule::patches) {
    this->requireNoGrouping();
    this->clearProposal();
    return this->cutPatches(this->prepare(),
                            this->getNumberOfSeeds(),
                            this->getNumberOfSamples(),
                            this->execution(0.0, until));
  }
  this->proposeSeeds("CIDConvexAbstraction", this->execution(0.0, 0.5 * until));
  return this->cutGroups(this->getGrouping(), this->execution(0.5 * until, until));
}

template <typename PointT>
std::vector<pcl::index_t>
CIDConvexAbstraction<PointT>::groupOfEachPoint() const
{
  const SmoothPatches::ConstPtr& patches = this->getPatches();
  if (!patches)
    return this->getProposal().group;
  if (patches->sharedScan() != this->getPreparedScan())
    return {}; // of another input
  return patches->groups();
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::segment(std::vector<pcl::PointIndices>& parts)
{
  parts.clear();
  const std::vector<int> cut = decompose(1.0);
  const std::vector<int> part = this->partOfEachPoint(groupOfEachPoint(), cut);
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part[i] < 0)
      continue;
    const auto number = static_cast<std::size_t>(part[i]);
    if (parts.size() <= number)
      parts.resize(number + 1);
    parts[number].indices.push_back(static_cast<pcl::index_t>(i));
  }
  if (this->input_)
    for (pcl::PointIndices& indices : parts)
      indices.header = this->input_->header;
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::reconstruct(std::vector<ConvexPart>& parts)
{
  parts.clear();
  if (this->getMergingRule() == MergingRule::hull) {
    const PreparedScan& scan = *this->prepare();
    const std::vector<int> part = this->fitParts(scan, this->execution(0.0, 0.9));
    parts = this->makeParts(scan, part, this->execution(0.9, 1.0));
    return;
  }
  const std::vector<int> cut = decompose(0.9);
  parts = this->makeParts(*this->getPreparedScan(),
                          this->partOfEachPoint(groupOfEachPoint(), cut),
                          this->execution(0.9, 1.0));
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::reconstruct(const std::vector<int>& cut,
                                          std::vector<ConvexPart>& parts)
{
  parts.clear();
  const std::vector<int> part = this->partOfEachPoint(groupOfEachPoint(), cut);
  parts = this->makeParts(*this->getPreparedScan(), part, this->execution(0.0, 1.0));
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::simplify(std::vector<ConvexPart>& parts)
{
  const PreparedScan::ConstPtr scan = this->prepare();
  this->simplifyParts(
      scan, this->execution(0.0, 0.3), this->execution(0.3, 1.0), parts);
}

} // namespace pcl_cid

#define PCL_INSTANTIATE_CIDConvexAbstraction(T)                                        \
  template class PCL_CID_EXPORT pcl_cid::CIDConvexAbstraction<T>;
