/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan made ready for CID: once, for everything that follows.
 */

#include "blind_spot.h"
#include "isolated_points.h"
#include "lab_color.h"
#include "local_spacing.h"
#include "raw_scan_checks.h"
#include "surface_graph.h"
#include "surface_normals.h"
#include "working_set.h"

#include "base/parallel_for.h"
#include "base/random.h"
#include "base/requirements.h"
#include "cid/pair_cost.h"
#include "cid/working_points.h"

#include <pcl_cid/core/prepared_scan.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace pcl_cid {
namespace {

/** Position of a point of the input cloud, -1 when it is not among the points. */
pcl::index_t
positionOf(const PointSet& points, pcl::index_t cloud_index)
{
  const auto found =
      std::lower_bound(points.source.begin(), points.source.end(), cloud_index);
  if (found == points.source.end() || *found != cloud_index)
    return -1;
  return static_cast<pcl::index_t>(found - points.source.begin());
}

pcl::index_t
requirePosition(const PointSet& points, pcl::index_t cloud_index, const char* name)
{
  const pcl::index_t position = positionOf(points, cloud_index);
  if (position < 0)
    throw CIDException(sentence("the ",
                                name,
                                " is point ",
                                cloud_index,
                                "; it must be a finite, selected point of the input"));
  return position;
}

pcl::Indices
candidatePositions(const PointSet& points, const PreparationSettings& settings)
{
  pcl::Indices positions;
  if (!settings.seed_candidates)
    return positions;
  for (const pcl::index_t candidate : *settings.seed_candidates)
    if (const pcl::index_t position = positionOf(points, candidate); position >= 0)
      positions.push_back(position);
  if (positions.empty())
    throw CIDException("none of the seed candidates is a finite, selected point of the "
                       "input; at least 1 must be");
  return positions;
}

/** "randomly pick a point p*" (Algorithm 1), or the one that the user wants. */
pcl::index_t
startPosition(const PointSet& points,
              const pcl::Indices& candidates,
              const PreparationSettings& settings,
              RandomGenerator& generator)
{
  if (settings.start_index)
    return requirePosition(points, *settings.start_index, "start index");
  if (candidates.empty())
    return static_cast<pcl::index_t>(drawBelow(generator, points.size()));
  return candidates[drawBelow(generator, candidates.size())];
}

/** The indices that are not among others; both ascending. */
pcl::Indices
without(const pcl::Indices& all, const pcl::Indices& others)
{
  pcl::Indices left;
  std::set_difference(
      all.begin(), all.end(), others.begin(), others.end(), std::back_inserter(left));
  return left;
}

/** The points that may become seeds, ascending; without candidates, all. */
pcl::Indices
possibleSeeds(const pcl::Indices& candidates, std::size_t points)
{
  pcl::Indices possible = candidates;
  if (possible.empty()) {
    possible.resize(points);
    std::iota(possible.begin(), possible.end(), 0);
  }
  std::sort(possible.begin(), possible.end());
  return possible;
}

/** Colors of the points that are worked on, in metres. */
Cue
colorCue(const WorkingSet& working,
         const std::vector<ColorRGB>& colors,
         const NearestNeighbors& neighbors,
         float weight)
{
  std::vector<ColorRGB> of_working;
  for (std::size_t i = 0; i < working.points().size(); ++i)
    of_working.push_back(colors[static_cast<std::size_t>(
        working.positionOf(static_cast<pcl::index_t>(i)))]);
  Cue cue{Cue::Property::color, smoothLab(of_working, neighbors)};
  for (Eigen::Vector3f& color : cue.values)
    color *= weight;
  return cue;
}

Cue
normalCue(const Points& points,
          const NearestNeighbors& neighbors,
          float weight,
          const ExecutionOptions& execution)
{
  Cue cue{Cue::Property::normal, surfaceNormals(points, neighbors, execution)};
  for (Eigen::Vector3f& normal : cue.values)
    normal *= std::sqrt(weight / 2.0f);
  return cue;
}

DistanceField::Options
fieldOptions(const PreparationSettings& settings, const ExecutionOptions& execution)
{
  DistanceField::Options options;
  options.search = settings.search_method;
  options.memory_budget = settings.memory_budget;
  options.execution = execution;
  return options;
}

bool
spacingMatters(const PreparationSettings& settings)
{
  return settings.density != DensityWeight::off && settings.density_power > 0.0f;
}

/** Whether more neighbors than the near ones are needed. */
bool
needsMore(const PreparationSettings& settings)
{
  return settings.normals > 0.0f || settings.connected;
}

bool
needsNeighbors(const PreparationSettings& settings)
{
  return spacingMatters(settings) || settings.color > 0.0f || needsMore(settings) ||
         settings.isolated_neighbors > 0;
}

WorkingPoints::Place
placeOf(const SurfacePoints& surface)
{
  if (!surface.given.empty())
    return WorkingPoints::Place::anywhere;
  return surface.filling.empty() ? WorkingPoints::Place::are_surface
                                 : WorkingPoints::Place::on_surface;
}

} // namespace

