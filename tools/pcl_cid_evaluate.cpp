/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_evaluate: scores of instance labels against the truth.
 */

#include "class_table.h"
#include "compared_scan.h"
#include "evaluation_report.h"
#include "scan_pairs.h"
#include "tool_run.h"

#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/scan_source.h>

#include <cstdio>
#include <iostream>
#include <set>

namespace {

using namespace pcl_cid;
using namespace pcl_cid::tools;

constexpr const char* tool = "pcl_cid_evaluate";

struct EvaluateSettings {
  std::string prediction;
  std::string truth;
  std::size_t protocol = 0; ///< as in EvaluationProtocol
  FieldNames fields;
  std::string classes;     ///< empty: those of the protocol
  std::string class_table; ///< of ScanNet; empty: looked for
  bool partial = false;
  std::string report;
  std::string csv;
  bool quiet = false;

  EvaluationProtocol
  evaluationProtocol() const
  {
    return static_cast<EvaluationProtocol>(protocol);
  }

  std::string
  classesOrDefault() const
  {
    if (!classes.empty())
      return classes;
    return evaluationProtocol() == EvaluationProtocol::scannet ? "scannet" : "s3dis";
  }
};

bool
readCommandLine(int argc, const char* const* argv, EvaluateSettings& settings)
{
  CommandLine line(
      tool,
      "pcl_cid_evaluate PREDICTION TRUTH [options]",
      "Score instance labels against the truth. PREDICTION and TRUTH are PCD or PLY "
      "files of the\nsame points in the same order, or two folders of such scans, "
      "paired "
      "by name; the scores are\nof all scans together.\n\n"
      "  1. pcl_cid_segment scan.pcd labelled.pcd --labels-from label\n"
      "  2. pcl_cid_evaluate labelled.pcd scan.pcd\n\n"
      "In the field `label`, 0 means none. The field `semantic` is the class.");
  line.group("Scores");
  line.choice("protocol",
              "NAME",
              protocolNames(),
              settings.protocol,
              "whose rules: those of the paper (a prediction belongs to the truth "
              "instance whose label it carries), of ScanNet's benchmark, or of ASIS on "
              "S3DIS");
  line.text(
      "classes",
      "NAME",
      settings.classes,
      "what the numbers of classes mean: s3dis, scannet (nyu40id), or a file with a "
      "number and a name on each line; default scannet with --protocol scannet, "
      "else s3dis");
  line.text(
      "class-table",
      "FILE.tsv",
      settings.class_table,
      "ScanNet's scannetv2-labels.combined.tsv, when TRUTH is of ScanNet; default: "
      "looked for in its folder and those above it");
  line.flag("partial",
            settings.partial,
            "the folder TRUTH may have scans that PREDICTION lacks");
  line.group("Fields");
  line.text("prediction-field",
            "FIELD",
            settings.fields.prediction,
            "labels of PREDICTION; default label");
  line.text(
      "truth-field", "FIELD", settings.fields.truth, "labels of TRUTH; default label");
  line.text(
      "semantic-field",
      "FIELD",
      settings.fields.semantic,
      "classes of both, of PREDICTION where it has them; default semantic. A TRUTH "
      "without them has one class");
  line.group("Run");
  line.text("report", "FILE.json", settings.report, "write all scores as JSON");
  line.text("csv", "FILE.csv", settings.csv, "write all scores as a table");
  line.flag("quiet", settings.quiet, "print nothing but errors");
  line.helpOptions();
  return line.parse(
      argc, argv, {&settings.prediction, &settings.truth}, "PREDICTION and TRUTH");
}

void
announceOutputs(const EvaluateSettings& settings, OutputFiles& outputs)
{
  for (const std::string& path : {settings.report, settings.csv})
    if (!path.empty())
      outputs.announce(path);
}

/** What is read, as far as it can be told: a scan that is not as it should be is
 *  reported when its turn comes. */
std::vector<std::string>
inputsOf(const EvaluateSettings& settings, const std::vector<ScanPair>& pairs)
{
  std::vector<std::string> inputs{settings.classes, settings.class_table};
  for (const ScanPair& pair : pairs)
    for (const std::string& scan : {pair.prediction, pair.truth})
      try {
        for (const std::string& path : scanFiles(scan, settings.class_table))
          inputs.push_back(path);
      }
      catch (const std::exception&) {
        inputs.push_back(scan);
      }
  return inputs;
}

std::vector<std::uint32_t>
numbersOf(const SemanticClasses& classes)
{
  std::vector<std::uint32_t> numbers;
  for (const SemanticClass& each : classes)
    numbers.push_back(each.number);
  return numbers;
}

/** Reads scan after scan, keeps their overlaps, and scores them. */
class Scoring {
public:
  Scoring(const EvaluateSettings& settings, Console& console)
  : settings_(settings)
  , console_(console)
  , table_(classTable(settings.classesOrDefault()))
  {
    report_.prediction = settings.prediction;
    report_.truth = settings.truth;
    report_.protocol = settings.evaluationProtocol();
  }

