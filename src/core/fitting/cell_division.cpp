/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Cells, divided in two by the plane that leaves the smallest hulls.
 */

#include "base/sentence.h"
#include "cell.h"

#include <pcl_cid/exceptions.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

namespace pcl_cid {
namespace {

/** Cells that are divided at once, on several threads. */
constexpr std::size_t divided_at_once = 16;

/** Points of a cell that planes are tried on: one in 50, but for small and large cells.
 */
constexpr std::size_t fewest_tried = 128;
constexpr std::size_t most_tried = 1024;

/** The bound on the error is out of reach beyond this. */
constexpr std::size_t most_cells_for_bound = 20000;

/** Points below normal . x = offset go to one side. */
struct CuttingPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double offset = 0.0;
  double volume =
      std::numeric_limits<double>::infinity(); ///< of the hulls of both sides
  double unevenness = 0.0; ///< points that one side has more than the other
};

std::vector<Eigen::Vector3d>
evenlyChosen(const pcl::Indices& members, const Points& points)
{
  const std::size_t count = std::min(
      members.size(), std::clamp(members.size() / 50, fewest_tried, most_tried));
  std::vector<Eigen::Vector3d> chosen;
  for (std::size_t k = 0; k < count; ++k)
    chosen.push_back(
        points[static_cast<std::size_t>(members[k * members.size() / count])]
            .cast<double>());
  return chosen;
}

/** The axes of the scan, and the principal ones of the points. */
std::array<Eigen::Vector3d, 6>
directionsToCut(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points)
    mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points)
    covariance += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(covariance);
  std::array<Eigen::Vector3d, 6> directions;
  for (int axis = 0; axis < 3; ++axis) {
    directions[static_cast<std::size_t>(axis)] = Eigen::Vector3d::Unit(axis);
    directions[static_cast<std::size_t>(3 + axis)] = principal.eigenvectors().col(axis);
  }
  return directions;
}

/** Just inside of either end, where a floor or a wall may be peeled off, and between.
 */
std::array<double, 7>
offsetsToCut(double low, double high, double thin)
{
  const double length = high - low;
  return {low + thin / 3.0,
          low + thin,
          low + 0.25 * length,
          low + 0.5 * length,
          low + 0.75 * length,
          high - thin,
          high - thin / 3.0};
}

/** Try one plane. */
void
tryPlane(const std::vector<Eigen::Vector3d>& points,
         const std::vector<double>& heights,
         const Eigen::Vector3d& normal,
         double offset,
         CuttingPlane& best)
{
  std::array<std::vector<Eigen::Vector3d>, 2> sides;
  for (std::size_t i = 0; i < points.size(); ++i)
    sides[heights[i] < offset ? 0 : 1].push_back(points[i]);
  if (sides[0].empty() || sides[1].empty())
    return;
  const double volume = hullVolume(sides[0]) + hullVolume(sides[1]);
  const auto unevenness =
      static_cast<double>(std::max(sides[0].size(), sides[1].size()) -
                          std::min(sides[0].size(), sides[1].size()));
  if (std::tie(volume, unevenness) < std::tie(best.volume, best.unevenness))
    best = {normal, offset, volume, unevenness};
}

/** The plane that leaves the smallest hulls on its two sides; of equals, such as those
 *  across a flat wall, the one in the middle. */
CuttingPlane
bestPlane(const std::vector<Eigen::Vector3d>& points, double thin)
{
  CuttingPlane best;
  for (const Eigen::Vector3d& normal : directionsToCut(points)) {
    std::vector<double> heights;
    for (const Eigen::Vector3d& p : points)
      heights.push_back(normal.dot(p));
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    for (const double offset : offsetsToCut(*low, *high, thin))
      if (offset > *low && offset < *high)
        tryPlane(points, heights, normal, offset, best);
  }
  return best;
}

