/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What neighbors near a boundary pay for different labels.
 */

#include "neighbor_links.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_cid {
namespace {

constexpr std::size_t no_site = static_cast<std::size_t>(-1);

/** The cue that is a difference of colors; null where there is none. */
const Cue*
colorsOf(const PairCosts& costs)
{
  for (const Cue& cue : costs.cues)
    if (cue.property == Cue::Property::color)
      return &cue;
  return nullptr;
}

/** The site of each point. */
std::vector<std::size_t>
sitesOf(const std::vector<BoundaryPoint>& boundary, std::size_t points)
{
  std::vector<std::size_t> sites(points, no_site);
  for (std::size_t i = 0; i < boundary.size(); ++i)
    sites[boundary[i].point] = i;
  return sites;
}

bool
isNeighborOf(const NearestNeighbors& neighbors, std::size_t p, std::size_t q)
{
  for (std::size_t k = 0; k < neighbors.nearCount(); ++k)
    if (static_cast<std::size_t>(neighbors.neighbor(q, k)) == p)
      return true;
  return false;
}

/** Visit each pair of neighbors once. */
template <typename Visit>
void
visitNeighbors(const NearestNeighbors& neighbors,
               const std::vector<std::size_t>& sites,
               const Visit& visit)
{
  for (std::size_t p = 0; p < neighbors.size(); ++p)
    for (std::size_t k = 0; k < neighbors.nearCount(); ++k) {
      const auto q = static_cast<std::size_t>(neighbors.neighbor(p, k));
      if (sites[p] == no_site && sites[q] == no_site)
        continue;
      if (p < q || !isNeighborOf(neighbors, p, q))
        visit(p, q);
    }
}

/** A neighbor whose label stays: all other labels cost more. */
void
pin(std::vector<LabelEnergy::Choice>& choices, std::uint32_t label, std::int64_t cost)
{
  for (LabelEnergy::Choice& choice : choices)
    if (choice.label != label)
      choice.cost += cost;
}

} // namespace

NeighborPull::NeighborPull(const CleaningSettings& settings,
                           const std::vector<Eigen::Vector3f>& normals,
                           const PairCosts* costs,
                           float color_weight)
: settings_(settings)
, normals_(normals)
, colors_(costs ? colorsOf(*costs) : nullptr)
, color_weight_(color_weight)
{
}

double
NeighborPull::difference(std::size_t p, std::size_t q) const
{
  double sum = 0.0;
  const Eigen::Vector3d n = normals_[p].cast<double>();
  const Eigen::Vector3d m = normals_[q].cast<double>();
  if (!n.isZero(0.0) && !m.isZero(0.0))
    sum += std::max(1.0 - std::abs(n.dot(m)), 0.0) / double{settings_.normal_scale};
  if (colors_) {
    const double lab = double{colors_->between(p, q)} / color_weight_;
    sum += lab / double{settings_.color_scale};
  }
  return sum;
}

double
NeighborPull::between(std::size_t p, std::size_t q) const
{
  return double{settings_.pull} * std::exp(-difference(p, q));
}

std::vector<bool>
linkedPoints(const std::vector<BoundaryPoint>& boundary,
             const NearestNeighbors& neighbors)
{
  std::vector<bool> linked(neighbors.size(), false);
  visitNeighbors(neighbors,
                 sitesOf(boundary, neighbors.size()),
                 [&](std::size_t p, std::size_t q) {
                   linked[p] = true;
                   linked[q] = true;
                 });
  return linked;
}

void
linkNeighbors(const std::vector<BoundaryPoint>& boundary,
              const std::vector<std::uint32_t>& labels,
              const NearestNeighbors& neighbors,
              const NeighborPull& pull,
              LabelEnergy& energy)
{
  const std::vector<std::size_t> sites = sitesOf(boundary, labels.size());
  visitNeighbors(neighbors, sites, [&](std::size_t p, std::size_t q) {
    const std::int64_t half = wholeUnits(0.5 * pull.between(p, q));
    if (half == 0)
      return;
    const auto [first, second] = std::minmax(sites[p], sites[q]);
    if (second != no_site)
      energy.links.push_back({first, second, half});
    else
      pin(energy.choices[first], labels[sites[p] == no_site ? p : q], 2 * half);
  });
}

} // namespace pcl_cid
