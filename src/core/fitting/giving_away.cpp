/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points inside of several hulls, given to one of them.
 */

#include "cell.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl_cid {
namespace {

constexpr std::size_t nobody = static_cast<std::size_t>(-1);

/** Hulls that shrink in turn, the smallest first. */
class GivingAway {
public:
  GivingAway(std::vector<Cell> cells, const FittingScene& scene, Progress& progress)
  : cells_(std::move(cells)), scene_(scene), progress_(progress)
  {
    for (const Cell& cell : cells_)
      boxes_.push_back(boxOf(cell.hull));
  }

  std::vector<Cell>
  run()
  {
    std::vector<std::size_t> order(cells_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return cells_[a].hull.volume < cells_[b].hull.volume;
    });
    for (const std::size_t giver : order)
      give(giver);
    renew();
    return std::move(cells_);
  }

private:
  std::vector<std::size_t>
  overlapping(std::size_t giver) const
  {
    std::vector<std::size_t> others;
    for (std::size_t other = 0; other < cells_.size(); ++other)
      if (other != giver && boxes_[other].intersects(boxes_[giver]))
        others.push_back(other);
    return others;
  }

  /** For each point of a cell, the first other cell that it is well inside of. */
  std::vector<std::size_t>
  takersOf(std::size_t giver)
  {
    constexpr std::size_t points_at_once = 1024;
    const std::vector<std::size_t> others = overlapping(giver);
    const pcl::Indices& points = cells_[giver].points;
    std::vector<std::size_t> takers(points.size(), nobody);
    if (others.empty())
      return takers;
    parallelFor(points.size(),
                points_at_once,
                scene_.threads,
                progress_,
                {},
                [&](std::size_t begin, std::size_t end) {
                  for (std::size_t i = begin; i < end; ++i)
                    takers[i] = takerOf(points[i], others);
                });
    return takers;
  }

  std::size_t
  takerOf(pcl::index_t point, const std::vector<std::size_t>& others) const
  {
    const Eigen::Vector3d p =
        scene_.points[static_cast<std::size_t>(point)].cast<double>();
    for (const std::size_t other : others)
      if (boxes_[other].contains(p) &&
          isInside(cells_[other].hull.faces, p, -0.2 * scene_.thickness))
        return other;
    return nobody;
  }

  /** Give what others hold, if that makes the hull smaller; one point stays. */
  void
  give(std::size_t giver)
  {
    std::vector<std::size_t> takers = takersOf(giver);
    if (std::find(takers.begin(), takers.end(), nobody) == takers.end())
      takers.front() = nobody;
    const pcl::Indices points = cells_[giver].points;
    pcl::Indices kept;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (takers[i] == nobody)
        kept.push_back(points[i]);
    if (kept.size() == points.size())
      return;
    Cell smaller = makeCell(std::move(kept), scene_);
    if (!(smaller.hull.volume < cells_[giver].hull.volume))
      return;
    cells_[giver] = std::move(smaller);
    boxes_[giver] = boxOf(cells_[giver].hull);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (takers[i] != nobody)
        cells_[takers[i]].points.push_back(points[i]);
  }

  /** The hulls of what cells hold now: a point inside of a hull is thick, too, and may
   *  reach beyond it by that. */
  void
  renew()
  {
    parallelForEach(cells_.size(), scene_.threads, progress_, {}, [&](std::size_t i) {
      std::sort(cells_[i].points.begin(), cells_[i].points.end());
      cells_[i] = makeCell(std::move(cells_[i].points), scene_);
    });
  }

  std::vector<Cell> cells_;
  const FittingScene& scene_;
  Progress& progress_;
  std::vector<Eigen::AlignedBox3d> boxes_;
};

} // namespace

std::vector<Cell>
giveAway(std::vector<Cell> cells, const FittingScene& scene, Progress& progress)
{
  return GivingAway(std::move(cells), scene, progress).run();
}

} // namespace pcl_cid
