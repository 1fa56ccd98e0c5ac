/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The settings of parts and hulls, and the way from groups to them.
 */

#include <pcl_cid/cid_part_parameters.h>
#include <pcl_cid/core/hull_simplification.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <optional>
#include <string>

namespace pcl_cid {

void
CIDPartParameters::setNumberOfParts(int number_of_parts)
{
  require(setting::parts, number_of_parts);
  merge_cut_ = {MergeCut::Rule::parts, static_cast<std::size_t>(number_of_parts), 0.0};
}

void
CIDPartParameters::setMergeThreshold(double merge_threshold)
{
  require(setting::threshold, merge_threshold);
  merge_cut_ = {MergeCut::Rule::threshold, 0, merge_threshold};
}

void
CIDPartParameters::setNumberOfMerges(int number_of_merges)
{
  require(setting::merges, number_of_merges);
  merge_cut_ = {
      MergeCut::Rule::merges, static_cast<std::size_t>(number_of_merges), 0.0};
}

void
CIDPartParameters::setMinPoints(int min_points)
{
  require(setting::min_points, min_points);
  min_points_ = min_points;
}

void
CIDPartParameters::setGroupSampleSize(int group_sample_size)
{
  require(setting::group_samples, group_sample_size);
  group_sample_size_ = group_sample_size;
}

void
CIDPartParameters::setMaxError(double max_error)
{
  require(setting::max_error, max_error);
  fitting_settings_.max_error = max_error;
}

void
CIDPartParameters::setRobotRadius(double robot_radius)
{
  require(setting::robot_radius, robot_radius);
  fitting_settings_.robot_radius = robot_radius;
}

void
CIDPartParameters::setViewpoints(const std::vector<Eigen::Vector3d>& viewpoints)
{
  for (std::size_t i = 0; i < viewpoints.size(); ++i)
    if (!viewpoints[i].allFinite())
      throw CIDException("viewpoint " + std::to_string(i) +
                         " is not finite; it must be a position");
  fitting_settings_.viewpoints = viewpoints;
}

void
CIDPartParameters::setHullOptions(const ConvexPartOptions& hull_options)
{
  requireValid(hull_options);
  hull_options_ = hull_options;
}

template <typename Value>
void
CIDPartParameters::setHullOption(Value ConvexPartOptions::*option, Value value)
{
  ConvexPartOptions options = hull_options_;
  options.*option = value;
  setHullOptions(options);
}

void
CIDPartParameters::setMinThickness(double min_thickness)
{
  setHullOption(&ConvexPartOptions::min_thickness, min_thickness);
}

void
CIDPartParameters::setMaxVertices(int max_vertices)
{
  require(setting::max_vertices, max_vertices);
  setHullOption(&ConvexPartOptions::max_vertices,
                static_cast<std::size_t>(max_vertices));
}

void
CIDPartParameters::setPadding(double padding)
{
  setHullOption(&ConvexPartOptions::padding, padding);
}

void
CIDPartParameters::setTrimDistance(double trim_distance)
{
  setHullOption(&ConvexPartOptions::trim_distance, trim_distance);
}

template <typename Merge>
std::vector<int>
CIDPartParameters::cutTree(const std::shared_ptr<const void>& groups,
                           std::size_t number,
                           int samples,
                           const Merge& merge)
{
  MergingSettings settings;
  settings.group_samples = static_cast<std::size_t>(group_sample_size_);
  if (stop_at_cut_)
    settings.stopAt(merge_cut_, number);
  if (merged_ != groups || merged_samples_ != samples || !(merged_with_ == settings)) {
    merged_.reset();
    merge_tree_ = MergeTree();
    merge_tree_ = merge(settings);
    merged_ = groups;
    merged_samples_ = samples;
    merged_with_ = settings;
  }
  return merge_tree_.cut(merge_cut_);
}

std::vector<int>
CIDPartParameters::cutGroups(const Grouping::ConstPtr& grouping,
                             const ExecutionOptions& execution)
{
  patches_.reset();
  return cutTree(grouping,
                 grouping->numberOfSeeds(),
                 grouping->settings().samples,
                 [&](const MergingSettings& settings) {
                   return mergeGroups(*grouping, settings, execution);
                 });
}

std::vector<int>
CIDPartParameters::cutPatches(const PreparedScan::ConstPtr& scan,
                              int most,
                              int samples,
                              const ExecutionOptions& execution)
{
  if (!patches_ || patches_->sharedScan() != scan || most_patches_ != most) {
    patches_.reset();
    patches_ = std::make_shared<const SmoothPatches>(
        scan, static_cast<std::size_t>(most), partOf(execution, 0.0, 0.3));
    most_patches_ = most;
  }
  return cutTree(patches_,
                 patches_->numberOfPatches(),
                 samples,
                 [&](const MergingSettings& settings) {
                   return mergeGroups(
                       *patches_, samples, settings, partOf(execution, 0.3, 1.0));
                 });
}

std::vector<int>
CIDPartParameters::partOfEachPoint(const std::vector<pcl::index_t>& group,
                                   const std::vector<int>& cut)
{
  if (group.empty())
    throw CIDException("there are no groups of this input to cut; call segment or "
                       "reconstruct first");
  if (cut.empty() || cut.size() != merge_tree_.numberOfGroups())
    throw CIDException("the cut has " + std::to_string(cut.size()) +
                       " groups; it must be one of the merge tree of this input, which "
                       "has " +
                       std::to_string(merge_tree_.numberOfGroups()));
  std::vector<int> part(group.size(), -1);
  for (std::size_t i = 0; i < part.size(); ++i)
    if (group[i] >= 0)
      part[i] = cut[static_cast<std::size_t>(group[i])];
  dropSmallParts(part);
  return part;
}

void
CIDPartParameters::dropSmallParts(std::vector<int>& part)
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

std::vector<int>
CIDPartParameters::fitParts(const PreparedScan& scan, const ExecutionOptions& execution)
{
  const bool has_count = merge_cut_.rule == MergeCut::Rule::parts;
  if (!has_count &&
      (merge_cut_.rule != MergeCut::Rule::elbow || !fitting_settings_.hasBound()))
    throw CIDException("merging by hull needs a number of parts, a bound on the error, "
                       "or both, and takes no other cut");
  HullFittingSettings settings = fitting_settings_;
  settings.parts = has_count ? merge_cut_.count : 1;
  settings.min_thickness = hull_options_.min_thickness;
  fitting_ = fitHulls(scan, settings, execution);
  std::vector<int> part(scan.cloudSize(), -1);
  for (std::size_t i = 0; i < fitting_.part.size(); ++i)
    part[static_cast<std::size_t>(scan.points().source[i])] = fitting_.part[i];
  dropSmallParts(part);
  return part;
}

std::vector<ConvexPart>
CIDPartParameters::makeParts(const PreparedScan& scan,
                             const std::vector<int>& part_of_each_point,
                             const ExecutionOptions& execution) const
{
  const PointSet& points = scan.points();
  std::vector<int> part;
  part.reserve(points.size());
  for (const pcl::index_t source : points.source)
    part.push_back(part_of_each_point[static_cast<std::size_t>(source)]);
  return makeConvexParts(points, part, hull_options_, execution);
}

void
CIDPartParameters::simplifyParts(const PreparedScan::ConstPtr& scan,
                                 const ExecutionOptions& to_prepare,
                                 const ExecutionOptions& to_simplify,
                                 std::vector<ConvexPart>& parts) const
{
  std::optional<ErrorBound> bound;
  if (merging_rule_ == MergingRule::hull && fitting_settings_.hasBound())
    bound.emplace(scan,
                  paddedBound(fitting_settings_.max_error, hull_options_.padding),
                  fitting_settings_.viewpoints,
                  to_prepare);
  simplifyHulls(parts, scan->points().frame, bound ? &*bound : nullptr, to_simplify);
}

} // namespace pcl_cid
