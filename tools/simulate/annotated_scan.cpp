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
#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/scan_source.h>

#include <algorithm>
#include <utility>

namespace pcl_cid::tools {
namespace {

std::vector<std::uint32_t>
trueLabels(const SimulateSettings& settings, const LoadedScan& scan, Run& run)
{
  std::vector<std::uint32_t> truth =
      labelsOf(scan.cloud, settings.truth_field, scan.points, run.remark());
  if (std::all_of(truth.begin(), truth.end(), [](auto label) { return label == 0; }))
    throw CIDException(settings.input + ": field '" + settings.truth_field +
                       "' is 0, which means none, for all of its " +
                       std::to_string(scan.points.finite) +
                       " finite points; at least 1 must have another label");
  return truth;
}

std::vector<AnnotationState>
annotate(const SimulateSettings& settings,
         const AnnotationTask& task,
         const ExecutionOptions& execution)
{
  switch (settings.protocol) {
  case AnnotationProtocol::proposals:
    return annotateProposals(task, settings.clicks, execution);
  case AnnotationProtocol::corrective:
    return annotateCorrections(task,
                               settings.clicks,
                               static_cast<std::size_t>(settings.proposals.value_or(0)),
                               execution);
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
  AnnotatedScan result;
  result.states = annotate(settings, task, {settings.threads, run.console.progress()});
  run.end(std::to_string(result.states.back().clicks) + " clicks", "annotate");

  result.name = scanName(settings.input);
  result.input = settings.input;
  result.remarks = std::exchange(run.report.remarks, {});
  result.parameters = groupingParametersOf(settings, parameters);
  result.parameters.push_back(parameter(setting::clean_up, settings.clean_up));
  result.points = scan.cloud.size();
  result.finite = scan.points.finite;
  return result;
}

} // namespace pcl_cid::tools
