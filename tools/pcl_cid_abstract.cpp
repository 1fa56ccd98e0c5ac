/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_abstract: a scan as convex hulls of its approximately convex parts.
 */

#include "abstract_settings.h"
#include "hull_verification.h"
#include "tightness_curve.h"

#include <pcl_cid/cid_convex_abstraction.h>
#include <pcl_cid/core/hull_guarantees.h>
#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/output_files.h>

#include <filesystem>
#include <ostream>

namespace {

using namespace pcl_cid;
using namespace pcl_cid::tools;

void
configureMerging(const AbstractSettings& settings,
                 CIDConvexAbstraction<pcl::PointXYZ>& abstraction)
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
  abstraction.setMaxVertices(settings.max_vertices.value_or(0));
  abstraction.setStopAtCut(settings.tree.empty() && settings.curve.empty());
}

struct Abstraction {
  std::vector<ConvexPart> parts;
  MergeTree tree;
  ConvexPartOptions hull_options;
  std::size_t dropped_points = 0;
  std::vector<CurvePoint> curve;
};

/** How tightly the hulls fit, for the report, and over all cuts, when asked for. */
void
measureTightness(const AbstractSettings& settings,
                 const CloudPoints& points,
                 CIDConvexAbstraction<pcl::PointXYZ>& abstraction,
                 Console& console,
                 Report& report,
                 Abstraction& result)
{
  if (settings.report.empty() && settings.curve.empty())
    return;
  console.begin("Measuring hulls");
  const TightnessMeter meter =
      makeMeter(points, settings.free_distance, settings.threads, console);
  report.tightness = meter.measure(result.parts);
  if (!settings.curve.empty())
    result.curve = tightnessCurve(meter, abstraction);
  console.end(
      percent(report.tightness->all.free_share) + " free space", "tightness", report);
}

Abstraction
makeParts(const AbstractSettings& settings,
          const LabelledCloud& cloud,
          const CloudPoints& points,
          Console& console,
          Report& report)
{
  CIDConvexAbstraction<pcl::PointXYZ> abstraction;
  configure(settings, cloud, points, console, abstraction);
  configureMerging(settings, abstraction);
  abstraction.setInputCloud(points.points);

  console.begin("Decomposing");
  std::vector<pcl::PointIndices> groups;
  abstraction.segment(groups);
  const SeedProposal& proposal = abstraction.getProposal();
  console.end(std::to_string(proposal.seeds.size()) + " groups, " +
                  std::to_string(groups.size()) + " parts",
              "decompose",
              report);
  console.begin("Computing hulls");
  Abstraction result;
  result.tree = abstraction.getMergeTree();
  abstraction.reconstruct(result.tree.cut(abstraction.getMergeCut()), result.parts);
  console.end(std::to_string(result.parts.size()) + " hulls", "hulls", report);
  result.hull_options = abstraction.getHullOptions();
  result.dropped_points = abstraction.getNumberOfDroppedPoints();
  report.parameters = parametersOf(settings, abstraction);
  describeDensity(abstraction.getDensityDecision(), console, report);
  describeBlindSpot(abstraction.getBlindSpot(), points.frame.origin, console, report);
  describeProposal(proposal, points, report);
  measureTightness(settings, points, abstraction, console, report, result);
  moveToFile(points.frame, result.parts);
  return result;
}

void
printParts(const Abstraction& result, const Report& report, const Console& console)
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
  if (report.tightness)
    console.value("Hull concavity",
                  shortNumber(report.tightness->all.max_concavity) + " metres, mean " +
                      shortNumber(report.tightness->all.mean_concavity));
}

/** STL holds float and has no pose: far from the origin, thin hulls fall flat in it. */
void
requireThickInFloat(const std::string& path, const std::vector<ConvexPart>& parts)
{
  constexpr double share = 0.25; // of the thickness that rounding may take
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (floatRounding(parts[i].hull) > share * parts[i].thickness)
      throw CIDException(path +
                         ": STL rounds coordinates to float, in which the hull "
                         "of " +
                         partName(i) +
                         " would lose its shape so far from the origin; choose .obj or "
                         ".ply, or --parts-dir with --parts-format stl beside them");
}

void
writeMesh(const AbstractSettings& settings,
          const std::vector<ConvexPart>& parts,
          OutputFiles& outputs)
{
  const std::string materials = settings.materials();
  outputs.write(settings.output, [&](std::ostream& stream) {
    if (settings.isOBJ())
      writeOBJ(stream, parts, std::filesystem::path(materials).filename().string());
    else if (extensionOf(settings.output) == ".ply")
      writePLY(stream, parts);
    else {
      requireThickInFloat(settings.output, parts);
      writeSTL(stream, parts);
    }
  });
  if (settings.isOBJ())
    outputs.write(materials, [&](std::ostream& stream) { writeMTL(stream, parts); });
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
  setLabels(labels, settings.labelType(), cloud);
  outputs.write(settings.labels, [&](std::ostream& stream) {
    writeCloud(stream, cloud, layoutFor(settings.labels, cloud.layout));
  });
}

/** Check what hulls guarantee on the meshes as they are on the disk. */
void
verify(const AbstractSettings& settings,
       const Verification& verification,
       const SceneDescription& scene,
       Console& console,
       OutputFiles& outputs,
       Report& report)
{
  console.begin("Verifying " + settings.output);
  verifyMesh(settings.output, verification, outputs);
  if (const std::string folder = settings.scenes.partsFolder(); !folder.empty())
    verifyParts(folder, scene, verification, outputs);
  console.end("all guarantees hold", "verify", report);
}

void
abstract(const AbstractSettings& settings)
{
  Console console(settings.quiet);
  Report report;
  report.tool = abstract_tool;
  OutputFiles outputs(inputFiles(settings));
  announceOutputs(settings, outputs);

  CloudPoints points;
  LabelledCloud cloud = loadCloud(settings, console, report, points);
  const Abstraction result = makeParts(settings, cloud, points, console, report);
  addParameters(settings, report);
  report.parts = &result.parts;
  console.value("Coverage", shortNumber(report.coverage.back()) + " metres");
  report.dropped_points = result.dropped_points;
  printParts(result, report, console);

  console.begin("Saving " + settings.output);
  writeMesh(settings, result.parts, outputs);
  if (!settings.labels.empty())
    writeLabels(settings, result.parts, cloud, outputs);
  if (!settings.tree.empty())
    outputs.write(settings.tree, [&](std::ostream& s) { s << toJson(result.tree); });
  if (!settings.curve.empty())
    outputs.write(settings.curve,
                  [&](std::ostream& s) { writeCurve(s, result.curve); });
  const SceneDescription scene =
      writeScenes(settings.scenes, result.parts, console, outputs, report);
  console.end(std::to_string(result.parts.size()) + " parts", "save", report);
  if (settings.verify)
    verify(settings,
           {result.parts, points, result.hull_options},
           scene,
           console,
           outputs,
           report);
  if (!settings.report.empty())
    outputs.write(settings.report, [&](std::ostream& s) { s << toJson(report); });
  outputs.commit();
}

} // namespace

int
main(int argc, char** argv)
{
  return runTool(abstract_tool, [&] {
    AbstractSettings settings;
    if (readCommandLine(argc, argv, settings))
      abstract(settings);
  });
}
