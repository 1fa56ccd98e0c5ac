/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts whose hulls leave free space free: divide, merge, give away, and again.
 */

#include "base/requirements.h"
#include "base/sentence.h"
#include "cell.h"

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/hull_fitting.h>
#include <pcl_cid/exceptions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace pcl_cid {
namespace {

/** Later rounds begin from the parts of the one before, whose borders are better places
 *  to cut than those of a first guess. */
constexpr int rounds = 5;

void
requireUsable(const HullFittingSettings& settings)
{
  requireAtLeast("number of parts", settings.parts, std::size_t{1});
  if (settings.hasBound())
    require(setting::max_error, settings.max_error);
  require(setting::robot_radius, settings.robot_radius);
  require(setting::min_thickness, settings.min_thickness);
  requireFinite(settings.viewpoints);
}

/** Least width of a hull: thinner than its tolerance, it would have no faces. */
double
thicknessOf(const Points& points, const HullFittingSettings& settings)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& p : points)
    box.extend(p.cast<double>());
  const double thickness =
      std::max(settings.min_thickness, hull_tolerance * box.diagonal().norm());
  if (settings.hasBound() && settings.max_error <= thickness)
    throw CIDException(sentence("the bound of ",
                                settings.max_error,
                                " m on the error is not above the least thickness of a "
                                "hull, ",
                                thickness,
                                " m; choose a larger bound or thinner hulls"));
  return thickness;
}

/** Cells that a round begins with: enough to choose from, few enough to compare. */
std::size_t
cellsOfRound(int round, std::size_t parts)
{
  return round == 0 ? std::clamp<std::size_t>(12 * parts, 1000, 4000)
                    : std::clamp<std::size_t>(10 * parts, 300, 3000);
}

/** Fewer parts are better, then fewer places taken. */
std::pair<std::size_t, std::size_t>
rankOf(const std::vector<Cell>& cells, const FittingScene& scene, std::size_t parts)
{
  return {std::max(cells.size(), parts), placesTaken(cells, scene.space)};
}

std::vector<Cell>
bestOfRounds(const FittingScene& scene, std::size_t parts, Progress& progress)
{
  pcl::Indices all(scene.points.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<Cell> cells = {makeCell(std::move(all), scene)};
  std::vector<Cell> best;
  for (int round = 0; round < rounds; ++round) {
    const std::size_t enough = cellsOfRound(round, std::max(parts, cells.size()));
    cells = divideCells(std::move(cells), enough, scene, progress);
    cells = mergeCells(cells,
                       parts,
                       scene,
                       progress,
                       {(round + 0.3) / rounds, (round + 0.9) / rounds});
    cells = giveAway(std::move(cells), scene, progress);
    if (best.empty() || rankOf(cells, scene, parts) < rankOf(best, scene, parts))
      best = cells;
    progress.check(static_cast<double>(round + 1) / rounds);
  }
  return best;
}

/** The part of each point; parts are numbered by their first points. */
std::vector<int>
numbered(std::vector<Cell> cells, std::size_t points)
{
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
    return a.points.front() < b.points.front();
  });
  std::vector<int> part(points);
  for (std::size_t k = 0; k < cells.size(); ++k)
    for (const pcl::index_t i : cells[k].points)
      part[static_cast<std::size_t>(i)] = static_cast<int>(k);
  return part;
}

} // namespace

HullFitting
fitHulls(const PreparedScan& scan,
         const HullFittingSettings& settings,
         const ExecutionOptions& execution)
{
  requireUsable(settings);
  const Points& points = scan.points().points;
  const double thickness = thicknessOf(points, settings);
  const std::vector<Eigen::Vector3d> viewpoints =
      scan.points().frame.toLocal(settings.viewpoints);
  const int threads = threadCount(execution.threads);
  Progress progress(execution.progress);
  const double clearance =
      std::max(settings.robot_radius, setting::free_distance.initial);
  const FreeSpace space(points, scan.field(), clearance, viewpoints, threads, progress);
  // Places deeper than the bound allows, where only those count that were seen.
  std::optional<FreeSpace> deep;
  const double max_error = settings.max_error - thickness;
  if (settings.hasBound() && !viewpoints.empty())
    deep.emplace(points, scan.field(), max_error, viewpoints, threads, progress);
  const FittingScene scene{points,
                           scan.field(),
                           space,
                           deep ? &*deep : nullptr,
                           settings.robot_radius,
                           max_error,
                           thickness,
                           threads};

  const std::vector<Cell> cells = bestOfRounds(scene, settings.parts, progress);
  HullFitting fitting;
  fitting.parts = cells.size();
  fitting.free_places = space.size();
  fitting.refused_places = placesTaken(cells, space);
  fitting.part = numbered(cells, points.size());
  return fitting;
}

} // namespace pcl_cid
