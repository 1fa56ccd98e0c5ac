/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_segment: labels of a few seeds, or groups, for all points of a scan.
 */

#include "heat_map.h"
#include "scannet_outputs.h"
#include "tool_run.h"

#include <pcl_cid/cid_label_propagation.h>
#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/scan_source.h>
#include <pcl_cid/io/seed_table.h>

#include <ostream>

namespace {

using namespace pcl_cid;
using namespace pcl_cid::tools;

constexpr const char* tool = "pcl_cid_segment";

struct SegmentSettings : Settings {
  std::string labels;
  std::string labels_from;
  std::string propose;
  ScannetSettings scannet;
  std::optional<int> cid_from;
};

bool
readCommandLine(int argc, const char* const* argv, SegmentSettings& settings)
{
  CommandLine line(
      tool,
      "pcl_cid_segment INPUT OUTPUT [options]",
      "Label every point of a scan by its CID-nearest seed. INPUT is a PCD or PLY "
      "file,\n"
      "a room folder of S3DIS or a scan folder of ScanNet (with their `label` and\n"
      "`semantic`); OUTPUT (.pcd or .ply) has the same points and fields, and the "
      "field\n"
      "`label`.\n\n"
      "  1. pcl_cid_segment scan.pcd groups.pcd --propose seeds.csv\n"
      "  2. fill in the column `label` of seeds.csv (0 for none; empty: not asked)\n"
      "  3. pcl_cid_segment scan.pcd labelled.pcd --labels seeds.csv\n\n"
      "Without --labels and --labels-from, the label is the number of the group + 1.\n"
      "Points that are not finite get label 0, which means none.");
  line.group("Labels");
  line.text("propose", "FILE.csv", settings.propose, "write the seeds, to be labelled");
  line.text("labels", "FILE.csv", settings.labels, "seeds with their labels");
  line.text("labels-from",
            "FIELD",
            settings.labels_from,
            "propose seeds and read their labels from this field of INPUT; prints how "
            "many points then have the label that the field says");
  declareHeatMapOption(settings.cid_from, line);
  declareScannetOptions(settings.scannet, line);
  declareSeedOptions(settings, line);
  declareRunOptions(settings, line);
  line.exclude(
      "labels",
      {"labels-from", "propose", "seeds", "coverage", "start-index", "seeding"});
  if (!line.parse(argc, argv, {&settings.input, &settings.output}))
    return false;
  requireExtension("OUTPUT", settings.output, {".pcd", ".ply"});
  checkScannetOptions(settings.scannet, settings.labels_from);
  return true;
}

void
announceOutputs(const SegmentSettings& settings, OutputFiles& outputs)
{
  announceScannetOutputs(settings.scannet, settings.input, outputs);
  outputs.announce(settings.output);
  if (!settings.propose.empty()) {
    if (holdsLabels(settings.propose))
      throw CIDException(settings.propose +
                         ": holds labels, which would be lost; choose another name");
    outputs.announce(settings.propose);
  }
  if (!settings.report.empty())
    outputs.announce(settings.report);
}

/** Label all points of a scan, and say what there is to say about it. */
void
propagateLabels(const SegmentSettings& settings,
                const LabelledCloud& cloud,
                const CloudPoints& points,
                Console& console,
                Report& report,
                SegmentedScan& scan)
{
  const std::vector<std::uint32_t>& truth = scan.true_labels;
  CIDLabelPropagation<pcl::PointXYZ> propagation;
  configure(settings, cloud, points, console, propagation);
  propagation.setInputCloud(points.points);
  if (!settings.labels.empty()) {
    const SeedTable table = readSeedTable(settings.labels, points);
    propagation.setSeeds(table.seeds, table.labels);
  }
  if (!truth.empty())
    propagation.setAnnotator(
        [&](pcl::index_t seed) { return truth[static_cast<std::size_t>(seed)]; });

  console.begin("Segmenting");
  propagation.segment(scan.labels);
  const SeedProposal& proposal = propagation.getProposal();
  console.end(std::to_string(proposal.seeds.size()) + " seeds", "segment", report);
  report.parameters = parametersOf(settings, propagation);
  describeDensity(propagation.getDensityDecision(), console, report);
  describeBlindSpot(propagation.getBlindSpot(), points.frame.origin, console, report);
  describeProposal(proposal, points, report);
  for (std::size_t k = 0; k < proposal.seeds.size(); ++k)
    report.seed_labels.push_back(
        !settings.labels.empty() ? propagation.getSeedLabels()[k]
        : !truth.empty()         ? truth[static_cast<std::size_t>(proposal.seeds[k])]
                                 : static_cast<std::uint32_t>(k + 1));
  scan.group = proposal.group;
}

void
printScore(const LabelScore& score, const Console& console)
{
  console.value("Right labels",
                percent(score.share()) + " of " + std::to_string(score.points) +
                    " finite points");
  console.value("Right labels where the true one is not 0",
                percent(score.shareOfLabelled()) + " of " +
                    std::to_string(score.labelled_points));
}

void
addParameters(const SegmentSettings& settings, Report& report)
{
  for (const auto& [name, value] : {std::pair("labels", settings.labels),
                                    std::pair("labels_from", settings.labels_from)})
    if (!value.empty())
      report.parameters.push_back({name, value});
}

void
segment(const SegmentSettings& settings)
{
  Console console(settings.quiet);
  Report report;
  report.tool = tool;
  std::vector<std::string> inputs = inputFiles(settings);
  inputs.push_back(settings.labels);
  OutputFiles outputs(inputs);
  announceOutputs(settings, outputs);

  CloudPoints points;
  LabelledCloud cloud = loadCloud(settings, console, report, points);
  SegmentedScan scan;
  scan.name = scanName(settings.input);
  if (!settings.labels_from.empty())
    scan.true_labels = labelsOf(cloud, settings.labels_from, points);
  if (!settings.scannet.submission.empty())
    scan.true_classes = labelsOf(cloud, "semantic", points);
  propagateLabels(settings, cloud, points, console, report, scan);
  addParameters(settings, report);
  console.value("Coverage", shortNumber(report.coverage.back()) + " metres");
  if (!scan.true_labels.empty()) {
    report.score =
        scoreLabels(settings.labels_from, scan.labels, scan.true_labels, points);
    printScore(*report.score, console);
  }

  console.begin("Saving " + settings.output);
  setLabels(scan.labels, settings.labelType(), cloud);
  outputs.write(settings.output, [&](std::ostream& stream) {
    writeCloud(stream, cloud, layoutFor(settings.output, cloud.layout));
  });
  if (!settings.propose.empty())
    outputs.write(settings.propose, [&](std::ostream& stream) {
      writeSeedTable(stream, report.seeds, points);
    });
  writeScannetOutputs(settings.scannet, scan, console, outputs);
  console.end(std::to_string(cloud.size()) + " points", "save", report);
  if (!settings.report.empty())
    outputs.write(settings.report, [&](std::ostream& s) { s << toJson(report); });
  outputs.commit();
}

} // namespace

int
main(int argc, char** argv)
{
  return runTool(tool, [&] {
    SegmentSettings settings;
    if (!readCommandLine(argc, argv, settings))
      return;
    if (settings.cid_from)
      writeHeatMap(tool, settings, *settings.cid_from);
    else
      segment(settings);
  });
}
