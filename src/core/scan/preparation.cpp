/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * From a cloud's points and the settings to the run of Algorithm 1.
 */

#include "base/requirements.h"

#include <pcl_cid/core/isolated_points.h>
#include <pcl_cid/core/preparation.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include <pcl/console/print.h>

namespace pcl_cid {
namespace {

/** Squared distances must stay far from the end of float. */
constexpr float largest_coordinate = 1e15f;

void
requireModerate(const Points& points)
{
  for (const Eigen::Vector3f& p : points)
    if (p.cwiseAbs().maxCoeff() > largest_coordinate)
      throw CIDException(sentence("a coordinate is ",
                                  p.cwiseAbs().maxCoeff(),
                                  " from the middle of the cloud; it must be within ",
                                  largest_coordinate));
}

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
candidatePositions(const PointSet& points, const CIDParameters& parameters)
{
  pcl::Indices positions;
  if (!parameters.getSeedCandidates())
    return positions;
  for (const pcl::index_t candidate : *parameters.getSeedCandidates())
    if (const pcl::index_t position = positionOf(points, candidate); position >= 0)
      positions.push_back(position);
  if (positions.empty())
    throw CIDException("none of the seed candidates is a finite, selected point of the "
                       "input; at least 1 must be");
  return positions;
}

/** "randomly pick a point p*", or the one that the user wants. */
pcl::index_t
startPosition(const PointSet& points,
              const pcl::Indices& candidates,
              const CIDParameters& parameters,
              RandomGenerator& generator)
{
  if (parameters.getStartIndex())
    return requirePosition(points, *parameters.getStartIndex(), "start index");
  if (candidates.empty())
    return static_cast<pcl::index_t>(drawBelow(generator, points.size()));
  return candidates[drawBelow(generator, candidates.size())];
}

/** Those of some indices that are not among others; both ascending. */
pcl::Indices
without(const pcl::Indices& all, const pcl::Indices& others)
{
  pcl::Indices left;
  std::set_difference(
      all.begin(), all.end(), others.begin(), others.end(), std::back_inserter(left));
  return left;
}

/** Working points that may become seeds, ascending. */
pcl::Indices
possibleSeeds(const Preparation& ready)
{
  pcl::Indices possible = ready.candidates;
  if (possible.empty()) {
    possible.resize(ready.working->points().size());
    std::iota(possible.begin(), possible.end(), 0);
  }
  std::sort(possible.begin(), possible.end());
  return possible;
}

/** Colours of the working points, in metres. */
Points
colorsInMetres(const WorkingSet& working,
               const std::vector<ColorRGB>& colors,
               const NearestNeighbors& neighbors,
               float color_weight)
{
  std::vector<ColorRGB> of_working;
  for (std::size_t i = 0; i < working.points().size(); ++i)
    of_working.push_back(colors[static_cast<std::size_t>(
        working.positionOf(static_cast<pcl::index_t>(i)))]);
  Points in_metres = smoothLab(of_working, neighbors);
  for (Eigen::Vector3f& color : in_metres)
    color *= color_weight;
  return in_metres;
}

/** The floor that the sensor hides is a part of the surface. */
void
fillBlindSpot(const CIDParameters& parameters,
              const ExecutionOptions& execution,
              RawScan& scan,
              Preparation& ready)
{
  if (!parameters.getFillBlindSpot() || !scan.sensor || !scan.surface.given.empty())
    return;
  const PointSet& points = scan.points;
  std::optional<BlindSpot> spot = findBlindSpot(points.points, *scan.sensor, execution);
  if (!spot)
    return;
  ready.blind_spot = {
      spot->centre.cast<double>() + points.origin, spot->radius, spot->filling.size()};
  scan.surface.filling = std::move(spot->filling);
}

/** Spacing, isolated points, colours: what the settings need of them. */
void
lookAtScan(const std::vector<ColorRGB>& colors,
           const RawScanSettings& settings,
           const ExecutionOptions& execution,
           Preparation& ready)
{
  const bool spacing_matters =
      settings.density_weight != DensityWeight::off && settings.density_power > 0.0f;
  const bool color_matters = settings.color_weight > 0.0f;
  if (!spacing_matters && !color_matters && settings.isolated_neighbors == 0)
    return;
  const Points& points = ready.working->points();
  const NearestNeighbors neighbors(points, execution);
  ready.isolated = isolatedPoints(points, neighbors, settings.isolated_neighbors);
  DensityDecision& density = ready.density;
  density.isolated_points = ready.isolated.size();
  density.spread = spacingSpread(neighbors, ready.isolated);
  density.weighted = spacing_matters && (settings.density_weight == DensityWeight::on ||
                                         density.spread >= uneven_spread);
  if (density.weighted)
    ready.costs.spacing = localSpacing(neighbors, settings.density_power);
  if (color_matters)
    ready.costs.color =
        colorsInMetres(*ready.working, colors, neighbors, settings.color_weight);
}

/** Isolated points are passed over, unless nothing else is left. */
void
passOverIsolated(bool start_is_drawn, RandomGenerator& generator, Preparation& ready)
{
  if (ready.isolated.empty())
    return;
  const pcl::Indices possible = possibleSeeds(ready);
  const pcl::Indices left = without(possible, ready.isolated);
  if (left.empty())
    ready.isolated = without(ready.isolated, possible);
  else if (start_is_drawn && std::binary_search(ready.isolated.begin(),
                                                ready.isolated.end(),
                                                ready.seeds.front()))
    ready.seeds.front() = left[drawBelow(generator, left.size())];
}

SeedProposalOptions
optionsOf(const Preparation& preparation,
          const CIDParameters& parameters,
          bool keep_cid,
          const ExecutionOptions& execution)
{
  SeedProposalOptions options;
  options.seeds = static_cast<std::size_t>(parameters.getNumberOfSeeds());
  options.coverage = parameters.getCoverage();
  options.samples = parameters.getNumberOfSamples();
  options.candidates = preparation.candidates;
  options.costs = preparation.pairCosts();
  options.isolated = preparation.isolated;
  options.rule = parameters.getSeedingRule();
  options.random_seed = preparation.soft_seed;
  options.keep_cid = keep_cid;
  options.execution = execution;
  return options;
}

void
warnIfShort(const SeedProposal& proposal,
            const SeedProposalOptions& options,
            const char* caller)
{
  const bool covered = proposal.coverage.back() <= options.coverage;
  if (proposal.seeds.size() < options.seeds && !(covered && options.coverage > 0.0f))
    PCL_WARN("[pcl_cid::%s] only %zu seeds instead of %zu: no other candidate "
             "is apart "
             "from them\n",
             caller,
             proposal.seeds.size(),
             options.seeds);
  if (options.coverage > 0.0f && !covered)
    PCL_WARN("[pcl_cid::%s] coverage is %g instead of %g metres after %zu seeds\n",
             caller,
             static_cast<double>(proposal.coverage.back()),
             static_cast<double>(options.coverage),
             proposal.seeds.size());
}

} // namespace

Preparation
prepare(RawScan scan,
        const pcl::Indices& given_seeds,
        const CIDParameters& parameters,
        const ExecutionOptions& execution)
{
  PointSet& points = scan.points;
  requirePoints(points.points);
  requireModerate(points.points);
  requireModerate(scan.surface.given);
  RandomGenerator generator(parameters.getRandomSeed());
  const pcl::Indices candidates = candidatePositions(points, parameters);
  pcl::Indices seeds;
  for (const pcl::index_t seed : given_seeds)
    seeds.push_back(requirePosition(points, seed, "seed"));
  if (given_seeds.empty())
    seeds.push_back(startPosition(points, candidates, parameters, generator));

  DistanceField::Options options;
  options.search = parameters.getSearchMethod();
  options.memory_budget = parameters.getMemoryBudget();
  options.execution = execution;
  Preparation ready;
  fillBlindSpot(parameters, execution, scan, ready);
  ready.working =
      std::make_unique<WorkingSet>(std::move(points),
                                   scan.surface,
                                   options,
                                   static_cast<std::size_t>(parameters.getSubsample()),
                                   seeds,
                                   generator);
  for (const pcl::index_t seed : seeds)
    ready.seeds.push_back(ready.working->indexOf(seed));
  for (const pcl::index_t candidate : candidates)
    if (const pcl::index_t drawn = ready.working->indexOf(candidate); drawn >= 0)
      ready.candidates.push_back(drawn);
  if (!candidates.empty() && ready.candidates.empty())
    ready.candidates = ready.seeds; // none was drawn: the start stands alone

  lookAtScan(scan.colors, parameters.getRawScanSettings(), execution, ready);
  passOverIsolated(
      given_seeds.empty() && !parameters.getStartIndex(), generator, ready);
  ready.soft_seed = generator();
  return ready;
}

SeedProposal
propose(const Preparation& preparation,
        const CIDParameters& parameters,
        bool keep_cid,
        const ExecutionOptions& execution,
        const char* caller)
{
  const WorkingSet& working = *preparation.working;
  const SeedProposalOptions options =
      optionsOf(preparation, parameters, keep_cid, execution);
  SeedProposal proposal = proposeSeeds(
      working.field(), working.points(), preparation.seeds.front(), options);
  warnIfShort(proposal, options, caller);
  return proposal;
}

SeedProposal
group(const Preparation& preparation,
      const CIDParameters& parameters,
      bool keep_cid,
      const ExecutionOptions& execution)
{
  const WorkingSet& working = *preparation.working;
  return groupBySeeds(working.field(),
                      working.points(),
                      preparation.seeds,
                      optionsOf(preparation, parameters, keep_cid, execution));
}

void
extend(const Preparation& preparation,
       const CIDParameters& parameters,
       const ExecutionOptions& execution,
       const char* caller,
       SeedProposal& proposal)
{
  const WorkingSet& working = *preparation.working;
  const SeedProposalOptions options =
      optionsOf(preparation, parameters, true, execution);
  extendProposal(working.field(), working.points(), options, proposal);
  warnIfShort(proposal, options, caller);
}

} // namespace pcl_cid
