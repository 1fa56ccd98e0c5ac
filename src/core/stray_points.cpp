/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points that have nothing to do with the part they are in.
 */

#include "stray_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {
namespace {

/** Which cell; whole numbers, in double because they may be huge. */
using CellIndex = std::array<double, 3>;

struct Cell {
  pcl::Indices members;
  int cluster = -1;
};

/** \brief The points of a part in cubic cells with a diagonal of less than the distance
 *  that links points: a cluster is made of whole cells. */
class ClusteredCells {
public:
  ClusteredCells(const Points& points, const pcl::Indices& members, double distance)
  : points_(points), distance_(distance)
  {
    for (const pcl::index_t member : members)
      cells_[cellOf(point(member))].members.push_back(member);
    for (auto& [index, cell] : cells_)
      if (cell.cluster < 0)
        growCluster(index);
  }

  /** \brief Points in each cluster. */
  const std::vector<std::size_t>&
  sizes() const
  {
    return sizes_;
  }

  int
  clusterOf(pcl::index_t member) const
  {
    return cells_.at(cellOf(point(member))).cluster;
  }

private:
  Eigen::Vector3d
  point(pcl::index_t member) const
  {
    return points_[static_cast<std::size_t>(member)].cast<double>();
  }

  CellIndex
  cellOf(const Eigen::Vector3d& p) const
  {
    const double side = 0.5 * distance_;
    return {
        std::floor(p.x() / side), std::floor(p.y() / side), std::floor(p.z() / side)};
  }

  void
  growCluster(const CellIndex& first)
  {
    const auto cluster = static_cast<int>(sizes_.size());
    sizes_.push_back(0);
    std::vector<CellIndex> reached;
    const auto reach = [&](const CellIndex& index, Cell& cell) {
      cell.cluster = cluster;
      sizes_.back() += cell.members.size();
      reached.push_back(index);
    };
    reach(first, cells_.at(first));
    while (!reached.empty()) {
      const CellIndex index = reached.back();
      reached.pop_back();
      visitLinked(index, reach);
    }
  }

  /** Call \a reach for each cell of no cluster with a point linked to one in here: it
   * is at most two cells away. */
  template <typename Reach>
  void
  visitLinked(const CellIndex& index, const Reach& reach)
  {
    const Cell& here = cells_.at(index);
    for (int dx = -2; dx <= 2; ++dx)
      for (int dy = -2; dy <= 2; ++dy)
        for (int dz = -2; dz <= 2; ++dz) {
          const auto there = cells_.find({index[0] + dx, index[1] + dy, index[2] + dz});
          if (there != cells_.end() && there->second.cluster < 0 &&
              areLinked(here, there->second))
            reach(there->first, there->second);
        }
  }

  bool
  areLinked(const Cell& a, const Cell& b) const
  {
    for (const pcl::index_t i : a.members)
      for (const pcl::index_t j : b.members)
        if ((point(i) - point(j)).norm() <= distance_)
          return true;
    return false;
  }

  const Points& points_;
  double distance_;
  std::map<CellIndex, Cell> cells_;
  std::vector<std::size_t> sizes_;
};

} // namespace

TrimmedPart
trimStrayPoints(const Points& points, const pcl::Indices& members, double distance)
{
  constexpr std::size_t bulk = 100; // times as many points as in a stray cluster
  if (distance == 0.0)
    return {members, {}};
  const ClusteredCells cells(points, members, distance);
  const std::size_t largest =
      *std::max_element(cells.sizes().begin(), cells.sizes().end());
  TrimmedPart part;
  for (const pcl::index_t member : members) {
    const auto cluster = static_cast<std::size_t>(cells.clusterOf(member));
    const bool is_stray = cells.sizes()[cluster] < (largest + bulk - 1) / bulk;
    (is_stray ? part.trimmed : part.kept).push_back(member);
  }
  return part;
}

} // namespace pcl_cid