  void
  add(const ScanPair& pair)
  {
    console_.begin("Scoring " + pair.name);
    ComparedScan scan = compareScans(
        pair, settings_.class_table, settings_.fields, table_.known, report_.protocol);
    for (const std::string& remark : scan.remarks)
      console_.remark(remark);
    settleClasses(pair, scan);
    report_.scans.push_back(
        {pair, scan.points, scan.class_rule, scan.remarks, evaluateScan(pair, scan)});
    overlaps_.push_back(std::move(scan.overlaps));
    console_.end(std::to_string(scan.points) + " points, " +
                     std::to_string(report_.scans.back().evaluation.truths) +
                     " truth instances, " +
                     std::to_string(report_.scans.back().evaluation.groups) + " groups",
                 "score",
                 steps_);
  }

  void
  addFailure(const ScanPair& pair, const std::string& error)
  {
    report_.failed.push_back({pair.name, error});
  }

  const EvaluationReport&
  finish()
  {
    if (report_.scans.empty())
      throw CIDException("none of the " + std::to_string(report_.failed.size()) +
                         " scans could be scored");
    report_.pooled =
        evaluate(overlaps_, report_.protocol, numbersOf(report_.classes.scored));
    return report_;
  }

private:
  /** The first scan says whether there are classes; the others must agree. */
  void
  settleClasses(const ScanPair& pair, const ComparedScan& scan)
  {
    const std::string field = pair.truth + ": has " + (scan.has_classes ? "a" : "no") +
                              " field '" + settings_.fields.semantic + "'";
    if (!scan.has_classes && !settings_.classes.empty())
      throw CIDException(field + ", which --classes is about");
    if (!report_.scans.empty() && has_classes_ != scan.has_classes)
      throw CIDException(field + ", unlike the scans before it");
    has_classes_ = scan.has_classes;
    report_.classes = has_classes_ ? table_ : oneClass();
  }

  Evaluation
  evaluateScan(const ScanPair& pair, const ComparedScan& scan) const
  {
    try {
      return evaluate(
          {scan.overlaps}, report_.protocol, numbersOf(report_.classes.scored));
    }
    catch (const CIDException& error) {
      throw CIDException(pair.prediction + ": " + error.what() +
                         " (the other protocols take any labels)");
    }
  }

  const EvaluateSettings& settings_;
  Console& console_;
  ClassTable table_;
  bool has_classes_ = false;
  std::vector<InstanceOverlaps> overlaps_;
  EvaluationReport report_;
  Report steps_; // seconds of each scan, which the console wants to keep somewhere
};

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
      const std::string message = messageOf(error);
      std::fflush(stdout);
      std::fprintf(stderr, "%s: %s: %s\n", tool, pair.name.c_str(), message.c_str());
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
  OutputFiles outputs(inputsOf(settings, pairs));
  announceOutputs(settings, outputs);

  Scoring scoring(settings, console);
  scoreAll(pairs, scoring);
  const EvaluationReport& report = scoring.finish();
  print(report, settings, console);
  if (!settings.report.empty())
    outputs.write(settings.report, [&](std::ostream& s) { s << toJson(report); });
  if (!settings.csv.empty())
    outputs.write(settings.csv, [&](std::ostream& s) { s << toCsv(report); });
  outputs.commit();
  requireNoFailure(report);
}

} // namespace

int
main(int argc, char** argv)
{
  return runTool(tool, [&] {
    EvaluateSettings settings;
    if (readCommandLine(argc, argv, settings))
      evaluateAll(settings);
  });
}
