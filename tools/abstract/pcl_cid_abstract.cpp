/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_abstract: a scan as convex hulls of its approximately convex parts.
 */

#include "abstract_settings.h"
#include "file_points.h"
#include "part_outputs.h"
#include "run/loaded_scan.h"
#include "run/run.h"
#include "run/scan_batch.h"
#include "run/words.h"
#include "session_parts.h"
#include "simpler_bodies.h"
#include "tightness_curve.h"
#include "voxel_parts.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/viewpoints.h>

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
  abstraction.setGroupRule(settings.groupRule());
  abstraction.setGroupSampleSize(settings.group_samples);
  abstraction.setMinPoints(settings.min_points);
  abstraction.setHullOptions(settings.hullOptions());
  abstraction.setStopAtCut(settings.tree.empty() && settings.curve.empty());
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
  for (Eigen::Vector3d& place : read)
    place *= scan.points.metres_per_unit;
  return scan.points.frame.toLocal(std::move(read));
}

void
configureFitting(const AbstractSettings& settings,
                 const Viewpoints& viewpoints,
                 Abstraction& abstraction)
{
  abstraction.setMergingRule(settings.mergingRule());
  if (settings.max_error)
    abstraction.setMaxError(settings.fittedError());
  if (settings.robot_radius)
    abstraction.setRobotRadius(*settings.robot_radius);
  abstraction.setViewpoints(viewpoints);
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
decompose(Abstraction& abstraction, Run& run, AbstractedScan& result)
{
  run.begin("Decomposing");
  std::vector<pcl::PointIndices> parts;
  abstraction.segment(parts);
  result.tree = abstraction.getMergeTree();
  run.end(std::to_string(result.tree.numberOfGroups()) + " groups, " +
              std::to_string(parts.size()) + " parts",
          "decompose");
  run.begin("Computing hulls");
  abstraction.reconstruct(result.tree.cut(abstraction.getMergeCut()), result.parts);
  run.end(std::to_string(result.parts.size()) + " hulls", "hulls");
}

/** What was merged, for the report. */
void
describeGroups(const Abstraction& abstraction, const LoadedScan& scan, Run& run)
{
  if (abstraction.getPatches())
    describePatches(*abstraction.getPatches(), scan.points, run.report);
  else
    describeProposal(abstraction.getProposal(), scan.points, run.report);
}

/** How tightly the hulls fit, for the report, and over all cuts, when asked for. */
void
measureTightness(const AbstractSettings& settings,
                 const AbstractedScan& result,
                 Abstraction& abstraction,
                 Run& run)
{
  if (settings.report.empty() && settings.html.empty() && settings.curve.empty())
    return;
  const TightnessMeter meter =
      measureTightness(settings, abstraction.getPreparedScan(), result.parts, run);
  if (settings.curve.empty())
    return;
  run.begin("Measuring all cuts");
  const auto curve = tightnessCurve(meter, settings.fewest_vertices, abstraction);
  run.outputs.write(settings.curve, [&](std::ostream& s) { writeCurve(s, curve); });
  run.end(std::to_string(curve.size()) + " cuts", "curve");
}

/** Of each point, -1 where there are none. */
std::vector<pcl::index_t>
groupsOf(const Abstraction& abstraction)
{
  return abstraction.getPatches() ? abstraction.getPatches()->groups()
                                  : abstraction.getProposal().group;
}

/** \param[in] voxels where the points of the scan are those of voxels; else null */
AbstractedScan
abstract(const AbstractSettings& settings,
         const LoadedScan& scan,
         const Viewpoints& viewpoints,
         VoxelParts* voxels,
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
          : decompose(abstraction, run, result);
  result.hull_options = abstraction.getHullOptions();
  result.dropped_points = abstraction.getNumberOfDroppedPoints();
  if (!by_hull)
    describeGroups(abstraction, scan, run);
  if (voxels)
    voxels->cover(groupsOf(abstraction), result);
  else
    coverFilePoints(scan, result);
  const PreparedScan::ConstPtr prepared = abstraction.prepare();
  findPrimitives(settings, viewpoints, prepared, run, result);
  simplify(settings, viewpoints, prepared, run, result);
  run.report.parameters = parametersOf(settings, abstraction);
  describeDensity(abstraction.getDensityDecision(), run);
  describeBlindSpot(abstraction.getBlindSpot(), scan.points.frame, run);
  measureTightness(settings, result, abstraction, run);
  moveToFile(scan.points.frame, result);
  return result;
}

/** None where no file has any. */
Viewpoints
viewpointsOfFile(const AbstractSettings& settings)
{
  return hasViewpointFile(settings) ? readViewpoints(settings.viewpoints)
                                    : Viewpoints();
}

ScanFigures
runAbstract(const AbstractSettings& settings)
{
  Run run(abstract_tool, settings.quiet, inputsOf(settings));
  announceOutputs(settings, run.outputs);
  const Viewpoints read = viewpointsOfFile(settings);
  const LoadedScan scan = loadScan(settings, run);
  const Viewpoints viewpoints = localViewpoints(settings, read, scan);
  requireOutputsCanHold(settings, scan, run);
  const AbstractedScan result = abstract(settings, scan, viewpoints, nullptr, run);
  writeParts(
      settings, viewpoints, result, scan, pointsOfParts(scan.cloud, result.parts), run);
  return figuresOf(run.report);
}

/** Work on one point of each voxel, and let hulls contain those that follow, too. */
ScanFigures
abstractVoxels(const AbstractSettings& settings)
{
  Run run(abstract_tool, settings.quiet, inputsOf(settings));
  announceOutputs(settings, run.outputs);
  const Viewpoints read = viewpointsOfFile(settings);
  VoxelScan voxels(settings, settings.labels, {}, run);
  const LoadedScan& scan = voxels.scan();
  const Viewpoints viewpoints = localViewpoints(settings, read, scan);
  requireOutputsCanHold(settings, scan, run);
  VoxelParts parts(settings, voxels, run);
  const AbstractedScan result = abstract(settings, scan, viewpoints, &parts, run);
  voxels.describe(settings, run.report);
  writeParts(settings, viewpoints, result, scan, parts.show(), run);
  return figuresOf(run.report);
}

/** All that is done with one scan. */
ScanFigures
abstractScan(const AbstractSettings& settings)
{
  if (!settings.session.empty())
    return writeSessionParts(settings);
  return settings.voxel ? abstractVoxels(settings) : runAbstract(settings);
}

} // namespace

int
main(int argc, char** argv)
{
  return runTool(abstract_tool, [&] {
    AbstractSettings settings;
    if (!readCommandLine(argc, argv, settings))
      return;
    if (settings.many.output_dir.empty())
      abstractScan(settings);
    else
      doEachScan(abstract_tool, "Abstracting", "abstracted", settings, abstractScan);
  });
}
