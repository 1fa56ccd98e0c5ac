/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_simulate: what a simulated annotator's clicks are worth, and what those of a
 * session brought.
 */

#include "annotated_scan.h"
#include "replayed_session.h"
#include "run/run.h"
#include "run/score_files.h"
#include "run/session_settings.h"
#include "session_report.h"
#include "simulate_settings.h"
#include "simulation_report.h"

#include <pcl_cid/io/session_file.h>

#include <iostream>
#include <utility>

namespace {

using namespace pcl_cid;
using namespace pcl_cid::tools;

/** Print what was found, and write it. */
template <typename Found>
void
tell(const SimulateSettings& settings, const Found& report, Run& run)
{
  if (!settings.quiet) {
    printTable(std::cout, report);
    std::cout << std::flush;
  }
  saveScores(settings, report, run.outputs);
}

void
simulate(const SimulateSettings& settings)
{
  Run run(simulate_tool, settings.quiet, inputsOf(settings));
  announceScores(settings, run.outputs);
  SimulationReport report{settings, {}};
  for (const std::string& scan : settings.scans)
    report.scans.push_back(annotateScan(settings.withInput(scan), run));
  tell(settings, report, run);
}

void
replay(SimulateSettings settings)
{
  const SessionRecord record = readSession(settings.session);
  useSettingsOf(record.settings, settings);
  settings.input = settings.scans.front();
  Run run(simulate_tool, settings.quiet, inputsOf(settings));
  announceScores(settings, run.outputs);
  const ReplayedSession session = scoreSession(record, settings, run);
  tell(settings, SessionReport{settings, session}, run);
}

} // namespace

int
main(int argc, char** argv)
{
  return runTool(simulate_tool, [&] {
    SimulateSettings settings;
    if (!readCommandLine(argc, argv, settings))
      return;
    if (settings.session.empty())
      simulate(settings);
    else
      replay(std::move(settings));
  });
}
