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

#include "clicked_session.h"
#include <pcl_cid/exceptions.h>

#include <utility>

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

ClickedSession::ClickedSession(const AnnotationTask& task, Looks looks)
: session_(requireTask(task).scan, settingsFor(task, looks == Looks::after_click))
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
ClickedSession::propose(std::size_t seeds, const ExecutionOptions& execution)
{
  if (seeds <= clicks())
    return;
  session_.apply(action::Propose{seeds - clicks()}, execution);
  for (const SessionSeed& seed : session_.seeds())
    if (!seed.label)
      session_.apply(action::Label{seed.point, answerFor(seed.point)},
                     {execution.threads, {}});
  updateLabels({execution.threads, {}});
}

void
ClickedSession::click(const pcl::Indices& points, const ExecutionOptions& execution)
{
  for (const pcl::index_t point : points) {
    const pcl::index_t seed = scan().workingSet().cloudIndexOf(point);
    session_.apply(action::Click{{seed}, answerFor(seed)}, execution);
  }
  updateLabels({execution.threads, {}});
}

/** The true label of a seed: none, or an instance, which is made where it is not there.
 */
action::Answer
ClickedSession::answerFor(pcl::index_t seed) const
{
  const std::uint32_t label = cloud_truth_[static_cast<std::size_t>(seed)];
  if (label == 0)
    return 0u;
  for (const NamedInstance& instance : session_.instances())
    if (instance.label == label)
      return label;
  return action::NewInstance{"", "", label};
}

void
ClickedSession::updateLabels(const ExecutionOptions& execution)
{
  const std::vector<std::uint32_t> labels =
      clean_up_ ? session_.cleanedLabels({}, execution) : session_.labels();
  for (std::size_t i = 0; i < labels_.size(); ++i)
    labels_[i] = labels[static_cast<std::size_t>(
        scan().workingSet().cloudIndexOf(static_cast<pcl::index_t>(i)))];
}

AnnotationState
ClickedSession::state(const std::vector<std::uint32_t>& labels) const
{
  std::vector<std::uint32_t> of_cloud =
      scan().workingSet().carryOn(labels, cloud_truth_.size(), std::uint32_t{0});
  return {clicks(),
          sameLabelOverlaps(annotationOverlaps(std::move(of_cloud), cloud_truth_))};
}

} // namespace pcl_cid
