/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_evaluate: scores of instance labels against the truth.
 */

#include "evaluate_settings.h"
#include "evaluation_report.h"
#include "run/console.h"
#include "run/interruption.h"
#include "run/run.h"
#include "run/score_files.h"
#include "run/words.h"
#include "scan_pairs.h"
#include "scoring.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/output_files.h>

#include <cstdio>
#include <iostream>
#include <set>

namespace {

using namespace pcl_cid;
using namespace pcl_cid::tools;

/** A scan of several that fails does not stop the others. */
void
scoreAll(const std::vector<ScanPair>& pairs, Scoring& scoring)
{
  for (const ScanPair& pair : pairs) {
    try {
      scoring.add(pair);
    }
    catch (const Interrupted&) {
      throw;
    }
    catch (const std::exception& error) { // want of memory, too, stops one scan only
      if (pairs.size() == 1)
        throw;
      const char* const message = messageOf(error);
      std::fflush(stdout);
      std::fprintf(stderr, "%s: %s: %s\n", evaluate_tool, pair.name.c_str(), message);
      scoring.addFailure(pair, message);
    }
  }
}

std::string
describe(ClassRule rule)
{
  switch (rule) {
  case ClassRule::same_label:
    return "that of the truth instance whose label it carries";
  case ClassRule::prediction:
    return "the one that most of its points have in PREDICTION";
  default:
    return "the one that most of its points have in TRUTH";
  }
}

/** Where classes of predictions come from: each way once, as scans may differ. */
void
printClassRules(const EvaluationReport& report, const Console& console)
{
  std::set<ClassRule> rules;
  for (const ScoredScan& scan : report.scans)
    rules.insert(scan.class_rule);
  for (const ClassRule rule : rules)
    console.value("Class of a prediction", describe(rule));
}

void
print(const EvaluationReport& report,
      const EvaluateSettings& settings,
      const Console& console)
{
  if (settings.quiet)
    return;
  printTable(std::cout, report);
  std::cout << std::flush;
  if (report.classes.source == "none")
    console.value("Classes",
                  "none; TRUTH has no field '" + settings.fields.semantic + "'");
  printClassRules(report, console);
  console.value("Purity", shortNumber(report.pooled.purity));
  console.value("Compactness", shortNumber(report.pooled.compactness));
  console.value("Mean IoU of the truth instances", shortNumber(report.pooled.mean_iou));
}

/** The end of a run in which scans failed. */
void
requireNoFailure(const EvaluationReport& report)
{
  if (report.failed.empty())
    return;
  std::string names;
  for (const FailedScan& scan : report.failed)
    names += (names.empty() ? "" : ", ") + scan.name;
  throw CIDException(std::to_string(report.failed.size()) + " of " +
                     std::to_string(report.failed.size() + report.scans.size()) +
                     " scans could not be scored: " + names);
}

void
evaluateAll(const EvaluateSettings& settings)
{
  Console console(settings.quiet);
  const std::vector<ScanPair> pairs =
      pairScans(settings.prediction, settings.truth, settings.partial);
  ToolOutputs outputs(inputsOf(settings, pairs));
  announceScores(settings, outputs);
  Scoring scoring(settings, console);
  scoreAll(pairs, scoring);
  const EvaluationReport& report = scoring.finish();
  print(report, settings, console);
  saveScores(settings, report, outputs);
  requireNoFailure(report);
}

} // namespace

int
main(int argc, char** argv)
{
  return runTool(evaluate_tool, [&] {
    EvaluateSettings settings;
    if (readCommandLine(argc, argv, settings))
      evaluateAll(settings);
  });
}
