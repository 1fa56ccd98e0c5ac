/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_segment: labels of a few seeds, or groups, for all points of a scan.
 */

#include "heat_map.h"
#include "picture/picture.h"
#include "run/loaded_scan.h"
#include "run/run.h"
#include "run/scan_batch.h"
#include "run/voxel_scan.h"
#include "run/words.h"
#include "scannet_outputs.h"
#include "segment_settings.h"
#include "session_labels.h"

#include <pcl_cid/cid_label_propagation.h>
#include <pcl_cid/io/scan_source.h>
#include <pcl_cid/io/seed_table.h>

#include <limits>
#include <ostream>

namespace {

using namespace pcl_cid;
using namespace pcl_cid::tools;

/** What the fields of the scan say, as far as it is asked for. */
SegmentedScan
withTruth(const SegmentSettings& settings, const LoadedScan& scan, Run& run)
{
  SegmentedScan result;
  result.name = scan.name;
  const RemarkCallback remark = [&](const std::string& sentence) {
    run.remark()(sentence + (settings.voxel ? ", of those of voxels" : ""));
  };
  if (!settings.labels_from.empty())
    result.true_labels =
        labelsOf(scan.cloud, settings.labels_from, scan.points, remark);
  if (!settings.scannet.submission.empty())
    result.true_classes = labelsOf(scan.cloud, "semantic", scan.points, run.remark());
  requireLabelsFit(result.true_labels, settings.label_type);
  return result;
}

/** Those of the table, of the field, or else the numbers of the groups + 1. */
std::vector<std::uint32_t>
labelsOfSeeds(const SegmentSettings& settings,
              const CIDLabelPropagation<pcl::PointXYZ>& propagation,
              const std::vector<std::uint32_t>& truth)
{
  const pcl::Indices& seeds = propagation.getProposal().seeds;
  std::vector<std::uint32_t> labels;
  for (std::size_t k = 0; k < seeds.size(); ++k)
    labels.push_back(!settings.labels.empty() ? propagation.getSeedLabels()[k]
                     : !truth.empty() ? truth[static_cast<std::size_t>(seeds[k])]
                                      : static_cast<std::uint32_t>(k + 1));
  return labels;
}

/** Label all points of a scan, and say what there is to say about it. */
void
propagateLabels(const SegmentSettings& settings,
                const LoadedScan& scan,
                Run& run,
                SegmentedScan& result)
{
  const std::vector<std::uint32_t>& truth = result.true_labels;
  CIDLabelPropagation<pcl::PointXYZ> propagation;
  configure(settings, scan, run.console, propagation);
  propagation.setCleanUp(settings.clean_up);
  propagation.setInputCloud(scan.points.points);
  if (!settings.labels.empty()) {
    const SeedTable table = readSeedTable(settings.labels, scan.points);
    requireLabelsFit(table.labels, settings.label_type);
    for (const auto& [label, name] : table.names) {
      run.remark()(settings.labels + ": class '" + name + "' is label " +
                   std::to_string(label));
      result.instances.push_back({label, "", name});
    }
    propagation.setSeeds(table.seeds, table.labels);
  }
  if (!truth.empty())
    propagation.setAnnotator(
        [&](pcl::index_t seed) { return truth[static_cast<std::size_t>(seed)]; });

  run.begin("Segmenting");
  propagation.segment(result.labels);
  const SeedProposal& proposal = propagation.getProposal();
  run.end(std::to_string(proposal.seeds.size()) + " seeds", "segment");
  run.report.parameters = parametersOf(settings, propagation);
  describeDensity(propagation.getDensityDecision(), run);
  describeBlindSpot(propagation.getBlindSpot(), scan.points.frame, run);
  describeProposal(proposal, scan.points, run.report);
  run.report.seed_labels = labelsOfSeeds(settings, propagation, truth);
  result.group = proposal.group;
  result.seeds = proposal.seeds;
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
describe(const SegmentSettings& settings,
         const LoadedScan& scan,
         const SegmentedScan& result,
         Run& run)
{
  for (const Report::Parameter& each : labelParametersOf(settings))
    run.report.parameters.push_back(each);
  run.console.value("Coverage", shortNumber(run.report.coverage.back()) + " metres");
  if (result.true_labels.empty() || settings.voxel)
    return;
  run.report.score =
      scoreLabels(settings.labels_from, result.labels, result.true_labels, scan.points);
  printScore(*run.report.score, run.console);
}

void
saveSeeds(const SegmentSettings& settings,
          const SegmentedScan& result,
          const LoadedScan& scan,
          Run& run)
{
  if (!settings.propose.empty())
    run.outputs.write(settings.propose, [&](std::ostream& stream) {
      writeSeedTable(stream, result.seeds, scan.points);
    });
}

void
save(const SegmentSettings& settings,
     const SegmentedScan& result,
     LoadedScan& scan,
     Run& run)
{
  run.begin("Saving " + settings.output);
  setLabels(result.labels, settings.label_type, scan.cloud);
  writeScan(settings.output, scan.cloud, settings.output_unit, run.outputs);
  saveSeeds(settings, result, scan, run);
  writeScannetOutputs(settings.scannet, result, run.console, run.outputs);
  run.end(std::to_string(scan.cloud.size()) + " points", "save");
}

Picture
pictureOf(const SegmentSettings& settings, const SegmentedScan& result)
{
  const bool has_labels = !settings.labels.empty() || !settings.labels_from.empty();
  return {has_labels ? Picture::Kind::labels : Picture::Kind::groups,
          &result.labels,
          result.instances};
}

ScanFigures
segment(const SegmentSettings& settings)
{
  Run run(segment_tool, settings.quiet, inputsOf(settings));
  announceOutputs(settings, run.outputs);
  LoadedScan scan = loadScan(settings, run);
  SegmentedScan result = withTruth(settings, scan, run);
  requireOutputHolds(settings.output, scan, run);
  requirePictureOf(settings.html, scan);
  propagateLabels(settings, scan, run, result);
  describe(settings, scan, result, run);
  save(settings, result, scan, run);
  savePicture(settings.html, pictureOf(settings, result), scan, run);
  run.finish(settings.report);
  return figuresOf(run.report);
}

/** For labels of a block, of which it matters only which points count.
 *  \param[in] counts called with each point */
template <typename Counts>
CloudPoints
countedPoints(const LabelledCloud& block, const Counts& counts)
{
  CloudPoints points;
  points.points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  points.points->resize(block.size());
  for (std::size_t i = 0; i < block.size(); ++i) {
    if (counts(i))
      ++points.finite;
    else
      (*points.points)[i].x = std::numeric_limits<float>::quiet_NaN();
  }
  return points;
}

/** A truth that is no label shows before the work. */
void
checkTruth(const SegmentSettings& settings,
           const LabelledCloud& block,
           const VoxelPoints::Block& points)
{
  if (!settings.labels_from.empty())
    labelsOf(block, settings.labels_from, countedPoints(block, [&](std::size_t i) {
               return points[i].allFinite();
             }));
}

/** What the points of the file say, where those of the voxels were worked on. */
class FollowedPoints {
public:
  FollowedPoints(const SegmentSettings& settings,
                 const SegmentedScan& voxels,
                 Report& report)
  : settings_(settings), groups_(voxels.group, report), report_(report)
  {
    if (!settings.labels_from.empty())
      report.score = LabelScore{settings.labels_from};
  }

  void
  take(const LabelledCloud& block,
       const pcl::Indices& follows,
       const std::vector<std::uint32_t>& labels)
  {
    groups_.take(follows);
    if (report_.score)
      addScore(block, follows, labels);
  }

private:
  void
  addScore(const LabelledCloud& block,
           const pcl::Indices& follows,
           const std::vector<std::uint32_t>& labels)
  {
    const CloudPoints points =
        countedPoints(block, [&](std::size_t i) { return follows[i] >= 0; });
    const std::string& field = settings_.labels_from;
    const LabelScore score =
        scoreLabels(field, labels, labelsOf(block, field, points), points);
    report_.score->points += score.points;
    report_.score->right += score.right;
    report_.score->labelled_points += score.labelled_points;
    report_.score->right_labelled += score.right_labelled;
  }

  const SegmentSettings& settings_;
  FollowedGroups groups_;
  Report& report_;
};

/** Work on one point of each voxel, and let the others follow. */
ScanFigures
segmentVoxels(const SegmentSettings& settings)
{
  Run run(segment_tool, settings.quiet, inputsOf(settings));
  announceOutputs(settings, run.outputs);
  VoxelScan voxels(
      settings,
      settings.output,
      [&](const auto&... of_block) { checkTruth(settings, of_block...); },
      run);
  const LoadedScan& scan = voxels.scan();
  SegmentedScan result = withTruth(settings, scan, run);
  propagateLabels(settings, scan, run, result);
  describe(settings, scan, result, run);
  voxels.describe(settings, run.report);

  run.begin("Saving " + settings.output);
  FollowedPoints points(settings, result, run.report);
  voxels.writeLabels(
      settings,
      result.labels,
      [&](const auto&... of_block) { points.take(of_block...); },
      run);
  saveSeeds(settings, result, scan, run);
  run.end(std::to_string(run.report.points_in) + " points", "save");
  if (run.report.score)
    printScore(*run.report.score, run.console);
  run.finish(settings.report);
  return figuresOf(run.report);
}

/** All that is done with one scan. */
ScanFigures
segmentScan(const SegmentSettings& settings)
{
  if (settings.cid_from)
    return writeHeatMap(segment_tool, settings, *settings.cid_from);
  if (!settings.session.empty())
    return writeSessionLabels(segment_tool, settings);
  return settings.voxel ? segmentVoxels(settings) : segment(settings);
}

} // namespace

int
main(int argc, char** argv)
{
  return runTool(segment_tool, [&] {
    SegmentSettings settings;
    if (!readCommandLine(argc, argv, settings))
      return;
    if (settings.many.output_dir.empty())
      segmentScan(settings);
    else
      doEachScan(segment_tool, "Segmenting", "segmented", settings, segmentScan);
  });
}
