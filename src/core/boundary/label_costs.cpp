/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What its labels cost a point near a boundary.
 */

#include "label_costs.h"

#include "cid/cost_search.h"
#include "cid/working_points.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl_cid {
namespace {

/** Points that a thread takes at a time. */
constexpr std::size_t points_at_a_time = 64;

/** Seeds as indices among the points that are worked on. */
std::vector<std::size_t>
workingSeeds(const Grouping& grouping)
{
  std::vector<std::size_t> seeds;
  for (const pcl::index_t seed : grouping.seeds())
    seeds.push_back(
        static_cast<std::size_t>(grouping.scan().workingIndex(seed, "seed")));
  return seeds;
}

using SeedsByLabel = std::map<std::uint32_t, std::vector<std::size_t>>;

SeedsByLabel
seedsByLabel(const std::vector<std::uint32_t>& label_of_seed)
{
  SeedsByLabel by_label;
  for (std::size_t k = 0; k < label_of_seed.size(); ++k)
    by_label[label_of_seed[k]].push_back(k);
  return by_label;
}

/** Costs of points and seeds; it serves one thread. What it has found for one point is
 *  a good guess for the next: the sample that decides, and which seed of a label is the
 *  nearest. No guess changes a result. */
class SeedCosts {
public:
  SeedCosts(const WorkingPoints& points,
            const std::vector<std::size_t>& seeds,
            const SeedsByLabel& by_label,
            const SampleOrder& order)
  : points_(points)
  , seeds_(seeds)
  , by_label_(by_label)
  , search_(points.field(), order)
  , hints_(seeds.size(), order.last() / 2)
  {
  }

  /** The cost if it is below a limit, else at least that. */
  float
  between(std::size_t seed, std::size_t point, float limit)
  {
    const std::size_t q = seeds_[seed];
    const Segment segment{
        points_.points()[q], points_.points()[point], points_.areOnSurface()};
    return searchCost(
        search_, segment, points_.costs().between(q, point), limit, hints_[seed]);
  }

  /** The smallest cost of the seeds of a label if it is below a limit, else the limit.
   */
  float
  smallest(std::uint32_t label, std::size_t point, float limit)
  {
    std::vector<std::size_t>& seeds = by_label_.at(label);
    for (std::size_t k = 0; k < seeds.size(); ++k) {
      const float cost = between(seeds[k], point, limit);
      if (cost < limit) {
        limit = cost;
        std::swap(seeds[0], seeds[k]);
      }
    }
    return limit;
  }

private:
  const WorkingPoints& points_;
  const std::vector<std::size_t>& seeds_;
  SeedsByLabel by_label_; ///< in each, the nearest to the last point comes first
  SegmentSearch search_;
  std::vector<std::size_t> hints_;
};

} // namespace

std::vector<std::vector<LabelEnergy::Choice>>
labelCosts(const Grouping& grouping,
           const std::vector<std::uint32_t>& label_of_seed,
           const std::vector<pcl::index_t>& group,
           const std::vector<BoundaryPoint>& boundary,
           float most_loss,
           int threads,
           Progress& progress,
           ProgressSpan span)
{
  const std::vector<std::size_t> seeds = workingSeeds(grouping);
  const SeedsByLabel by_label = seedsByLabel(label_of_seed);
  const SampleOrder order(grouping.settings().samples);
  std::vector<std::vector<LabelEnergy::Choice>> choices(boundary.size());
  const auto compare = [&](std::size_t begin, std::size_t end) {
    SeedCosts costs(grouping.scan().working(), seeds, by_label, order);
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t point = boundary[i].point;
      const auto own = static_cast<std::size_t>(group[point]);
      const float best = costs.between(own, point, infinity);
      // The next float up: what is not below it is more than the most by which a label
      // may lose, however the sum was rounded.
      const float limit = std::nextafter(best + most_loss, infinity);
      for (const std::uint32_t label : boundary[i].labels) {
        const float cost =
            label == label_of_seed[own] ? best : costs.smallest(label, point, limit);
        const double loss = static_cast<double>(cost) - static_cast<double>(best);
        choices[i].push_back(
            {label, wholeUnits(std::min(loss, static_cast<double>(most_loss)))});
      }
    }
  };
  parallelFor(boundary.size(), points_at_a_time, threads, progress, span, compare);
  return choices;
}

} // namespace pcl_cid
