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

#include <algorithm>
#include <map>
#include <string>
#include <utility>

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
std::vector<std::uint32_t>
CIDLabelPropagation<PointT>::labelsOfPoints() const
{
  const std::vector<pcl::index_t>& group = this->getProposal().group;
  std::vector<std::uint32_t> labels(group.size(), 0);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (group[i] >= 0)
      labels[i] = result_labels_[static_cast<std::size_t>(group[i])];
  return labels;
}

template <typename PointT>
void
CIDLabelPropagation<PointT>::segment(std::vector<std::uint32_t>& labels)
{
  labels.clear();
  result_labels_.clear();
  const double grouped = clean_up_ ? 0.5 : 1.0; // of the progress
  const ExecutionOptions execution = this->execution(0.0, grouped);
  if (seeds_.empty())
    this->proposeSeeds("CIDLabelPropagation::segment", execution);
  else
    this->groupBySeeds(seeds_, execution);
  try {
    result_labels_ = labelsOfSeeds(this->getProposal().seeds);
    labels = clean_up_ ? cleanBoundaries(*this->getGrouping(),
                                         result_labels_,
                                         {},
                                         this->execution(grouped, 1.0))
                       : labelsOfPoints();
  }
  catch (...) {
    result_labels_.clear();
    this->clearProposal();
    throw;
  }
}

template <typename PointT>
std::size_t
CIDLabelPropagation<PointT>::numberOfSeed(pcl::index_t seed) const
{
  const pcl::Indices& seeds = this->getProposal().seeds;
  const auto found = std::find(seeds.begin(), seeds.end(), seed);
  if (found == seeds.end())
    throw CIDException("point " + std::to_string(seed) + " is none of the " +
                       std::to_string(seeds.size()) +
                       " seeds of the last result; it must be one");
  return static_cast<std::size_t>(found - seeds.begin());
}

template <typename PointT>
template <typename Change>
void
CIDLabelPropagation<PointT>::correct(pcl::Indices seeds,
                                     std::vector<std::uint32_t> labels,
                                     const Change& change)
{
  const ExecutionOptions execution = this->execution(0.0, 1.0);
  if (this->getSubsample() > 0)
    this->regroup(seeds, execution);
  else {
    const std::shared_ptr<Grouping> grouping = this->changeableGrouping();
    change(*grouping, execution);
    this->publish(grouping, execution);
  }
  seeds_ = std::move(seeds);
  seed_labels_ = labels;
  result_labels_ = std::move(labels);
}

template <typename PointT>
void
CIDLabelPropagation<PointT>::addSeeds(const pcl::Indices& seeds,
                                      const std::vector<std::uint32_t>& labels)
{
  if (result_labels_.empty() || !this->getGrouping())
    throw CIDException("there is no result to correct; call segment first");
  if (seeds.size() != labels.size())
    throw CIDException("there are " + std::to_string(seeds.size()) + " seeds and " +
                       std::to_string(labels.size()) +
                       " labels; there must be a label for each");
  pcl::Indices all = this->getProposal().seeds;
  all.insert(all.end(), seeds.begin(), seeds.end());
  std::vector<std::uint32_t> all_labels = result_labels_;
  all_labels.insert(all_labels.end(), labels.begin(), labels.end());
  correct(std::move(all),
          std::move(all_labels),
          [&](Grouping& grouping, const ExecutionOptions& execution) {
            grouping.addSeeds(seeds, execution);
          });
}

template <typename PointT>
void
CIDLabelPropagation<PointT>::removeSeeds(const pcl::Indices& seeds)
{
  std::vector<std::size_t> numbers;
  for (const pcl::index_t seed : seeds) {
    numbers.push_back(numberOfSeed(seed));
    if (std::count(numbers.begin(), numbers.end(), numbers.back()) > 1)
      throw CIDException("seed " + std::to_string(seed) +
                         " is given twice; it can be taken away only once");
  }
  pcl::Indices left;
  std::vector<std::uint32_t> left_labels;
  for (std::size_t k = 0; k < result_labels_.size(); ++k)
    if (std::find(numbers.begin(), numbers.end(), k) == numbers.end()) {
      left.push_back(this->getProposal().seeds[k]);
      left_labels.push_back(result_labels_[k]);
    }
  if (left.empty())
    throw CIDException("all seeds would be taken away; at least 1 must remain");
  correct(std::move(left),
          std::move(left_labels),
          [&](Grouping& grouping, const ExecutionOptions& execution) {
            grouping.removeSeeds(numbers, execution);
          });
}

template <typename PointT>
void
CIDLabelPropagation<PointT>::setLabel(pcl::index_t seed, std::uint32_t label)
{
  const std::size_t number = numberOfSeed(seed);
  result_labels_[number] = label;
  seeds_ = this->getProposal().seeds;
  seed_labels_ = result_labels_;
}

} // namespace pcl_cid

#define PCL_INSTANTIATE_CIDLabelPropagation(T)                                         \
  template class PCL_CID_EXPORT pcl_cid::CIDLabelPropagation<T>;
