/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The parts that were chosen in a session of pcl_cid_studio.
 */

#include "session_parts.h"

#include "file_points.h"
#include "part_outputs.h"
#include "run/session_settings.h"
#include "simpler_bodies.h"
#include "tightness_curve.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/session_file.h>

#include <algorithm>
#include <utility>

namespace pcl_cid::tools {
namespace {

/** Those that are not dropped.
 *  \throws CIDException when there are none */
std::vector<ChosenPart>
keptParts(const PartSession& session)
{
  std::vector<ChosenPart> kept;
  for (ChosenPart& part : session.parts())
    if (!part.dropped)
      kept.push_back(std::move(part));
  if (kept.empty())
    throw CIDException(session.decomposition()
                           ? "all parts are dropped; keep at least one"
                           : "there are no parts yet; decompose the scan first");
  return kept;
}

/** The part of each point, as an index of the parts; -1 for what was dropped. */
std::vector<int>
partOfEachPoint(const PartSession& session, const std::vector<ChosenPart>& parts)
{
  const Decomposition& decomposition = *session.decomposition();
  std::vector<int> part_of_group(decomposition.tree.numberOfGroups(), -1);
  for (std::size_t k = 0; k < parts.size(); ++k)
    for (const int group : parts[k].groups)
      part_of_group[static_cast<std::size_t>(group)] = static_cast<int>(k);
  std::vector<int> part;
  for (const pcl::index_t point : session.scan().points().source) {
    const pcl::index_t group = decomposition.groups[static_cast<std::size_t>(point)];
    part.push_back(part_of_group[static_cast<std::size_t>(group)]);
  }
  return part;
}

/** Exact hulls in the place of those that need not be. */
void
makeExactHulls(const PointSet& points,
               const std::vector<int>& part,
               AbstractedScan& abstracted)
{
  for (std::size_t k = 0; k < abstracted.parts.size(); ++k) {
    if (!abstracted.isExact(k))
      continue;
    pcl::Indices members;
    for (std::size_t i = 0; i < part.size(); ++i)
      if (part[i] == static_cast<int>(k))
        members.push_back(static_cast<pcl::index_t>(i));
    abstracted.parts[k] = makeConvexPart(points, members, abstracted.optionsOf(k));
  }
}

void
makeHulls(const AbstractSettings& settings,
          const PartSession& session,
          const LoadedScan& scan,
          Run& run,
          AbstractedScan& abstracted)
{
  run.begin("Computing hulls");
  const std::vector<ChosenPart> kept = keptParts(session);
  for (const ChosenPart& part : kept)
    abstracted.is_exact.push_back(part.exact);
  const PointSet& points = session.scan().points();
  const std::vector<int> part = partOfEachPoint(session, kept);
  abstracted.parts = makeConvexParts(points,
                                     part,
                                     abstracted.hull_options,
                                     {settings.threads, run.console.progress()});
  makeExactHulls(points, part, abstracted);
  coverFilePoints(scan, abstracted);
  abstracted.dropped_points =
      static_cast<std::size_t>(std::count(part.begin(), part.end(), -1));
  run.end(std::to_string(kept.size()) + " hulls", "hulls");
}

void
describe(const AbstractSettings& settings,
         const PreparedScan& prepared,
         const LoadedScan& scan,
         Run& run)
{
  run.report.points_in = scan.points.points->size();
  run.report.points_finite = scan.points.finite;
  run.report.points_grouped = prepared.points().size();
  run.report.parameters = sessionParametersOf(settings.session, settings);
  describeDensity(prepared.density(), run);
  describeBlindSpot(prepared.blindSpot(), scan.points.frame, run);
}

} // namespace

AbstractedScan
abstractChosenParts(const AbstractSettings& settings,
                    const PartSession& session,
                    const LoadedScan& scan,
                    Run& run)
{
  AbstractedScan abstracted;
  abstracted.hull_options = settings.hullOptions();
  makeHulls(settings, session, scan, run, abstracted);
  abstracted.tree = session.decomposition()->tree;
  const PreparedScan::ConstPtr& prepared = session.sharedScan();
  findPrimitives(settings, {}, prepared, run, abstracted);
  simplify(settings, {}, prepared, run, abstracted);
  describe(settings, *prepared, scan, run);
  if (!settings.report.empty() || !settings.html.empty())
    measureTightness(settings, prepared, abstracted.parts, run);
  moveToFile(scan.points.frame, abstracted);
  return abstracted;
}

ScanFigures
writeSessionParts(AbstractSettings settings)
{
  const SessionRecord record = readSession(settings.session);
  useSettingsOf(record.settings, settings);
  Run run(abstract_tool, settings.quiet, inputsOf(settings));
  announceOutputs(settings, run.outputs);
  const LoadedScan scan = loadScan(settings, run);
  requireScanOf(record, identityOf(scan.cloud), settings.session);
  requireOutputsCanHold(settings, scan, run);

  run.begin("Preparing");
  const ExecutionOptions execution{settings.threads, run.console.progress()};
  PartSession session = preparePartSession(settings, scan, execution);
  run.end(std::to_string(scan.points.finite) + " finite points", "prepare");
  run.begin("Replaying " + settings.session);
  replayParts(record, settings.session, session, execution);
  run.end(std::to_string(record.part_actions.size()) + " actions on parts", "replay");

  const AbstractedScan abstracted = abstractChosenParts(settings, session, scan, run);
  writeParts(
      settings, {}, abstracted, scan, pointsOfParts(scan.cloud, abstracted.parts), run);
  return figuresOf(run.report);
}

} // namespace pcl_cid::tools
