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
#include "run/failed_scans.h"
#include "run/run.h"
#include "run/score_files.h"
#include "run/words.h"
#include "scan_pairs.h"
#include "scoring.h"

#include <pcl_cid/io/output_files.h>

#include <iostream>
#include <set>

namespace {

using namespace pcl_cid;
using namespace pcl_cid::tools;

/** A scan of several that fails does not stop the others. */
void
scoreAll(const std::vector<ScanPair>& pairs, Scoring& scoring)
{
  if (pairs.size() == 1)
    return scoring.add(pairs.front());
  for (const ScanPair& pair : pairs)
    attempt(
        evaluate_tool, pair.name, [&] { scoring.add(pair); }, scoring.failed());
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
  requireNoFailure(report.failed, pairs.size(), "scored", FailureList::names);
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