/** The order of the steps matters, since all draw from one generator: the subsample
 *  depends on the start, and the seed of soft draws on both. */
class PreparedScan::Maker {
public:
  Maker(RawScan scan, PreparedScan& made, const ExecutionOptions& execution)
  : scan_(std::move(scan))
  , made_(made)
  , settings_(made.settings_)
  , execution_(execution)
  , generator_(settings_.random_seed)
  {
  }

  void
  run()
  {
    requireUsable(scan_, settings_);
    const pcl::Indices candidates = candidatePositions(scan_.points, settings_);
    const pcl::Indices required = requiredPositions(candidates);
    const SurfacePoints surface = surfaceOf();
    made_.set_ =
        std::make_unique<WorkingSet>(std::move(scan_.points),
                                     surface,
                                     fieldOptions(settings_, execution_),
                                     static_cast<std::size_t>(settings_.subsample),
                                     required,
                                     generator_);
    made_.start_ = made_.set_->indexOf(required.front());
    takeCandidates(candidates);
    if (needsNeighbors(settings_))
      lookAtNeighbors();
    passOverIsolated();
    made_.soft_seed_ = generator_();
    makeWorkingPoints(placeOf(surface));
  }

private:
  bool
  drawsSubsample() const
  {
    return settings_.subsample > 0 &&
           static_cast<std::size_t>(settings_.subsample) < scan_.points.size();
  }

  /** Points that a subsample must hold, the start first. */
  pcl::Indices
  requiredPositions(const pcl::Indices& candidates)
  {
    start_is_drawn_ = false;
    pcl::Indices required;
    if (drawsSubsample())
      for (const pcl::index_t point : settings_.required)
        required.push_back(requirePosition(scan_.points, point, "seed"));
    if (required.empty()) {
      start_is_drawn_ = !settings_.start_index;
      required.push_back(
          startPosition(scan_.points, candidates, settings_, generator_));
    }
    return required;
  }

  /** The floor that the sensor hides is a part of the surface. */
  SurfacePoints
  surfaceOf()
  {
    SurfacePoints surface;
    surface.given = std::move(scan_.surface);
    if (!settings_.blind_spot || !scan_.sensor || !surface.given.empty())
      return surface;
    std::optional<BlindSpot> spot =
        findBlindSpot(scan_.points.points, *scan_.sensor, execution_);
    if (!spot)
      return surface;
    made_.blind_spot_ = {scan_.points.frame.toFile(spot->center.cast<double>()),
                         spot->radius,
                         spot->filling.size()};
    surface.filling = std::move(spot->filling);
    return surface;
  }

  void
  takeCandidates(const pcl::Indices& positions)
  {
    for (const pcl::index_t position : positions)
      if (const pcl::index_t drawn = made_.set_->indexOf(position); drawn >= 0)
        made_.candidates_.push_back(drawn);
    if (!positions.empty() && made_.candidates_.empty())
      made_.candidates_ = {made_.start_}; // none was drawn: only the start is left
  }

