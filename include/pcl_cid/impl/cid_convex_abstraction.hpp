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
#include <pcl_cid/impl/cid_base.hpp>

#include <algorithm>
#include <string>

namespace pcl_cid {

template <typename PointT>
void
CIDConvexAbstraction<PointT>::setNumberOfParts(int number_of_parts)
{
  if (number_of_parts < 1)
    throw CIDException("the number of parts is " + std::to_string(number_of_parts) +
                       "; it must be at least 1");
  merge_cut_ = {MergeCut::Rule::parts, static_cast<std::size_t>(number_of_parts), 0.0};
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::setMergeThreshold(double merge_threshold)
{
  if (!(merge_threshold >= 0.0) || merge_threshold > 1e15)
    throw CIDException("the merge threshold is " + std::to_string(merge_threshold) +
                       "; it must be a number of metres, 0 or more");
  merge_cut_ = {MergeCut::Rule::threshold, 0, merge_threshold};
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::setNumberOfMerges(int number_of_merges)
{
  if (number_of_merges < 0)
    throw CIDException("the number of merges is " + std::to_string(number_of_merges) +
                       "; it must be 0 or more");
  merge_cut_ = {
      MergeCut::Rule::merges, static_cast<std::size_t>(number_of_merges), 0.0};
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::setMinPoints(int min_points)
{
  if (min_points < 1)
    throw CIDException("the least number of points of a part is " +
                       std::to_string(min_points) + "; it must be at least 1");
  min_points_ = min_points;
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::setGroupSampleSize(int group_sample_size)
{
  if (group_sample_size < 1)
    throw CIDException("the group sample size is " + std::to_string(group_sample_size) +
                       "; it must be at least 1");
  group_sample_size_ = group_sample_size;
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::setHullOptions(const ConvexPartOptions& hull_options)
{
  requireValid(hull_options);
  hull_options_ = hull_options;
}

template <typename PointT>
template <typename Value>
void
CIDConvexAbstraction<PointT>::setHullOption(Value ConvexPartOptions::*option,
                                            Value value)
{
  ConvexPartOptions options = hull_options_;
  options.*option = value;
  setHullOptions(options);
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::setMinThickness(double min_thickness)
{
  setHullOption(&ConvexPartOptions::min_thickness, min_thickness);
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::setMaxVertices(int max_vertices)
{
  if (max_vertices < 0)
    throw CIDException("the maximum number of vertices is " +
                       std::to_string(max_vertices) +
                       "; it must be at least 4, or 0 for any number");
  setHullOption(&ConvexPartOptions::max_vertices,
                static_cast<std::size_t>(max_vertices));
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::setPadding(double padding)
{
  setHullOption(&ConvexPartOptions::padding, padding);
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::setTrimDistance(double trim_distance)
{
  setHullOption(&ConvexPartOptions::trim_distance, trim_distance);
}

template <typename PointT>
std::vector<int>
CIDConvexAbstraction<PointT>::decompose(double until)
{
  proposal_ = SeedProposal();
  merge_tree_ = MergeTree();
  const Preparation ready = this->prepareCompute({});
  const WorkingSet& working = *ready.working;
  const SeedProposal proposal = propose(
      ready, *this, false, this->execution(0.0, 0.5 * until), "CIDConvexAbstraction");
  GroupMergingOptions options = mergingOptions(proposal.seeds.size());
  options.costs = ready.pairCosts();
  options.execution = this->execution(0.5 * until, until);
  merge_tree_ = mergeGroups(working.field(),
                            working.points(),
                            proposal.group,
                            proposal.seeds.size(),
                            options);
  proposal_ = working.carryOn(proposal, this->input_->size());
  return merge_tree_.cut(merge_cut_);
}

template <typename PointT>
GroupMergingOptions
CIDConvexAbstraction<PointT>::mergingOptions(std::size_t groups) const
{
  GroupMergingOptions options;
  options.group_samples = static_cast<std::size_t>(group_sample_size_);
  options.samples = this->getNumberOfSamples();
  options.random_seed = this->getRandomSeed();
  if (stop_at_cut_)
    options.stopAt(merge_cut_, groups);
  return options;
}

template <typename PointT>
std::vector<int>
CIDConvexAbstraction<PointT>::partOfEachPoint(const std::vector<int>& cut)
{
  if (cut.empty() || cut.size() != merge_tree_.numberOfGroups() ||
      proposal_.group.size() != this->input_->size())
    throw CIDException("the cut has " + std::to_string(cut.size()) +
                       " groups; it must be one of the merge tree of this input, which "
                       "has " +
                       std::to_string(merge_tree_.numberOfGroups()));
  std::vector<int> part(proposal_.group.size(), -1);
  for (std::size_t i = 0; i < part.size(); ++i)
    if (proposal_.group[i] >= 0)
      part[i] = cut[static_cast<std::size_t>(proposal_.group[i])];
  dropSmallParts(part);
  return part;
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::dropSmallParts(std::vector<int>& part)
{
  std::vector<std::size_t> size;
  for (const int number : part)
    if (number >= 0) {
      size.resize(std::max(size.size(), static_cast<std::size_t>(number) + 1));
      ++size[static_cast<std::size_t>(number)];
    }
  std::vector<int> new_number(size.size(), -1);
  int kept = 0;
  for (std::size_t k = 0; k < size.size(); ++k)
    if (size[k] >= static_cast<std::size_t>(min_points_))
      new_number[k] = kept++;
  if (kept == 0)
    throw CIDException("all " + std::to_string(size.size()) +
                       " parts have fewer than " + std::to_string(min_points_) +
                       " points, the least number asked for; choose a smaller one");
  dropped_points_ = 0;
  for (int& number : part)
    if (number >= 0) {
      number = new_number[static_cast<std::size_t>(number)];
      dropped_points_ += number < 0 ? 1 : 0;
    }
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::segment(std::vector<pcl::PointIndices>& parts)
{
  parts.clear();
  const std::vector<int> part = partOfEachPoint(decompose(1.0));
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part[i] < 0)
      continue;
    const auto number = static_cast<std::size_t>(part[i]);
    if (parts.size() <= number)
      parts.resize(number + 1);
    parts[number].indices.push_back(static_cast<pcl::index_t>(i));
  }
  for (pcl::PointIndices& indices : parts)
    indices.header = this->input_->header;
  this->deinitCompute();
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::reconstruct(std::vector<ConvexPart>& parts)
{
  parts.clear();
  const std::vector<int> cut = decompose(0.9);
  parts = makeHulls(cut, this->execution(0.9, 1.0));
  this->deinitCompute();
}

template <typename PointT>
void
CIDConvexAbstraction<PointT>::reconstruct(const std::vector<int>& cut,
                                          std::vector<ConvexPart>& parts)
{
  parts.clear();
  this->beginCompute();
  parts = makeHulls(cut, this->execution(0.0, 1.0));
  this->deinitCompute();
}

template <typename PointT>
std::vector<ConvexPart>
CIDConvexAbstraction<PointT>::makeHulls(const std::vector<int>& cut,
                                        const ExecutionOptions& execution)
{
  const std::vector<int> part_in_cloud = partOfEachPoint(cut);
  const PointSet points = this->gatherPoints();
  std::vector<int> part;
  for (const pcl::index_t source : points.source)
    part.push_back(part_in_cloud[static_cast<std::size_t>(source)]);
  return makeConvexParts(points, part, hull_options_, execution);
}

} // namespace pcl_cid

#define PCL_INSTANTIATE_CIDConvexAbstraction(T)                                        \
  template class PCL_CID_EXPORT pcl_cid::CIDConvexAbstraction<T>;
