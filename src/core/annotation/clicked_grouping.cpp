/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Seeds with their true labels, and the labels of all points.
 */

#include "base/sentence.h"
#include "cid/working_points.h"
#include "scan/working_set.h"

#include "clicked_grouping.h"
#include <pcl_cid/core/label_cleaning.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>

namespace pcl_cid {
namespace {

const AnnotationTask&
requireTask(const AnnotationTask& task)
{
  if (!task.scan)
    throw CIDException("there is no prepared scan to annotate; give one");
  const std::size_t size = task.scan->cloudSize();
  if (task.truth.size() != size)
    throw CIDException(sentence("there are ",
                                task.truth.size(),
                                " true labels; there must be one for each of the ",
                                size,
                                " points of the cloud"));
  return task;
}

GroupingSettings
settingsFor(const AnnotationTask& task, bool keep_cid)
{
  GroupingSettings settings = task.grouping;
  settings.keep_cid = keep_cid;
  return settings;
}

/** The true labels without those of points that are not grouped. */
std::vector<std::uint32_t>
truthOfGrouped(const AnnotationTask& task)
{
  const pcl::Indices& grouped = task.scan->points().source;
  std::vector<std::uint32_t> truth(task.truth.size(), 0);
  bool is_labelled = false;
  for (const pcl::index_t point : grouped) {
    const auto i = static_cast<std::size_t>(point);
    truth[i] = task.truth[i];
    is_labelled |= truth[i] != 0;
  }
  if (!is_labelled)
    throw CIDException(sentence("none of the ",
                                grouped.size(),
                                " finite points has a true label; at least 1 must have "
                                "one other than 0, which means none"));
  return truth;
}

} // namespace

ClickedGrouping::ClickedGrouping(const AnnotationTask& task, Looks looks)
: grouping_(requireTask(task).scan, settingsFor(task, looks == Looks::after_click))
, clean_up_(task.clean_up)
, cloud_truth_(truthOfGrouped(task))
{
  const auto size = static_cast<pcl::index_t>(scan().working().size());
  for (pcl::index_t i = 0; i < size; ++i)
    truth_.push_back(
        cloud_truth_[static_cast<std::size_t>(scan().workingSet().cloudIndexOf(i))]);
  labels_.assign(truth_.size(), 0);
}

void
ClickedGrouping::propose(std::size_t seeds, const ExecutionOptions& execution)
{
  grouping_.propose(seeds, 0.0f, execution);
  updateLabels({execution.threads, {}});
}

void
ClickedGrouping::click(const pcl::Indices& points, const ExecutionOptions& execution)
{
  pcl::Indices seeds;
  for (const pcl::index_t point : points)
    seeds.push_back(scan().workingSet().cloudIndexOf(point));
  grouping_.addSeeds(seeds, execution);
  updateLabels({execution.threads, {}});
}

void
ClickedGrouping::updateLabels(const ExecutionOptions& execution)
{
  std::vector<std::uint32_t> label_of_seed;
  for (const pcl::index_t seed : grouping_.seeds())
    label_of_seed.push_back(cloud_truth_[static_cast<std::size_t>(seed)]);
  if (clean_up_) {
    const std::vector<std::uint32_t> cleaned =
        cleanBoundaries(grouping_, label_of_seed, {}, execution);
    for (std::size_t i = 0; i < labels_.size(); ++i)
      labels_[i] = cleaned[static_cast<std::size_t>(
          scan().workingSet().cloudIndexOf(static_cast<pcl::index_t>(i)))];
    return;
  }
  const std::vector<pcl::index_t> group = grouping_.groupsOfWorkingPoints(execution);
  for (std::size_t i = 0; i < group.size(); ++i)
    labels_[i] = label_of_seed[static_cast<std::size_t>(group[i])];
}

AnnotationState
ClickedGrouping::state(const std::vector<std::uint32_t>& labels) const
{
  const std::size_t size = cloud_truth_.size();
  const PointLabels truth{cloud_truth_,
                          std::vector<std::uint32_t>(size, class_of_instances)};
  PointLabels prediction{scan().workingSet().carryOn(labels, size, std::uint32_t{0}),
                         {}};
  for (std::size_t i = 0; i < size; ++i)
    if (truth.label[i] == 0) // nobody can tell whether its label is right
      prediction.label[i] = 0;
  return {clicks(), sameLabelOverlaps(overlapsOf(prediction, truth))};
}

} // namespace pcl_cid
