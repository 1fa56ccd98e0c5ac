/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_abstract: a scan as convex hulls of its approximately convex parts.
 */

#include "scene_outputs.h"
#include "tool_run.h"

#include <pcl_cid/cid_convex_abstraction.h>
#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/output_files.h>

#include <cfloat>
#include <climits>
#include <filesystem>
#include <ostream>

namespace {

using namespace pcl_cid;
using namespace pcl_cid::tools;

constexpr const char* tool = "pcl_cid_abstract";

struct AbstractSettings : Settings {
  std::optional<int> parts;
  std::optional<double> threshold;
  std::optional<int> merges;
  int group_samples = 16;
  double min_thickness = 0.005;
  std::string labels;
  std::string tree;
  SceneSettings scenes;

  bool
  isOBJ() const
  {
    return extensionOf(output) == ".obj";
  }

  /** \brief The material library beside an OBJ. */
  std::string
  materials() const
  {
    return std::filesystem::path(output).replace_extension(".mtl").string();
  }
};

void
declareMergeOptions(AbstractSettings& settings, CommandLine& line)
{
  line.group("Parts (without --parts, --threshold and --merges, each group is a part)");
  line.optionalNumber("parts",
                      "K",
                      {1, INT_MAX, "a whole number, at least 1"},
                      settings.parts,
                      "merge groups until this many parts remain");
  line.optionalNumber("threshold",
                      "R",
                      {0.0, DBL_MAX, "a number of metres, 0 or more"},
                      settings.threshold,
                      "merge while the smallest group CID is at most this, metres");
  line.optionalNumber("merges",
                      "T",
                      {0, INT_MAX, "a whole number, 0 or more"},
                      settings.merges,
                      "merge this many times");
  line.number("group-samples",
              "G",
              {1, 1 << 20, "a whole number, 1 to 1048576"},
              settings.group_samples,
              "points of each group that its group CIDs are estimated from");
  line.number("min-thickness",
              "R",
              {DBL_MIN, 1e15, "a number of metres above 0"},
              settings.min_thickness,
              "least thickness of a hull, metres; thinner parts are thickened");
  line.text("labels",
            "FILE",
            settings.labels,
            "write INPUT (.pcd or .ply) with the number of the part + 1 as label");
  line.text("tree", "FILE.json", settings.tree, "write all merges, in order");
}

bool
readCommandLine(int argc, const char* const* argv, AbstractSettings& settings)
{
  CommandLine line(
      tool,
      "pcl_cid_abstract INPUT OUTPUT [options]",
      "Turn a scan into convex hulls. INPUT is a PCD or PLY file; OUTPUT is a mesh: "
      ".obj\n"
      "(an object for each part, colours in an .mtl beside it), .ply (colour and part\n"
      "number for each face) or .stl.");
  declareMergeOptions(settings, line);
  declareSceneOptions(settings.scenes, line);
  declareSeedOptions(settings, line);
  declareRunOptions(settings, line);
  line.exclude("parts", {"threshold", "merges"});
  line.exclude("threshold", {"merges"});
  if (!line.parse(argc, argv, {&settings.input, &settings.output}))
    return false;
  requireExtension("OUTPUT", settings.output, {".obj", ".ply", ".stl"});
  if (!settings.labels.empty())
    requireExtension("--labels", settings.labels, {".pcd", ".ply"});
  checkSceneOptions(settings.scenes);
  return true;
}

void
announceOutputs(const AbstractSettings& settings, OutputFiles& outputs)
{
  announceScenes(settings.scenes, outputs);
  outputs.announce(settings.output);
  if (settings.isOBJ())
    outputs.announce(settings.materials());
  for (const std::string& path : {settings.labels, settings.tree, settings.report})
    if (!path.empty())
      outputs.announce(path);
}

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
  abstraction.setMinThickness(settings.min_thickness);
  abstraction.setStopAtCut(settings.tree.empty());
}

void
addParameters(const AbstractSettings& settings, Report& report)
{
  if (settings.parts)
    report.parameters.push_back({"parts", std::int64_t{*settings.parts}});
  if (settings.threshold)
    report.parameters.push_back({"threshold", *settings.threshold});
  if (settings.merges)
    report.parameters.push_back({"merges", std::int64_t{*settings.merges}});
  report.parameters.push_back({"group_samples", std::int64_t{settings.group_samples}});
  report.parameters.push_back({"min_thickness", settings.min_thickness});
}

struct Abstraction {
  std::vector<ConvexPart> parts;
  MergeTree tree;
};

Abstraction
makeParts(const AbstractSettings& settings,
          const CloudPoints& points,
          Console& console,
          Report& report)
{
  CIDConvexAbstraction<pcl::PointXYZ> abstraction;
  configure(settings, points, console, abstraction);
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
  translate(points.offset, result.parts);
  report.parameters = parametersOf(settings, abstraction);
  describeProposal(proposal, points, report);
  return result;
}

void
printParts(const std::vector<ConvexPart>& parts, const Console& console)
{
  double volume = 0.0;
  std::size_t thickened = 0;
  std::size_t boxed = 0;
  for (const ConvexPart& part : parts) {
    volume += part.volume;
    thickened += part.thickened ? 1 : 0;
    boxed += part.boxed ? 1 : 0;
  }
  console.value("Volume", shortNumber(volume) + " cubic metres");
  console.value("Thickened", std::to_string(thickened));
  if (boxed > 0)
    console.value("Boxes instead of hulls", std::to_string(boxed));
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
    else
      writeSTL(stream, parts);
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
    writeCloud(stream, cloud, formatFor(settings.labels, cloud.format));
  });
}

void
abstract(const AbstractSettings& settings)
{
  Console console(settings.quiet);
  Report report;
  report.tool = tool;
  OutputFiles outputs({settings.input});
  announceOutputs(settings, outputs);

  CloudPoints points;
  LabelledCloud cloud = loadCloud(settings.input, console, report, points);
  const Abstraction result = makeParts(settings, points, console, report);
  addParameters(settings, report);
  report.parts = &result.parts;
  console.value("Coverage", shortNumber(report.coverage.back()) + " metres");
  printParts(result.parts, console);

  console.begin("Saving " + settings.output);
  writeMesh(settings, result.parts, outputs);
  if (!settings.labels.empty())
    writeLabels(settings, result.parts, cloud, outputs);
  if (!settings.tree.empty())
    outputs.write(settings.tree, [&](std::ostream& s) { s << toJson(result.tree); });
  writeScenes(settings.scenes, result.parts, console, outputs, report);
  console.end(std::to_string(result.parts.size()) + " parts", "save", report);
  if (!settings.report.empty())
    outputs.write(settings.report, [&](std::ostream& s) { s << toJson(report); });
  outputs.commit();
}

} // namespace

int
main(int argc, char** argv)
{
  return runTool(tool, [&] {
    AbstractSettings settings;
    if (readCommandLine(argc, argv, settings))
      abstract(settings);
  });
}
