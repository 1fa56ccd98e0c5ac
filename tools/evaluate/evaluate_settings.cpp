/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pcl_cid_evaluate is told: its settings and its command line.
 */

#include "evaluate_settings.h"

#include "evaluation_report.h"
#include "run/command_line.h"

#include <pcl_cid/io/scan_source.h>

#include <exception>

namespace pcl_cid::tools {
namespace {

constexpr const char* about =
    "Score instance labels against the truth. PREDICTION and TRUTH are PCD or PLY "
    "files of the\nsame points in the same order, or two folders of such scans, paired "
    "by name; the scores are\nof all scans together.\n\n"
    "  1. pcl_cid_segment scan.pcd labelled.pcd --labels-from label\n"
    "  2. pcl_cid_evaluate labelled.pcd scan.pcd\n\n"
    "In the field `label`, 0 means none. The field `semantic` is the class.";

void
declareScoreOptions(EvaluateSettings& settings, CommandLine& line)
{
  line.group(protocol_setting.group);
  line.choice(protocol_setting, settings.protocol);
  line.text("classes",
            "s3dis|scannet|FILE",
            settings.classes,
            "what the numbers of classes mean: s3dis, scannet (nyu40id), or a file "
            "with a number and a name on each line; default scannet with --protocol "
            "scannet, else s3dis");
  line.text("class-table",
            "FILE.tsv",
            settings.class_table,
            "ScanNet's scannetv2-labels.combined.tsv, when TRUTH is of ScanNet; "
            "default: looked for in its folder and those above it");
  line.flag("partial",
            settings.partial,
            "the folder TRUTH may have scans that PREDICTION lacks");
}

void
declareFieldOptions(FieldNames& fields, CommandLine& line)
{
  line.group("Fields");
  line.text("prediction-field",
            "FIELD",
            fields.prediction,
            "labels of PREDICTION; default " + fields.prediction);
  line.text(
      "truth-field", "FIELD", fields.truth, "labels of TRUTH; default " + fields.truth);
  line.text("semantic-field",
            "FIELD",
            fields.semantic,
            "classes of both, of PREDICTION where it has them; default " +
                fields.semantic + ". A TRUTH without them has one class");
}

void
declareOutputOptions(EvaluateSettings& settings, CommandLine& line)
{
  line.group("Run");
  line.text("report", "FILE.json", settings.report, "write all scores as JSON");
  line.text("csv", "FILE.csv", settings.csv, "write all scores as a table");
  line.flag("quiet", settings.quiet, "print nothing but errors");
  line.helpOptions();
}

} // namespace

std::string
EvaluateSettings::classesOrDefault() const
{
  if (!classes.empty())
    return classes;
  return protocol == EvaluationProtocol::scannet ? "scannet" : "s3dis";
}

bool
readCommandLine(int argc, const char* const* argv, EvaluateSettings& settings)
{
  CommandLine line(evaluate_tool, "pcl_cid_evaluate PREDICTION TRUTH [options]", about);
  declareScoreOptions(settings, line);
  declareFieldOptions(settings.fields, line);
  declareOutputOptions(settings, line);
  return line.parse(argc,
                    argv,
                    {scanArgument("PREDICTION"), scanArgument("TRUTH")},
                    {&settings.prediction, &settings.truth});
}

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

} // namespace pcl_cid::tools
