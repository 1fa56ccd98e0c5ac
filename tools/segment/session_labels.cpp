/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The labels of a session of pcl_cid_studio, without the studio.
 */

#include "session_labels.h"

#include "picture/picture.h"
#include "run/loaded_scan.h"
#include "run/parameter.h"
#include "run/session_settings.h"
#include "segment_settings.h"

#include <pcl_cid/io/session_file.h>

namespace pcl_cid::tools {
namespace {

void
describe(const SegmentSettings& settings, const LabelSession& session, Report& report)
{
  report.parameters = sessionParametersOf(settings.session, settings);
  report.parameters.push_back(parameter(setting::clean_up, settings.clean_up));
  for (const SessionSeed& seed : session.seeds())
    report.seed_labels.push_back(seed.label.value_or(0));
}

} // namespace

ScanFigures
writeSessionLabels(const std::string& tool, SegmentSettings settings)
{
  const SessionRecord record = readSession(settings.session);
  useSettingsOf(record.settings, settings);
  Run run(tool, settings.quiet, inputsOf(settings));
  announceOutputs(settings, run.outputs);
  LoadedScan scan = loadScan(settings, run);
  requireScanOf(record, identityOf(scan.cloud), settings.session);
  requireOutputHolds(settings.output, scan, run);
  requirePictureOf(settings.html, scan);

  run.begin("Preparing");
  const ExecutionOptions execution{settings.threads, run.console.progress()};
  LabelSession session = prepareSession(settings, scan, execution);
  run.end(std::to_string(scan.points.finite) + " finite points", "prepare");
  run.begin("Replaying " + settings.session);
  const std::size_t done = replaySession(record, settings.session, session, execution);
  const std::vector<std::uint32_t> labels =
      settings.clean_up ? session.cleanedLabels({}, execution) : session.labels();
  run.end(std::to_string(done) + " actions", "replay");
  describeDensity(session.scan().density(), run);
  describeProposal(session.grouping().proposal(), scan.points, run.report);
  describe(settings, session, run.report);

  run.begin("Saving " + settings.output);
  setLabels(labels, settings.label_type, scan.cloud);
  writeScan(settings.output, scan.cloud, settings.output_unit, run.outputs);
  run.end(std::to_string(scan.cloud.size()) + " points", "save");
  savePicture(
      settings.html, {Picture::Kind::labels, &labels, session.instances()}, scan, run);
  run.finish(settings.report);
  return figuresOf(run.report);
}

} // namespace pcl_cid::tools
