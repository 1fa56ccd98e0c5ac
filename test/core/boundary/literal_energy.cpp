/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The energy of labels near boundaries, word for word, in double precision.
 */

#include "literal_energy.h"

#include "cid/working_points.h"
#include "oracle.h"
#include "prepared_points.h"
#include "scan/surface_normals.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace pcl_cid::test {
namespace {

/** The bits that decide which distance is the smaller one. */
float
squareOf(const Eigen::Vector3f& p, const Eigen::Vector3f& q)
{
  const Eigen::Vector3f d = p - q;
  return (d.x() * d.x() + d.y() * d.y()) + d.z() * d.z();
}

/** The first points of the eight places that are nearest to each point. */
std::vector<std::set<std::size_t>>
eightNearest(const Points& points)
{
  std::vector<std::set<std::size_t>> nearest;
  for (const Eigen::Vector3f& p : points) {
    std::vector<std::pair<float, std::size_t>> order;
    for (std::size_t k = 0; k < points.size(); ++k)
      if (points[k] != p &&
          std::find(points.begin(), points.end(), points[k]) - points.begin() ==
              static_cast<std::ptrdiff_t>(k))
        order.emplace_back(squareOf(p, points[k]), k);
    std::sort(order.begin(), order.end());
    order.resize(std::min<std::size_t>(order.size(), 8));
    nearest.emplace_back();
    for (const auto& [distance, k] : order)
      nearest.back().insert(k);
  }
  return nearest;
}

/** The lower median of the distances to the last of the nearest. */
float
medianSpacing(const Points& points, const std::vector<std::set<std::size_t>>& nearest)
{
  std::vector<float> spacings;
  for (std::size_t i = 0; i < points.size(); ++i) {
    float spacing = 0.0f;
    for (const std::size_t k : nearest[i])
      spacing = std::max(spacing, (points[i] - points[k]).norm());
    spacings.push_back(spacing);
  }
  std::sort(spacings.begin(), spacings.end());
  return spacings[(spacings.size() - 1) / 2];
}

} // namespace

LiteralEnergy::LiteralEnergy(const Grouping& grouping,
                             const Labels& label_of_seed,
                             const Labels& propagated,
                             const CleaningSettings& settings)
{
  const Points& points = grouping.scan().points().points;
  const PairCosts* costs = grouping.scan().working().costs().ofPairs();
  const Oracle oracle(points, grouping.settings().samples);
  const std::vector<std::set<std::size_t>> nearest = eightNearest(points);
  const float reach = settings.reach * medianSpacing(points, nearest);
  const pcl::Indices seeds = grouping.seeds();
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::set<std::uint32_t> near = {propagated[i]};
    const bool is_seed =
        std::count(seeds.begin(), seeds.end(), static_cast<pcl::index_t>(i)) > 0;
    for (std::size_t k = 0; k < points.size() && !is_seed && propagated[i] != 0; ++k)
      if (propagated[k] != 0 && squareOf(points[i], points[k]) <= reach * reach)
        near.insert(propagated[k]);
    options_.emplace_back(near.begin(), near.end());

    std::map<std::uint32_t, double> smallest;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < seeds.size(); ++s) {
      const double cost =
          oracle.pointCost(points, static_cast<std::size_t>(seeds[s]), i, costs);
      const auto known = smallest.emplace(label_of_seed[s], cost).first;
      known->second = std::min(known->second, cost);
      best = std::min(best, cost);
    }
    losses_.emplace_back();
    for (const std::uint32_t label : options_.back())
      losses_.back().push_back(
          std::min(double{settings.most_loss}, smallest[label] - best));
  }

  const std::vector<Eigen::Vector3f> normals =
      surfaceNormals(points,
                     NearestNeighbors(points, onThreads(1), NearestNeighbors::most),
                     onThreads(1));
  for (std::size_t p = 0; p < points.size(); ++p)
    for (std::size_t q = p + 1; q < points.size(); ++q) {
      if (!nearest[p].count(q) && !nearest[q].count(p))
        continue;
      if (options_[p].size() == 1 && options_[q].size() == 1)
        continue; // always the same
      double exponent = 0.0;
      if (!normals[p].isZero(0.0f) && !normals[q].isZero(0.0f))
        exponent +=
            (1.0 - std::abs(normals[p].cast<double>().dot(normals[q].cast<double>()))) /
            double{settings.normal_scale};
      if (costs && !costs->cues.empty()) // color is the only one here
        exponent += (costs->cues[0].values[p] - costs->cues[0].values[q])
                        .cast<double>()
                        .norm() /
                    double{grouping.scan().settings().color} /
                    double{settings.color_scale};
      links_.push_back({p, q, double{settings.pull} * std::exp(-exponent)});
    }
  const double scale = costs && !costs->spacing.empty() ? 5.0 : 1.0; // least_spacing
  tolerance_of_cost_ = scale * agreementTolerance(points);
}

std::size_t
LiteralEnergy::freePoints() const
{
  return static_cast<std::size_t>(std::count_if(
      options_.begin(), options_.end(), [](const Labels& o) { return o.size() > 1; }));
}

double
LiteralEnergy::of(const Labels& labels) const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (options_[i].size() > 1)
      sum += losses_[i][static_cast<std::size_t>(
          std::find(options_[i].begin(), options_[i].end(), labels[i]) -
          options_[i].begin())];
  for (const Link& link : links_)
    if (labels[link.p] != labels[link.q])
      sum += link.pull;
  return sum;
}

double
LiteralEnergy::tolerance() const
{
  const double unit = 0x1p-20;
  return static_cast<double>(freePoints()) * (unit + 2.0 * tolerance_of_cost_) +
         static_cast<double>(links_.size()) * (unit + 1e-6);
}

double
leastEnergy(const LiteralEnergy& energy, const std::vector<Labels>& options)
{
  double least = std::numeric_limits<double>::infinity();
  Labels labels(options.size());
  const std::function<void(std::size_t)> visit = [&](std::size_t point) {
    if (point == options.size()) {
      least = std::min(least, energy.of(labels));
      return;
    }
    for (const std::uint32_t label : options[point]) {
      labels[point] = label;
      visit(point + 1);
    }
  };
  visit(0);
  return least;
}

} // namespace pcl_cid::test
