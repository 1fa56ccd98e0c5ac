/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan, and what a simulated annotator makes of it.
 */

#include "annotated_scan.h"

#include "run/loaded_scan.h"
#include "run/parameter.h"

#include <pcl_cid/cid_label_propagation.h>

#include <string>
#include <utility>

namespace pcl_cid::tools {
namespace {

std::vector<AnnotationState>
annotate(const SimulateSettings& settings,
         const AnnotationTask& task,
         const ExecutionOptions& execution)
{
  const auto proposals = static_cast<std::size_t>(settings.proposals.value_or(0));
  switch (settings.protocol) {
  case AnnotationProtocol::proposals:
    return annotateProposals(task, settings.clicks, execution);
  case AnnotationProtocol::corrective:
    return annotateCorrections(task, settings.clicks, proposals, execution);
  case AnnotationProtocol::doubt:
    return annotateDoubts(task, settings.clicks, proposals, execution);
  default:
    return annotateVoxels(task, {}, execution);
  }
}

} // namespace

AnnotatedScan
annotateScan(const SimulateSettings& settings, Run& run)
{
  const LoadedScan scan = loadScan(settings, run);
  AnnotationTask task;
  task.truth = trueLabels(settings, scan, run);

  run.begin("Preparing");
  CIDLabelPropagation<pcl::PointXYZ> parameters;
  configure(settings, scan, run.console, parameters);
  parameters.setInputCloud(scan.points.points);
  task.scan = parameters.prepare();
  task.grouping = parameters.getGroupingSettings();
  task.clean_up = settings.clean_up;
  run.end(std::to_string(scan.points.finite) + " finite points", "prepare");
  describeDensity(task.scan->density(), run);
  describeBlindSpot(task.scan->blindSpot(), scan.points.frame, run);

  run.begin("Annotating");
  std::vector<AnnotationState> states =
      annotate(settings, task, {settings.threads, run.console.progress()});
  run.end(std::to_string(states.back().clicks) + " clicks", "annotate");

  std::vector<Report::Parameter> used = groupingParametersOf(settings, parameters);
  used.push_back(parameter(setting::clean_up, settings.clean_up));
  return {scoredScan(settings, scan, std::move(used), run), std::move(states)};
}

} // namespace pcl_cid::tools
