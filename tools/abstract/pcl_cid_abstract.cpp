/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_abstract: a scan as convex hulls of its approximately convex parts.
 */

#include "abstract_settings.h"
#include "error_verification.h"
#include "file_points.h"
#include "hull_verification.h"
#include "mesh_output.h"
#include "primitive_verification.h"
#include "run/loaded_scan.h"
#include "run/run.h"
#include "run/words.h"
#include "simpler_bodies.h"
#include "tightness_curve.h"

#include <pcl_cid/cid_convex_abstraction.h>
#include <pcl_cid/core/hull_simplification.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/viewpoints.h>

#include <optional>
#include <ostream>

namespace {

using namespace pcl_cid;
using namespace pcl_cid::tools;

void
configureMerging(const AbstractSettings& settings, Abstraction& abstraction)
{
  if (settings.parts)
    abstraction.setNumberOfParts(*settings.parts);
  if (settings.threshold)
    abstraction.setMergeThreshold(*settings.threshold);
  if (settings.merges)
    abstraction.setNumberOfMerges(*settings.merges);
  abstraction.setGroupSampleSize(settings.group_samples);
  abstraction.setMinPoints(settings.min_points);
  abstraction.setHullOptions(settings.hulls);
  abstraction.setMaxVertices(
      settings.max_vertices.value_or(setting::max_vertices.initial));
  abstraction.setStopAtCut(settings.tree.empty() && settings.curve.empty());
}

bool
hasViewpointFile(const AbstractSettings& settings)
{
  return !settings.viewpoints.empty() && settings.viewpoints != "cloud";
}

/** Files that must never be written over. */
std::vector<std::string>
inputsOf(const AbstractSettings& settings)
{
  std::vector<std::string> inputs = inputFiles(settings);
  if (hasViewpointFile(settings))
    inputs.push_back(settings.viewpoints);
  return inputs;
}

/** Where the scan was taken from, in the frame of its points; none when nobody says.
 *  \param[in] read what is in the file, where one was given */
Viewpoints
localViewpoints(const AbstractSettings& settings,
                Viewpoints read,
                const LoadedScan& scan)
{
  if (settings.viewpoints == "cloud")
    return {scan.points.points->sensor_origin_.head<3>().cast<double>()};
  return scan.points.frame.toLocal(std::move(read));
}

void
configureFitting(const AbstractSettings& settings,
                 const Viewpoints& viewpoints,
                 Abstraction& abstraction)
{
  abstraction.setMergingRule(settings.mergingRule());
  if (settings.max_error)
    abstraction.setMaxError(*settings.max_error);
  if (settings.robot_radius)
    abstraction.setRobotRadius(*settings.robot_radius);
  abstraction.setViewpoints(viewpoints);
}

/** What became of the scan. */
struct AbstractedScan {
  std::vector<ConvexPart> parts;
  Primitives primitives; ///< in the place of parts in scenes
  MergeTree tree;
  ConvexPartOptions hull_options;
  std::size_t dropped_points = 0;
  std::vector<CurvePoint> curve;
};

/** How tightly the hulls fit, for the report, and over all cuts, when asked for. */
void
measureTightness(const AbstractSettings& settings,
                 Abstraction& abstraction,
                 Run& run,
                 AbstractedScan& result)
{
  if (settings.report.empty() && settings.curve.empty())
    return;
  run.begin("Measuring hulls");
  TightnessOptions options;
  options.free_distance = settings.free_distance;
  options.execution = {settings.threads, run.console.progress()};
  const TightnessMeter meter(abstraction.getPreparedScan(), options);
  run.report.tightness = meter.measure(result.parts);
  if (!settings.curve.empty())
    result.curve = tightnessCurve(meter, settings.fewest_vertices, abstraction);
  run.end(percent(run.report.tightness->all.free_share) + " free space", "tightness");
}

/** The bound on the error comes before the number of parts. */
void
checkNumberOfParts(const AbstractSettings& settings, std::size_t made, Run& run)
{
  if (!settings.parts || made <= static_cast<std::size_t>(*settings.parts))
    return;
  const std::string sentence =
      "the bound of " + shortNumber(*settings.max_error) + " m on the error takes " +
      std::to_string(made) + " hulls; --parts says " + std::to_string(*settings.parts);
  if (settings.strict)
    throw CIDException(sentence + ", and --strict that this is an error");
  run.remark()(sentence);
}

/** The parts whose hulls leave most places free. */
void
fit(const AbstractSettings& settings,
    Abstraction& abstraction,
    const LoadedScan& scan,
    Run& run,
    AbstractedScan& result)
{
  run.begin("Fitting hulls");
  abstraction.reconstruct(result.parts);
  result.hull_options = abstraction.getHullOptions();
  coverFilePoints(scan, result.hull_options, result.parts);
  result.dropped_points = abstraction.getNumberOfDroppedPoints();
  const HullFitting& fitting = abstraction.getHullFitting();
  run.report.points_in = scan.points.points->size();
  run.report.points_finite = scan.points.finite;
  run.report.points_grouped = fitting.part.size();
  run.report.places = {fitting.free_places, fitting.refused_places};
  run.end(std::to_string(result.parts.size()) + " hulls, " +
              percent(run.report.places->refusedShare()) +
              " of the free places refused",
          "fit");
  checkNumberOfParts(settings, fitting.parts, run);
}

/** The parts that the merge tree is cut into, and their hulls. */
void
decompose(Abstraction& abstraction,
          const LoadedScan& scan,
          Run& run,
          AbstractedScan& result)
{
  run.begin("Decomposing");
  std::vector<pcl::PointIndices> parts;
  abstraction.segment(parts);
  result.tree = abstraction.getMergeTree();
  run.end(std::to_string(abstraction.getProposal().seeds.size()) + " groups, " +
              std::to_string(parts.size()) + " parts",
          "decompose");
  run.begin("Computing hulls");
  abstraction.reconstruct(result.tree.cut(abstraction.getMergeCut()), result.parts);
  result.hull_options = abstraction.getHullOptions();
  coverFilePoints(scan, result.hull_options, result.parts);
  run.end(std::to_string(result.parts.size()) + " hulls", "hulls");
  result.dropped_points = abstraction.getNumberOfDroppedPoints();
}

AbstractedScan
abstract(const AbstractSettings& settings,
         const LoadedScan& scan,
         const Viewpoints& viewpoints,
         Run& run)
{
  Abstraction abstraction;
  configure(settings, scan, run.console, abstraction);
  configureMerging(settings, abstraction);
  configureFitting(settings, viewpoints, abstraction);
  abstraction.setInputCloud(scan.points.points);
  AbstractedScan result;
  const bool by_hull = settings.mergingRule() == MergingRule::hull;
  by_hull ? fit(settings, abstraction, scan, run, result)
          : decompose(abstraction, scan, run, result);
  result.primitives =
      findPrimitives(settings, viewpoints, result.parts, abstraction, run);
  simplify(settings, result.parts, abstraction, run);
  run.report.parameters = parametersOf(settings, abstraction);
  describeDensity(abstraction.getDensityDecision(), run);
  describeBlindSpot(abstraction.getBlindSpot(), scan.points.frame, run);
  if (!by_hull)
    describeProposal(abstraction.getProposal(), scan.points, run.report);
  measureTightness(settings, abstraction, run, result);
  moveToFile(scan.points.frame, result.parts);
  moveToFile(scan.points.frame, result.primitives);
  return result;
}

void
printParts(const AbstractedScan& result, const Console& console)
{
  double volume = 0.0;
  std::size_t thickened = 0;
  std::size_t boxed = 0;
  std::size_t trimmed = 0;
  for (const ConvexPart& part : result.parts) {
    trimmed += part.trimmed.size();
    volume += part.volume;
    thickened += part.thickened ? 1 : 0;
    boxed += part.boxed ? 1 : 0;
  }
  console.value("Volume", shortNumber(volume) + " cubic metres");
  console.value("Thickened", std::to_string(thickened));
  if (boxed > 0)
    console.value("Boxes instead of hulls", std::to_string(boxed));
  if (trimmed > 0)
    console.value("Stray points trimmed", std::to_string(trimmed));
  if (result.dropped_points > 0)
    console.value("Points in parts that were dropped, not covered",
                  std::to_string(result.dropped_points));
}

/** Tell the user and the report about the parts, which must outlive the report. */
void
describe(const AbstractSettings& settings, const AbstractedScan& result, Run& run)
{
  for (const Report::Parameter& each : partParametersOf(settings))
    run.report.parameters.push_back(each);
  run.report.parts = &result.parts;
  run.report.dropped_points = result.dropped_points;
  if (!run.report.coverage.empty())
    run.console.value("Coverage", shortNumber(run.report.coverage.back()) + " metres");
  printParts(result, run.console);
  if (run.report.tightness)
    run.console.value("Hull concavity",
                      shortNumber(run.report.tightness->all.max_concavity) +
                          " metres, mean " +
                          shortNumber(run.report.tightness->all.mean_concavity));
}

void
requireOutputsCanHold(const AbstractSettings& settings,
                      const LoadedScan& scan,
                      Run& run)
{
  requireRoomForFloat(settings.output, scan, settings.hulls.min_thickness);
  if (!settings.labels.empty())
    requireOutputHolds(settings.labels, scan, run);
}

void
writeLabels(const AbstractSettings& settings,
            const std::vector<ConvexPart>& parts,
            LabelledCloud& cloud,
            OutputFiles& outputs)
{
  std::vector<std::uint32_t> labels(cloud.size(), 0);
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (const pcl::index_t point : parts[i].indices)
      labels[static_cast<std::size_t>(point)] = static_cast<std::uint32_t>(i + 1);
  setLabels(labels, settings.label_type, cloud);
  writeScan(settings.labels, cloud, outputs);
}

SceneDescription
save(const AbstractSettings& settings,
     const AbstractedScan& result,
     LabelledCloud& cloud,
     Run& run)
{
  run.begin("Saving " + settings.output);
  saveMesh(settings.output, result.parts, run.outputs);
  if (!settings.labels.empty())
    writeLabels(settings, result.parts, cloud, run.outputs);
  if (!settings.tree.empty())
    run.outputs.write(settings.tree,
                      [&](std::ostream& s) { s << toJson(result.tree); });
  if (!settings.curve.empty())
    run.outputs.write(settings.curve,
                      [&](std::ostream& s) { writeCurve(s, result.curve); });
  const SceneDescription scene =
      writeScenes(settings.scenes, result.parts, result.primitives, run);
  run.end(std::to_string(result.parts.size()) + " parts", "save");
  return scene;
}

/** Check what hulls guarantee on the meshes as they are on the disk. */
void
verify(const AbstractSettings& settings,
       const Verification& verification,
       const SceneDescription& scene,
       Run& run)
{
  run.begin("Verifying " + settings.output);
  verifyMesh(settings.output, verification, run.outputs);
  if (const std::string folder = settings.scenes.partsFolder(); !folder.empty())
    verifyParts(folder, scene, verification, run.outputs);
  if (settings.scenes.primitives)
    for (const SceneFile& file : settings.scenes.wanted())
      verifyPrimitives(file, scene, verification, run.outputs);
  run.end("all guarantees hold", "verify");
}

/** What checks the bound on the error. */
std::optional<ErrorVerification>
errorVerification(const AbstractSettings& settings,
                  const LoadedScan& scan,
                  const Viewpoints& viewpoints)
{
  if (!settings.max_error)
    return std::nullopt;
  return std::optional<ErrorVerification>(
      std::in_place,
      scan.points,
      paddedBound(*settings.max_error, settings.hulls.padding),
      viewpoints);
}

void
runAbstract(const AbstractSettings& settings)
{
  Run run(abstract_tool, settings.quiet, inputsOf(settings));
  announceOutputs(settings, run.outputs);
  const Viewpoints read =
      hasViewpointFile(settings) ? readViewpoints(settings.viewpoints) : Viewpoints();
  LoadedScan scan = loadScan(settings, run);
  const Viewpoints viewpoints = localViewpoints(settings, read, scan);
  requireOutputsCanHold(settings, scan, run);
  const AbstractedScan result = abstract(settings, scan, viewpoints, run);
  describe(settings, result, run);
  const SceneDescription scene = save(settings, result, scan.cloud, run);
  if (settings.verify) {
    const std::optional<ErrorVerification> error =
        errorVerification(settings, scan, viewpoints);
    verify(settings,
           {result.parts,
            scan.points,
            FileCoordinates(scan.cloud),
            result.hull_options,
            error ? &*error : nullptr},
           scene,
           run);
  }
  run.finish(settings.report);
}

} // namespace

int
main(int argc, char** argv)
{
  return runTool(abstract_tool, [&] {
    AbstractSettings settings;
    if (readCommandLine(argc, argv, settings))
      runAbstract(settings);
  });
}
