/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Weakly convex components of an oriented surface (WCSeg-like).
 */

#include "weak_convexity.h"

#include "line_of_sight.h"
#include "shape_diameter.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace pcl_cid::benchmarks {
namespace {

/** Patches and the components that they are joined to. */
class Components {
public:
  /** \param[in] patch number of the patch of each point */
  Components(std::vector<int> patch, Eigen::MatrixXf visible)
  : patch_(std::move(patch)), visible_(std::move(visible))
  {
    points_.resize(static_cast<std::size_t>(visible_.rows()));
    for (const int p : patch_)
      points_[static_cast<std::size_t>(p)] += 1.0;
    component_.resize(points_.size());
    std::iota(component_.begin(), component_.end(), 0);
    patches_.resize(points_.size());
    for (std::size_t k = 0; k < patches_.size(); ++k)
      patches_[k] = {static_cast<int>(k)};
  }

  /** The component of a patch; it goes by its lowest patch. */
  int
  of(int patch) const
  {
    return component_[static_cast<std::size_t>(patch)];
  }

  int
  ofPoint(std::size_t point) const
  {
    return of(patch_[point]);
  }

  int
  patchOfPoint(std::size_t point) const
  {
    return patch_[point];
  }

  std::size_t
  size() const
  {
    return patches_.size();
  }

  float
  visibleBetweenPatches(int first, int second) const
  {
    return visible_(first, second);
  }

  /** Share of the lines between two components that are free. */
  double
  visibleBetween(int first, int second) const
  {
    double all = 0.0;
    double free = 0.0;
    for (const int a : patches_[static_cast<std::size_t>(first)])
      for (const int b : patches_[static_cast<std::size_t>(second)]) {
        const double lines =
            points_[static_cast<std::size_t>(a)] * points_[static_cast<std::size_t>(b)];
        all += lines;
        free += lines * static_cast<double>(visible_(a, b));
      }
    return free / all;
  }

  void
  join(int first, int second)
  {
    if (first == second)
      return;
    const auto [low, high] = std::minmax(first, second);
    std::vector<int>& from = patches_[static_cast<std::size_t>(high)];
    std::vector<int>& to = patches_[static_cast<std::size_t>(low)];
    for (const int patch : from)
      component_[static_cast<std::size_t>(patch)] = low;
    to.insert(to.end(), from.begin(), from.end());
    from.clear();
  }

private:
  std::vector<int> patch_;
  Eigen::MatrixXf visible_;
  std::vector<double> points_; ///< of each patch
  std::vector<int> component_; ///< of each patch
  std::vector<std::vector<int>> patches_;
};

/** Stage 3. */
void
growComponents(const Graph& graph,
               const WeakConvexityOptions& options,
               Components& components)
{
  std::set<std::pair<int, int>> neighbors;
  for (std::size_t i = 0; i < graph.size(); ++i)
    for (const Edge& edge : graph[i]) {
      const int a = components.patchOfPoint(i);
      const int b = components.patchOfPoint(static_cast<std::size_t>(edge.to));
      if (a < b)
        neighbors.emplace(a, b);
    }
  std::vector<std::pair<int, int>> order(neighbors.begin(), neighbors.end());
  std::stable_sort(order.begin(), order.end(), [&](const auto& x, const auto& y) {
    return components.visibleBetweenPatches(x.first, x.second) >
           components.visibleBetweenPatches(y.first, y.second);
  });
  // Half a step more: sums of steps are rounded.
  const double end = options.last_visibility - 0.5 * options.visibility_step;
  for (double wanted = options.first_visibility; wanted > end;
       wanted -= options.visibility_step)
    for (const auto& [a, b] : order)
      if (const int first = components.of(a), second = components.of(b);
          first != second && components.visibleBetween(first, second) >= wanted)
        components.join(first, second);
}

/** What two neighboring components have in common: edges of the graph. */
struct Seam {
  int first;
  int second;
  std::size_t convex = 0;
  std::size_t concave = 0;
};

std::vector<Seam>
findSeams(const OrientedPoints& surface,
          const Graph& graph,
          const Components& components)
{
  std::map<std::pair<int, int>, Seam> seams;
  for (std::size_t i = 0; i < graph.size(); ++i)
    for (const Edge& edge : graph[i]) {
      const auto j = static_cast<std::size_t>(edge.to);
      const int a = components.ofPoint(i);
      const int b = components.ofPoint(j);
      if (a >= b) // each edge stands there twice
        continue;
      Seam& seam = seams.try_emplace({a, b}, Seam{a, b}).first->second;
      const Bend bend = bendBetween(surface, i, j);
      seam.convex += bend == Bend::convex ? 1 : 0;
      seam.concave += bend == Bend::concave ? 1 : 0;
    }
  std::vector<Seam> list;
  for (const auto& [pair, seam] : seams)
    list.push_back(seam);
  return list;
}

/** Shape diameters of each component; none for flat ones, and for numbers that no
 *  component goes by. */
class Thickness {
public:
  explicit Thickness(const OrientedPoints& surface) : surface_(surface) {}