  /** Spacing, isolated points, cues and the graph, as far as the settings need them. */
  void
  lookAtNeighbors()
  {
    const Points& points = made_.set_->points();
    const NearestNeighbors neighbors(
        points,
        execution_,
        needsMore(settings_) ? NearestNeighbors::most : NearestNeighbors::most_near);
    made_.isolated_ = isolatedPoints(points, neighbors, settings_.isolated_neighbors);
    DensityDecision& density = made_.density_;
    density.isolated_points = made_.isolated_.size();
    density.spread = spacingSpread(neighbors, made_.isolated_);
    density.weighted =
        spacingMatters(settings_) &&
        (settings_.density == DensityWeight::on || density.spread >= uneven_spread);
    if (density.weighted)
      made_.costs_->spacing = localSpacing(neighbors, settings_.density_power);
    addCues(neighbors);
    if (settings_.connected)
      made_.graph_ = std::make_unique<SurfaceGraph>(points, neighbors);
  }

  void
  addCues(const NearestNeighbors& neighbors)
  {
    std::vector<Cue>& cues = made_.costs_->cues;
    if (settings_.color > 0.0f)
      cues.push_back(colorCue(*made_.set_, scan_.colors, neighbors, settings_.color));
    if (settings_.normals > 0.0f)
      cues.push_back(
          normalCue(made_.set_->points(), neighbors, settings_.normals, execution_));
  }

  /** Isolated points are no candidates, unless nothing else is left. */
  void
  passOverIsolated()
  {
    pcl::Indices& isolated = made_.isolated_;
    if (isolated.empty())
      return;
    const pcl::Indices possible =
        possibleSeeds(made_.candidates_, made_.set_->points().size());
    const pcl::Indices left = without(possible, isolated);
    if (left.empty())
      isolated = without(isolated, possible);
    else if (start_is_drawn_ &&
             std::binary_search(isolated.begin(), isolated.end(), made_.start_))
      made_.start_ = left[drawBelow(generator_, left.size())];
  }

  void
  makeWorkingPoints(WorkingPoints::Place place)
  {
    made_.points_are_surface_ = place == WorkingPoints::Place::are_surface;
    Progress progress(execution_.progress);
    made_.working_ = std::make_unique<WorkingPoints>(
        made_.set_->field(),
        made_.set_->points(),
        place,
        made_.costs_->isPlain() ? nullptr : made_.costs_.get(),
        threadCount(execution_.threads),
        progress);
  }

  RawScan scan_;
  PreparedScan& made_;
  const PreparationSettings& settings_;
  const ExecutionOptions& execution_;
  RandomGenerator generator_;
  bool start_is_drawn_ = true;
};

PreparedScan::PreparedScan(RawScan scan,
                           const PreparationSettings& settings,
                           const ExecutionOptions& execution)
: settings_(settings)
, cloud_size_(scan.cloud_size)
, costs_(std::make_unique<PairCosts>())
{
  Maker(std::move(scan), *this, execution).run();
}

PreparedScan::~PreparedScan() = default;

const PointSet&
PreparedScan::points() const
{
  return set_->all();
}

const DistanceField&
PreparedScan::field() const
{
  return set_->field();
}

bool
PreparedScan::pointsAreSurface() const
{
  return points_are_surface_ && set_->points().size() == points().size();
}

pcl::index_t
PreparedScan::workingIndex(pcl::index_t cloud_index, const char* name) const
{
  const pcl::index_t position = requirePosition(points(), cloud_index, name);
  const pcl::index_t index = set_->indexOf(position);
  if (index < 0)
    throw CIDException(sentence("the ",
                                name,
                                " is point ",
                                cloud_index,
                                ", which the subsample of ",
                                set_->points().size(),
                                " points does not hold; work on all points, or prepare "
                                "the scan with this point required"));
  return index;
}

} // namespace pcl_cid