/** Two cells in the place of one; none when its points are all in one place. */
std::vector<Cell>
halvesOf(const Cell& cell, const FittingScene& scene)
{
  const std::vector<Eigen::Vector3d> chosen = evenlyChosen(cell.points, scene.points);
  const CuttingPlane plane = bestPlane(chosen, 0.2 * scene.robot_radius);
  std::array<pcl::Indices, 2> sides;
  for (const pcl::index_t i : cell.points) {
    const auto p = scene.points[static_cast<std::size_t>(i)].cast<double>();
    sides[plane.normal.dot(p) < plane.offset ? 0 : 1].push_back(i);
  }
  std::vector<Cell> halves;
  if (!sides[0].empty() && !sides[1].empty())
    for (pcl::Indices& side : sides)
      halves.push_back(makeCell(std::move(side), scene));
  return halves;
}

std::size_t
placesNearCell(const Cell& cell)
{
  std::size_t count = 0;
  for (const PlaceRange& range : cell.near)
    count += range.end - range.begin;
  return count;
}

/** A cell that may be divided. */
struct Divisible {
  bool breaks_bound;
  std::size_t places;
  std::size_t number;

  /** Comes later. */
  bool
  operator<(const Divisible& other) const
  {
    return std::tie(breaks_bound, places, other.number) <
           std::tie(other.breaks_bound, other.places, number);
  }
};

/** Divides the cells that take most places first. */
class Division {
public:
  Division(std::vector<Cell> cells, const FittingScene& scene, Progress& progress)
  : cells_(std::move(cells)), scene_(scene), progress_(progress)
  {
    std::vector<std::size_t> all(cells_.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = i;
    enqueue(all);
  }

  std::vector<Cell>
  run(std::size_t most)
  {
    for (;;) {
      const std::vector<std::size_t> chosen = choose(most);
      if (chosen.empty())
        return std::move(cells_);
      divide(chosen);
    }
  }

private:
  void
  enqueue(const std::vector<std::size_t>& numbers)
  {
    std::vector<unsigned char> breaks_bound(numbers.size());
    forEach(numbers.size(), [&](std::size_t i) {
      breaks_bound[i] = !scene_.keepsBound(cells_[numbers[i]].hull);
    });
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const Cell& cell = cells_[numbers[i]];
      const std::size_t places = placesNearCell(cell);
      // What is near a cell that is smaller than a robot is near its points.
      const bool frees_places =
          places > 0 && diagonalOf(cell.hull) > (2.0 / 3.0) * scene_.robot_radius;
      if (cell.points.size() > 1 && (frees_places || breaks_bound[i] != 0))
        queue_.push({breaks_bound[i] != 0, places, numbers[i]});
    }
  }

  /** The next ones to divide. */
  std::vector<std::size_t>
  choose(std::size_t most)
  {
    std::vector<std::size_t> chosen;
    while (!queue_.empty() && chosen.size() < divided_at_once) {
      const Divisible next = queue_.top();
      if (!next.breaks_bound && cells_.size() + chosen.size() >= most)
        break;
      if (cells_.size() + chosen.size() >= most_cells_for_bound)
        throw CIDException(sentence("the bound of ",
                                    scene_.max_error,
                                    " m on the error needs more than ",
                                    most_cells_for_bound,
                                    " hulls; choose a larger one"));
      queue_.pop();
      chosen.push_back(next.number);
    }
    return chosen;
  }

  void
  divide(const std::vector<std::size_t>& chosen)
  {
    std::vector<std::vector<Cell>> halves(chosen.size());
    forEach(chosen.size(),
            [&](std::size_t i) { halves[i] = halvesOf(cells_[chosen[i]], scene_); });
    std::vector<std::size_t> made;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      if (halves[i].empty())
        continue;
      cells_[chosen[i]] = std::move(halves[i][0]);
      made.push_back(chosen[i]);
      made.push_back(cells_.size());
      cells_.push_back(std::move(halves[i][1]));
    }
    enqueue(made);
  }

  template <typename Work>
  void
  forEach(std::size_t count, const Work& work)
  {
    parallelForEach(count, scene_.threads, progress_, {}, work);
  }

  std::vector<Cell> cells_;
  const FittingScene& scene_;
  Progress& progress_;
  std::priority_queue<Divisible> queue_;
};

} // namespace

std::vector<Cell>
divideCells(std::vector<Cell> cells,
            std::size_t most,
            const FittingScene& scene,
            Progress& progress)
{
  return Division(std::move(cells), scene, progress).run(most);
}

} // namespace pcl_cid