  /** Measure the components that have grown since the last time. */
  void
  update(const Components& components)
  {
    std::vector<std::vector<std::size_t>> members(components.size());
    for (std::size_t i = 0; i < surface_.size(); ++i)
      members[static_cast<std::size_t>(components.ofPoint(i))].push_back(i);
    measured_.resize(components.size(), 0);
    diameters_.resize(components.size());
    for (std::size_t k = 0; k < members.size(); ++k)
      if (members[k].size() != measured_[k]) {
        measured_[k] = members[k].size();
        diameters_[k] = members[k].empty() ? std::vector<double>()
                                           : shapeDiameters(surface_, members[k]);
      }
  }

  bool
  isFlat(int component) const
  {
    return diameters_[static_cast<std::size_t>(component)].empty();
  }

  const std::vector<std::vector<double>>&
  diameters() const
  {
    return diameters_;
  }

private:
  const OrientedPoints& surface_;
  std::vector<std::size_t> measured_; ///< points of each component at that time
  std::vector<std::vector<double>> diameters_;
};

/** The seam to the neighbor that a flat component should join; null when there is
 *  none. First those without a concave edge, the one with most convex edges; else the
 *  one with the most convex edges for each concave one, if enough lines are free. */
const Seam*
bestSeam(int flat,
         const std::vector<Seam>& seams,
         const WeakConvexityOptions& options,
         const Components& components)
{
  const Seam* purely_convex = nullptr;
  const Seam* mostly_convex = nullptr;
  const auto ratio = [](const Seam& seam) {
    return static_cast<double>(seam.convex) / static_cast<double>(seam.concave);
  };
  for (const Seam& seam : seams) {
    // Joined to others in this round, perhaps; each is found by its lowest patch.
    const int first = components.of(seam.first);
    const int second = components.of(seam.second);
    if ((seam.first != flat && seam.second != flat) || seam.convex == 0 ||
        first == second)
      continue;
    if (seam.concave == 0) {
      if (purely_convex == nullptr || seam.convex > purely_convex->convex)
        purely_convex = &seam;
    }
    else if (ratio(seam) >= 1.0 &&
             (mostly_convex == nullptr || ratio(seam) > ratio(*mostly_convex)) &&
             components.visibleBetween(first, second) >= options.flat_visibility)
      mostly_convex = &seam;
  }
  return purely_convex != nullptr ? purely_convex : mostly_convex;
}

/** Stage 4, until nothing changes. Each round joins at least two components. */
void
mergeByThickness(const OrientedPoints& surface,
                 const Graph& graph,
                 const WeakConvexityOptions& options,
                 Components& components)
{
  Thickness thickness(surface);
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    const std::vector<Seam> seams = findSeams(surface, graph, components);
    thickness.update(components);
    const Eigen::MatrixXd unlike = histogramDistances(thickness.diameters());
    const double most_unlike = options.unlike_share * unlike.maxCoeff();
    const auto join = [&](const Seam& seam) {
      const int first = components.of(seam.first);
      const int second = components.of(seam.second);
      has_changed = has_changed || first != second;
      components.join(first, second);
    };
    for (const Seam& seam : seams)
      if (!thickness.isFlat(seam.first) && !thickness.isFlat(seam.second) &&
          static_cast<double>(seam.concave) <
              options.concave_share * static_cast<double>(seam.convex) &&
          unlike(seam.first, seam.second) <= most_unlike)
        join(seam);
    std::set<int> flats;
    for (const Seam& seam : seams)
      for (const int end : {seam.first, seam.second})
        if (thickness.isFlat(end))
          flats.insert(end);
    for (const int flat : flats)
      if (const Seam* seam = bestSeam(flat, seams, options, components))
        join(*seam);
  }
}

/** From 0 without gaps; -1 for components of too few points. */
std::vector<int>
numberSegments(const Components& components, std::size_t points, std::size_t least)
{
  std::vector<std::size_t> count(components.size(), 0);
  for (std::size_t i = 0; i < points; ++i)
    ++count[static_cast<std::size_t>(components.ofPoint(i))];
  std::vector<int> number(components.size(), -1);
  int next = 0;
  for (std::size_t k = 0; k < number.size(); ++k)
    if (count[k] >= least)
      number[k] = next++;
  std::vector<int> segment(points);
  for (std::size_t i = 0; i < points; ++i)
    segment[i] = number[static_cast<std::size_t>(components.ofPoint(i))];
  return segment;
}

} // namespace

std::vector<int>
findWeaklyConvexSegments(const OrientedPoints& surface,
                         const DistanceField& field,
                         const std::vector<std::vector<int>>& neighbors,
                         const WeakConvexityOptions& options)
{
  const Graph graph = weighByBend(surface, neighbors);
  const LineOfSight sight(surface,
                          field,
                          static_cast<float>(options.coplanar),
                          static_cast<float>(options.reach));
  std::vector<int> patch = cutIntoPatches(graph, options.patches);
  const Eigen::MatrixXf visible =
      mutualVisibility(sight, patch, cutIntoPatches(graph, 1), options.sight_samples);
  Components components(std::move(patch), visible);
  growComponents(graph, options, components);
  if (options.merge_by_thickness)
    mergeByThickness(surface, graph, options, components);
  return numberSegments(components, surface.size(), options.least_points);
}

} // namespace pcl_cid::benchmarks
