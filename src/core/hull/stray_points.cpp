/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Stray points: those that do not belong to the part they are in.
 */

#include "stray_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {
namespace {

/** Which cell; whole numbers, in double because they may be huge. */
using CellIndex = std::array<double, 3>;

/** \brief The points of a part in cubic cells with a diagonal of less than the distance
 *  that links points: a cluster is made of whole cells. */
class ClusteredCells {
public:
  ClusteredCells(const Points& points, const pcl::Indices& members, double distance)
  : distance_(distance)
  {
    sortIntoCells(points, members);
    for (std::size_t row = 0; row < rows; ++row)
      linkWithRow(row);
  }

  /** \brief For each member, how many are in its cluster. */
  std::vector<std::size_t>
  clusterSizes()
  {
    std::vector<std::size_t> size(cells_.size(), 0);
    for (std::size_t c = 0; c < cells_.size(); ++c)
      size[rootOf(c)] += cells_[c].end - cells_[c].begin;
    std::vector<std::size_t> size_of_member(points_.size());
    for (std::size_t c = 0; c < cells_.size(); ++c)
      for (std::size_t i = cells_[c].begin; i < cells_[c].end; ++i)
        size_of_member[points_[i].member] = size[rootOf(c)];
    return size_of_member;
  }

private:
  struct CellPoint {
    CellIndex cell;
    std::size_t member; ///< its number among the members
    Eigen::Vector3d position;

    bool
    operator<(const CellPoint& other) const
    {
      return std::tie(cell, member) < std::tie(other.cell, other.member);
    }
  };

  /** A run of points_, and the cell before it in its cluster: itself for the root. */
  struct Cell {
    std::size_t begin;
    std::size_t end;
    std::size_t parent;
  };

  /** Linked points are at most two cells apart. Half of those cells come later in the
   *  order of cells: in the rows (0, 0), (0, 1), (0, 2), (1, -2) ... */
  static constexpr std::size_t rows = 13;

  void
  sortIntoCells(const Points& points, const pcl::Indices& members)
  {
    const double side = 0.5 * distance_;
    points_.reserve(members.size());
    for (std::size_t m = 0; m < members.size(); ++m) {
      const Eigen::Vector3d p =
          points[static_cast<std::size_t>(members[m])].cast<double>();
      const CellIndex cell = {
          std::floor(p.x() / side), std::floor(p.y() / side), std::floor(p.z() / side)};
      points_.push_back({cell, m, p});
    }
    std::sort(points_.begin(), points_.end());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (i == 0 || points_[i].cell != points_[i - 1].cell)
        cells_.push_back({i, i, cells_.size()});
      cells_.back().end = i + 1;
    }
  }

  const CellIndex&
  indexOf(std::size_t cell) const
  {
    return points_[cells_[cell].begin].cell;
  }

  /** Link every cell with those of one of its later rows, up to two cells to either
   *  side. Cells are in order, and so are their rows, so one sweep is enough. */
  void
  linkWithRow(std::size_t row)
  {
    const auto step_x = static_cast<double>((row + 2) / 5);
    const double step_y = static_cast<double>((row + 2) % 5) - 2.0;
    std::size_t first = 0;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const CellIndex& here = indexOf(c);
      const CellIndex low = {here[0] + step_x, here[1] + step_y, here[2] - 2.0};
      const CellIndex high = {low[0], low[1], here[2] + 2.0};
      while (first < cells_.size() && indexOf(first) < low)
        ++first;
      for (std::size_t other = first; other < cells_.size() && indexOf(other) <= high;
           ++other)
        link(c, other);
    }
  }

  void
  link(std::size_t a, std::size_t b)
  {
    const std::size_t root_a = rootOf(a);
    const std::size_t root_b = rootOf(b);
    if (root_a != root_b && areLinked(cells_[a], cells_[b]))
      cells_[std::max(root_a, root_b)].parent = std::min(root_a, root_b);
  }

  std::size_t
  rootOf(std::size_t cell)
  {
    while (cells_[cell].parent != cell) {
      cells_[cell].parent = cells_[cells_[cell].parent].parent;
      cell = cells_[cell].parent;
    }
    return cell;
  }

  bool
  areLinked(const Cell& a, const Cell& b) const
  {
    for (std::size_t i = a.begin; i < a.end; ++i)
      for (std::size_t j = b.begin; j < b.end; ++j)
        if ((points_[i].position - points_[j].position).norm() <= distance_)
          return true;
    return false;
  }

  double distance_;
  std::vector<CellPoint> points_; ///< by cell
  std::vector<Cell> cells_;       ///< by index
};

} // namespace

TrimmedPart
trimStrayPoints(const Points& points, const pcl::Indices& members, double distance)
{
  constexpr std::size_t bulk = 100; // times as many points as in a stray cluster
  if (distance == 0.0)
    return {members, {}};
  const std::vector<std::size_t> sizes =
      ClusteredCells(points, members, distance).clusterSizes();
  const std::size_t largest = *std::max_element(sizes.begin(), sizes.end());
  TrimmedPart part;
  for (std::size_t m = 0; m < members.size(); ++m) {
    const bool is_stray = sizes[m] < (largest + bulk - 1) / bulk;
    (is_stray ? part.trimmed : part.kept).push_back(members[m]);
  }
  return part;
}

} // namespace pcl_cid
