/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pcl_cid_abstract is told: its settings and its command line.
 */

#include "abstract_settings.h"

#include "picture/picture.h"
#include "run/loaded_scan.h"
#include "run/parameter.h"
#include "run/session_settings.h"
#include "run/voxel_scan.h"
#include "run/words.h"

#include <pcl_cid/core/hull_simplification.h>
#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/mesh_export.h>
#include <pcl_cid/io/mesh_formats.h>

#include <cmath>

namespace pcl_cid::tools {
namespace {

const std::string group_options =
    "--threshold, --merges, --tree, --curve, --seeds, "
    "--coverage, --start-index, --groups or --group-samples";

constexpr const char* about =
    "Turn a scan into convex hulls. INPUT is a file of points (PCD, PLY, text,\n"
    "NumPy, KITTI; - is the standard input), a mesh, a room folder of S3DIS or a scan\n"
    "folder of ScanNet; OUTPUT is a mesh: .obj (an object for each part, colors in an\n"
    ".mtl beside it), .ply (color and part number for each face) or .stl.\n"
    "--gltf writes a .glb.";

void
declareMergeOptions(AbstractSettings& settings, CommandLine& line)
{
  line.group(std::string(setting::parts.group) +
             " (without --parts, --max-error, --threshold and --merges, as many as the "
             "merges themselves suggest)");
  line.optional(setting::parts, settings.parts);
  line.optional(setting::threshold, settings.threshold);
  line.optional(setting::merges, settings.merges);
  line.choice(setting::merging,
              settings.merging,
              "default hull, or cid where groups are needed: with " + group_options +
                  ", or without --parts and --max-error");
  line.optional(setting::max_error, settings.max_error);
  line.optional(setting::robot_radius,
                settings.robot_radius,
                "default " + shortNumber(setting::robot_radius.initial));
  line.text(
      "viewpoints",
      "cloud|FILE",
      settings.viewpoints,
      "merging by hull: where the scan was taken from (JSON or a table), or "
      "`cloud` for the viewpoint in INPUT; only what was seen counts as free then");
  line.flag("strict",
            settings.strict,
            "an error, where --max-error takes more hulls than --parts says");
  line.choice(setting::groups,
              settings.groups,
              std::string("default ") +
                  setting::groups.wordOf(setting::groups.initial));
  line.setting(setting::group_samples, settings.group_samples);
  line.setting(setting::min_points, settings.min_points);
  line.file("labels",
            "FILE",
            writableCloudExtensions(),
            settings.labels,
            "write INPUT (.pcd or .ply) with the number of the part + 1 as label");
  line.text("tree", "FILE.json", settings.tree, "write all merges, in order");
  line.text("curve",
            "FILE.csv",
            settings.curve,
            "write how tightly hulls fit for many numbers of parts");
  line.exclude(optionName(setting::parts),
               {optionName(setting::threshold), optionName(setting::merges)});
  line.exclude(optionName(setting::threshold), {optionName(setting::merges)});
  line.require("strict", {optionName(setting::max_error)});
}

/** Parts that a person has chosen. */
void
declareSessionParts(AbstractSettings& settings, CommandLine& line)
{
  declareSessionOption(
      settings.session,
      "the parts that were chosen in a session of pcl_cid_studio on INPUT",
      line);
  line.exclude("session",
               {optionName(setting::parts),
                optionName(setting::threshold),
                optionName(setting::merges),
                optionName(setting::merging),
                optionName(setting::max_error),
                optionName(setting::robot_radius),
                optionName(setting::groups),
                optionName(setting::group_samples),
                optionName(setting::min_points),
                "viewpoints",
                "strict",
                "curve"});
}

/** Each rule has options of its own. */
void
requireFittingRule(const AbstractSettings& settings)
{
  const bool by_hull = settings.mergingRule() == MergingRule::hull;
  if (!by_hull &&
      (settings.max_error || settings.robot_radius || !settings.viewpoints.empty()))
    throw UsageError(
        "--max-error, --robot-radius and --viewpoints need --merging hull, "
        "and neither --merging cid nor " +
        group_options);
  if (by_hull && !settings.parts && !settings.max_error)
    throw UsageError("--merging hull needs --parts or --max-error");
  if (by_hull && settings.isAboutGroups())
    throw UsageError(group_options +
                     " are about groups and their merges; leave them out with "
                     "--merging hull");
}

/** Patches come from the surface alone. */
void
requireSeeds(const AbstractSettings& settings)
{
  const bool about_seeds = settings.coverage || settings.start_index ||
                           settings.raw_scan.seeding != setting::seeding.initial;
  if (settings.groupRule() == GroupRule::patches && about_seeds)
    throw UsageError("--coverage, --start-index and --seeding are about seeds, and "
                     "patches have none; leave them out with --groups patches");
}

/** What a hull gains by the points that follow those of voxels must fit into the bound,
 *  too. */
void
requireRoomForVoxels(const AbstractSettings& settings)
{
  if (settings.voxel && settings.max_error &&
      settings.fittedError() <= settings.hulls.min_thickness)
    throw UsageError("--max-error must be more than --min-thickness and the diagonal "
                     "of a voxel, within which points may be left out of the fit: " +
                     shortNumber(*settings.max_error - settings.fittedError() +
                                 settings.hulls.min_thickness) +
                     " m; choose a larger bound or smaller voxels");
}

/** The format of OUTPUT, of each scan where there are several. */
const MeshFormat&
outputFormat(const AbstractSettings& settings)
{
  return meshFormatOf(settings.output.empty() ? "scan." + settings.many.format
                                              : settings.output);
}

/** Some formats are only written. */
void
requireReader(const AbstractSettings& settings)
{
  const MeshFormat& format = outputFormat(settings);
  if (settings.verify && !format.read)
    throw UsageError("--verify reads the meshes again, and there is no reader of " +
                     format.name + "; choose another format");
}

/** A mesh of a format without names, alone, has no use for one. */
void
requireNamedParts(const AbstractSettings& settings)
{
  const SceneSettings& scenes = settings.scenes;
  const MeshFormat& format = outputFormat(settings);
  if (!scenes.name.empty() && !format.names_parts && scenes.parts_dir.empty() &&
      scenes.wanted().empty())
    throw UsageError("--name has no effect without a scene or --parts-dir, as " +
                     format.name + " names no parts");
}

} // namespace

MergingRule
AbstractSettings::mergingRule() const
{
  if (merging)
    return *merging;
  const bool asks_for_hulls = parts || max_error || robot_radius || !viewpoints.empty();
  return asks_for_hulls && !isAboutGroups() ? MergingRule::hull : MergingRule::cid;
}

ConvexPartOptions
AbstractSettings::hullOptions() const
{
  ConvexPartOptions options = hulls;
  options.max_vertices =
      static_cast<std::size_t>(max_vertices.value_or(setting::max_vertices.initial));
  return options;
}

/** All points of a part are within a voxel's diagonal of points that were worked on,
 * and so is every place in their hull of the hull of these. */
double
AbstractSettings::fittedError() const
{
  return *max_error - std::sqrt(3.0) * voxel.value_or(0.0);
}

bool
AbstractSettings::isAboutGroups() const
{
  return threshold || merges || !tree.empty() || !curve.empty() || seeds || coverage ||
         start_index || groups || group_samples != setting::group_samples.initial;
}

void
declareHullOptions(AbstractSettings& settings, CommandLine& line)
{
  line.group(setting::min_thickness.group);
  line.setting(setting::min_thickness, settings.hulls.min_thickness);
  line.optional(setting::max_vertices,
                settings.max_vertices,
                "auto",
                settings.fewest_vertices,
                "auto: as few as --max-error allows, or, without it, so that none "
                "stands out by more than " +
                    shortNumber(100.0 * simplification_share) +
                    " % of the hull's diagonal");
  line.setting(setting::padding, settings.hulls.padding);
  line.setting(setting::trim_distance, settings.hulls.trim_distance);
  line.setting(
      setting::free_distance, settings.free_distance, "for figures of tightness");
}

bool
readCommandLine(int argc, const char* const* argv, AbstractSettings& settings)
{
  CommandLine line(abstract_tool,
                   "pcl_cid_abstract INPUT OUTPUT [options]\n"
                   "pcl_cid_abstract SCAN... --output-dir DIR [options]",
                   about);
  declareMergeOptions(settings, line);
  declareSessionParts(settings, line);
  declareHullOptions(settings, line);
  line.flag("verify",
            settings.verify,
            "read the meshes again and check what hulls guarantee; nothing is written "
            "when one fails");
  line.group("To look at");
  declarePictureOption(settings.html, line);
  declareSceneOptions(settings.scenes, line);
  declareSeedOptions(settings, line);
  settings.many.format = "obj";
  declareManyScans(settings.many, "mesh-format", withoutDots(meshExtensions()), line);
  line.exclude("name", {"output-dir"}); // each scan has its own
  declareRunOptions(settings, line);
  declareVoxelOption(
      settings.voxel,
      {"session", "curve", "class-table", optionName(setting::mesh_spacing)},
      line);
  if (!parseScans(argc,
                  argv,
                  outputArgument("OUTPUT", meshExtensions()),
                  nameOptions(settings),
                  settings,
                  line))
    return false;
  if (!settings.scenes.wanted().empty()) // as their parts are named
    requireDifferentNames(settings.many.scans, [](const std::string& scan) {
      return partsNameFrom(nameOfScan(scan));
    });
  requireReader(settings);
  requireFittingRule(settings);
  requireSeeds(settings);
  checkSceneOptions(settings.scenes);
  requireNamedParts(settings);
  checkVoxelOption(settings);
  requireRoomForVoxels(settings);
  return true;
}

std::vector<NameOption>
nameOptions(AbstractSettings& settings)
{
  std::vector<NameOption> options{{"viewpoints", &settings.viewpoints, true},
                                  {"session", &settings.session},
                                  {"labels", &settings.labels},
                                  {"tree", &settings.tree},
                                  {"curve", &settings.curve},
                                  {"report", &settings.report},
                                  {"html", &settings.html},
                                  {"parts-dir", &settings.scenes.parts_dir},
                                  {"mesh-prefix", &settings.scenes.mesh_prefix, true},
                                  {"frame", &settings.scenes.frame, true}};
  for (SceneFile& scene : settings.scenes.files)
    options.push_back({scene.format.option, &scene.path});
  return options;
}

bool
hasViewpointFile(const AbstractSettings& settings)
{
  return !settings.viewpoints.empty() && settings.viewpoints != "cloud";
}

std::vector<std::string>
inputsOf(const AbstractSettings& settings)
{
  std::vector<std::string> inputs = inputFiles(settings);
  if (hasViewpointFile(settings))
    inputs.push_back(settings.viewpoints);
  inputs.push_back(settings.session);
  return inputs;
}

void
announceOutputs(const AbstractSettings& settings, OutputFiles& outputs)
{
  announceScenes(settings.scenes, outputs);
  for (const std::string& path : {settings.output,
                                  materialsBeside(settings.output),
                                  settings.labels,
                                  settings.tree,
                                  settings.curve,
                                  settings.report})
    if (!path.empty())
      outputs.announce(path);
  announcePicture(settings.html, outputs);
}

std::vector<Report::Parameter>
partParametersOf(const AbstractSettings& settings)
{
  std::vector<Report::Parameter> list;
  if (settings.parts)
    list.push_back(parameter(setting::parts, *settings.parts));
  if (settings.threshold)
    list.push_back(parameter(setting::threshold, *settings.threshold));
  if (settings.merges)
    list.push_back(parameter(setting::merges, *settings.merges));
  list.push_back(parameter(setting::merging, settings.mergingRule()));
  if (settings.max_error)
    list.push_back(parameter(setting::max_error, *settings.max_error));
  if (settings.mergingRule() == MergingRule::hull)
    list.push_back(
        parameter(setting::robot_radius,
                  settings.robot_radius.value_or(setting::robot_radius.initial)));
  list.push_back(parameter(setting::groups, settings.groupRule()));
  list.push_back(parameter(setting::group_samples, settings.group_samples));
  list.push_back(parameter(setting::min_points, settings.min_points));
  list.push_back(parameter(setting::min_thickness, settings.hulls.min_thickness));
  if (settings.fewest_vertices)
    list.push_back({setting::max_vertices.name, std::string("auto")});
  else if (settings.max_vertices)
    list.push_back(parameter(setting::max_vertices, *settings.max_vertices));
  list.push_back(parameter(setting::padding, settings.hulls.padding));
  list.push_back(parameter(setting::trim_distance, settings.hulls.trim_distance));
  list.push_back(parameter(setting::free_distance, settings.free_distance));
  return list;
}

} // namespace pcl_cid::tools
