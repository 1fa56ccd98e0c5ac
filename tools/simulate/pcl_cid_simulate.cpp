/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_simulate: what a simulated annotator's clicks are worth.
 */

#include "annotated_scan.h"
#include "run/run.h"
#include "run/score_files.h"
#include "simulate_settings.h"
#include "simulation_report.h"

#include <iostream>

namespace {

using namespace pcl_cid;
using namespace pcl_cid::tools;

void
simulate(const SimulateSettings& settings)
{
  Run run(simulate_tool, settings.quiet, inputsOf(settings));
  announceScores(settings, run.outputs);
  SimulationReport report{settings, {}};
  for (const std::string& scan : settings.scans)
    report.scans.push_back(annotateScan(settings.withInput(scan), run));
  if (!settings.quiet) {
    printTable(std::cout, report);
    std::cout << std::flush;
  }
  saveScores(settings, report, run.outputs);
}

} // namespace

int
main(int argc, char** argv)
{
  return runTool(simulate_tool, [&] {
    SimulateSettings settings;
    if (readCommandLine(argc, argv, settings))
      simulate(settings);
  });
}
