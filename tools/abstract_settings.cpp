/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pcl_cid_abstract is told: its settings and its command line.
 */

#include "abstract_settings.h"

#include <cfloat>
#include <climits>
#include <cstdint>
#include <filesystem>

namespace pcl_cid::tools {
namespace {

void
declareMergeOptions(AbstractSettings& settings, CommandLine& line)
{
  line.group("Parts (without --parts, --threshold and --merges, as many as the merges "
             "themselves suggest)");
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
  line.number(
      "group-samples",
      "G",
      {1, 1 << 20, "a whole number, 1 to 1048576"},
      settings.group_samples,
      "points drawn from each group; its group CIDs are means of so many pairs");
  line.number("min-points",
              "N",
              {1, INT_MAX, "a whole number, at least 1"},
              settings.min_points,
              "drop parts of fewer points; no hull covers those");
  line.text("labels",
            "FILE",
            settings.labels,
            "write INPUT (.pcd or .ply) with the number of the part + 1 as label");
  line.text("tree", "FILE.json", settings.tree, "write all merges, in order");
  line.text("curve",
            "FILE.csv",
            settings.curve,
            "write how tightly hulls fit for many numbers of parts");
}

void
declareHullOptions(AbstractSettings& settings, CommandLine& line)
{
  const Allowed<double> length = {0.0, 1e15, "a number of metres, 0 or more"};
  line.group("Hulls");
  line.number("min-thickness",
              "R",
              {1e-15, 1e15, "a number of metres above 0"},
              settings.hulls.min_thickness,
              "least thickness of a hull, metres; thinner parts are thickened");
  line.optionalNumber("max-vertices",
                      "N",
                      {4, INT_MAX, "a whole number, at least 4"},
                      settings.max_vertices,
                      "most vertices of a hull; larger ones are simplified outward");
  line.number("padding",
              "R",
              length,
              settings.hulls.padding,
              "grow hulls outward by this, metres");
  line.number("trim-distance",
              "R",
              length,
              settings.hulls.trim_distance,
              "leave stray points out of hulls: clusters that are farther than this "
              "from the bulk of their part, metres; 0 for none");
  line.number("free-distance",
              "R",
              {1e-15, 1e15, "a number of metres above 0"},
              settings.free_distance,
              "for --report and --curve: space farther than this from the scan is "
              "free, metres");
  line.flag("verify",
            settings.verify,
            "read the meshes again and check what hulls guarantee; nothing is written "
            "when one fails");
}

} // namespace

std::string
AbstractSettings::materials() const
{
  return std::filesystem::path(output).replace_extension(".mtl").string();
}

bool
readCommandLine(int argc, const char* const* argv, AbstractSettings& settings)
{
  CommandLine line(
      abstract_tool,
      "pcl_cid_abstract INPUT OUTPUT [options]",
      "Turn a scan into convex hulls. INPUT is a PCD or PLY file, a room folder of\n"
      "S3DIS or a scan folder of ScanNet; OUTPUT is a mesh: .obj (an object for each\n"
      "part, colours in an .mtl beside it), .ply (colour and part number for each\n"
      "face) or .stl.");
  declareMergeOptions(settings, line);
  declareHullOptions(settings, line);
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
  for (const std::string& path :
       {settings.labels, settings.tree, settings.curve, settings.report})
    if (!path.empty())
      outputs.announce(path);
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
  report.parameters.push_back({"min_points", std::int64_t{settings.min_points}});
  report.parameters.push_back({"min_thickness", settings.hulls.min_thickness});
  if (settings.max_vertices)
    report.parameters.push_back({"max_vertices", std::int64_t{*settings.max_vertices}});
  report.parameters.push_back({"padding", settings.hulls.padding});
  report.parameters.push_back({"trim_distance", settings.hulls.trim_distance});
  report.parameters.push_back({"free_distance", settings.free_distance});
}

} // namespace pcl_cid::tools
