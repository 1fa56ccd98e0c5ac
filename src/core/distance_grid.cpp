/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Bounds of d(x; S) everywhere, and exact values near the surface: an adaptive
 * grid.
 */

#include "distance_grid.h"

#include "parallel_for.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl_cid {
namespace {

/** A cell that lists no more nodes than this is not divided further. */
constexpr std::size_t few_nodes = 12;
/** Longest list that is kept for exact answers. */
constexpr std::size_t most_nodes = 128;
/** Cells of the even grid for each point, about. */
constexpr double cells_per_point = 0.5;
/** The even grid is grown in 8^this pieces, each by one thread. */
constexpr int piece_bits = 3;

} // namespace

/** A cell in the making. */
struct DistanceGrid::Region {
  int x, y, z; ///< its corner, in finest cells
  int shift;
  std::int32_t slot; ///< the surface point nearest to the centre c
  float distance;    ///< d(c)
  /** Nodes that can hold the nearest point of an x inside; no two overlap. */
  std::vector<std::int32_t> nodes;
};

/** Boxes of nodes side by side, for four at a time. */
struct DistanceGrid::Boxes {
  std::vector<std::int32_t> nodes;
  Eigen::Array<float, Eigen::Dynamic, 6> sides;

  Boxes(const BlockTree& tree, std::vector<std::int32_t> listed)
  : nodes(std::move(listed)), sides(static_cast<Eigen::Index>(nodes.size()), 6)
  {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const PointBox& box = tree.box(static_cast<std::size_t>(nodes[k]));
      sides.row(static_cast<Eigen::Index>(k)) << box.low.transpose(),
          box.high.transpose();
    }
  }

  void
  squaredDistances(const Eigen::Vector3f& p, Eigen::ArrayXf& result) const
  {
    const auto gap = [&](int axis) {
      return (sides.col(axis) - p[axis]).max(p[axis] - sides.col(axis + 3)).max(0.0f);
    };
    result = gap(0).square() + gap(1).square() + gap(2).square();
  }
};

/** What one thread adds to the grid; indices count from its own beginning. */
struct DistanceGrid::Growth {
  std::vector<std::pair<std::size_t, Cell>> roots;
  std::vector<Cell> cells;
  std::vector<std::int32_t> lists = {0};
  std::size_t budget = 0; ///< bytes

  bool
  affordsDivision() const
  {
    return cells.size() * sizeof(Cell) + lists.size() * sizeof(std::int32_t) < budget;
  }
};

DistanceGrid::DistanceGrid(const BlockTree& tree,
                           std::size_t memory_budget,
                           int threads,
                           Progress& progress)
: tree_(tree)
{
  const PointBox& box = tree.box(1);
  const float size = (box.high - box.low).maxCoeff();
  const float magnitude = std::max(box.low.abs().maxCoeff(), box.high.abs().maxCoeff());
  const float side = std::max(1.01f * size, 1e-6f * magnitude + 1e-20f);
  corner_ = box.centre() - Eigen::Vector3f::Constant(0.5f * side);
  finest_ = std::ldexp(side, -levels);
  inverse_finest_ = 1.0f / finest_;
  slack_ = 16.0f * std::numeric_limits<float>::epsilon() * (magnitude + 2.0f * side);

  const double points = static_cast<double>(tree.size()) * PointBlock::capacity;
  const auto cells = [](int bits) { return std::size_t{1} << (3 * bits); };
  while (root_bits_ < 8 &&
         static_cast<double>(cells(root_bits_ + 1)) <= cells_per_point * points &&
         cells(root_bits_ + 1) * sizeof(Cell) <= memory_budget / 2)
    ++root_bits_;
  cells_.resize(cells(root_bits_));
  lists_.push_back(0);

  std::vector<Region> pieces;
  pieces.push_back(wholeRegion());
  for (int bits = 0; bits < std::min(piece_bits, root_bits_); ++bits) {
    std::vector<Region> finer;
    for (const Region& region : pieces)
      for (Region& part : divide(region))
        finer.push_back(std::move(part));
    pieces = std::move(finer);
  }
  std::size_t nodes = 0;
  for (const Region& piece : pieces)
    nodes += piece.nodes.size();
  const std::size_t left = memory_budget - std::min(bytes(), memory_budget);
  std::vector<Growth> growths(pieces.size());
  parallelFor(
      pieces.size(), 1, threads, progress, {}, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          growths[k].budget = static_cast<std::size_t>(
              static_cast<double>(left) * static_cast<double>(pieces[k].nodes.size()) /
              static_cast<double>(nodes));
          grow(pieces[k], growths[k]);
        }
      });
  std::size_t all_cells = cells_.size(), all_lists = lists_.size();
  for (const Growth& growth : growths) {
    all_cells += growth.cells.size();
    all_lists += growth.lists.size();
  }
  cells_.reserve(all_cells);
  lists_.reserve(all_lists);
  for (Growth& growth : growths)
    merge(growth);
}

DistanceGrid::Region
DistanceGrid::wholeRegion() const
{
  Region whole{0, 0, 0, levels, 0, 0.0f, {1}};
  const Eigen::Vector3f centre = centreOf({0, 0, 0, true}, levels);
  BlockTree::Nearest nearest;
  tree_.descend(1, centre, nearest);
  whole.slot = nearest.slot;
  whole.distance = std::sqrt(nearest.squared_distance);
  return whole;
}

/** One eighth of a region. */
DistanceGrid::Region
DistanceGrid::child(const Region& parent, const Boxes& boxes, int octant) const
{
  const int half = 1 << (parent.shift - 1);
  Region region{parent.x + (octant & 1 ? half : 0),
                parent.y + (octant & 2 ? half : 0),
                parent.z + (octant & 4 ? half : 0),
                parent.shift - 1,
                0,
                0.0f,
                {}};
  const Eigen::Vector3f centre =
      centreOf({region.x, region.y, region.z, true}, region.shift);
  thread_local Eigen::ArrayXf to_node;
  boxes.squaredDistances(centre, to_node);
  Eigen::Index first = 0;
  to_node.minCoeff(&first);
  BlockTree::Nearest nearest;
  tree_.descend(static_cast<std::size_t>(boxes.nodes[static_cast<std::size_t>(first)]),
                centre,
                nearest);
  for (Eigen::Index k = 0; k < to_node.size(); ++k)
    if (to_node[k] <= nearest.squared_distance * BlockTree::rounding)
      tree_.descend(static_cast<std::size_t>(boxes.nodes[static_cast<std::size_t>(k)]),
                    centre,
                    nearest);
  region.slot = nearest.slot;
  region.distance = std::sqrt(nearest.squared_distance);

  // Whatever x in the cell: d(x) <= d(c) + |x - c|, and a node at distance b from c is
  // no nearer to x than b - |x - c|.
  const float reach =
      (region.distance + 2.0f * halfDiagonal(region.shift)) * 1.00001f + slack_;
  for (Eigen::Index k = 0; k < to_node.size(); ++k)
    if (to_node[k] <= reach * reach)
      region.nodes.push_back(boxes.nodes[static_cast<std::size_t>(k)]);
  return region;
}

/** The eight parts of a region. Nodes that are larger than a part are opened first. */
std::vector<DistanceGrid::Region>
DistanceGrid::divide(const Region& region) const
{
  const float part = halfDiagonal(region.shift - 1);
  std::vector<std::int32_t> nodes = region.nodes;
  for (std::size_t k = 0; k < nodes.size();) {
    const auto node = static_cast<std::size_t>(nodes[k]);
    if (tree_.isBlock(node) || tree_.box(node).radius() <= part) {
      ++k;
      continue;
    }
    nodes[k] = static_cast<std::int32_t>(2 * node);
    nodes.push_back(static_cast<std::int32_t>(2 * node + 1));
  }
  const Boxes boxes(tree_, std::move(nodes));
  std::vector<Region> parts;
  for (int octant = 0; octant < 8; ++octant)
    parts.push_back(child(region, boxes, octant));
  return parts;
}

/** Fill the even grid inside a region, and divide its cells where that pays. */
void
DistanceGrid::grow(const Region& region, Growth& growth)
{
  const int root_shift = rootShift();
  if (region.shift > root_shift) {
    for (const Region& part : divide(region))
      grow(part, growth);
    return;
  }
  const auto fill = [&](const auto& self, const Region& of_cell) -> Cell {
    const bool near = of_cell.distance <= halfDiagonal(of_cell.shift);
    if (near && of_cell.nodes.size() > few_nodes && of_cell.shift > 0 &&
        growth.affordsDivision()) {
      const std::size_t first = growth.cells.size();
      growth.cells.resize(first + 8);
      const std::vector<Region> parts = divide(of_cell);
      for (std::size_t octant = 0; octant < 8; ++octant) {
        const Cell cell = self(self, parts[octant]);
        growth.cells[first + octant] = cell;
      }
      return {~static_cast<std::int32_t>(first), 0};
    }
    if (of_cell.nodes.size() > most_nodes)
      return {of_cell.slot, 0};
    const auto list = static_cast<std::uint32_t>(growth.lists.size());
    growth.lists.push_back(static_cast<std::int32_t>(of_cell.nodes.size()));
    growth.lists.insert(growth.lists.end(), of_cell.nodes.begin(), of_cell.nodes.end());
    return {of_cell.slot, list};
  };
  growth.roots.emplace_back(
      rootIndex(region.x >> root_shift, region.y >> root_shift, region.z >> root_shift),
      fill(fill, region));
}

/** Take over what a thread has made, with indices that count from the grid's
 *  beginning. */
void
DistanceGrid::merge(Growth& growth)
{
  const auto cells_before = static_cast<std::int32_t>(cells_.size());
  const auto lists_before = static_cast<std::uint32_t>(lists_.size() - 1);
  const auto moved = [&](Cell cell) -> Cell {
    return {cell.slot < 0 ? cell.slot - cells_before : cell.slot,
            cell.list > 0 ? cell.list + lists_before : 0};
  };
  for (const auto& [root, cell] : growth.roots)
    cells_[root] = moved(cell);
  for (const Cell& cell : growth.cells)
    cells_.push_back(moved(cell));
  lists_.insert(lists_.end(), growth.lists.begin() + 1, growth.lists.end());
  growth = Growth();
}

BlockTree::Nearest
DistanceGrid::nearest(const Eigen::Vector3f& x) const
{
  BlockTree::Nearest nearest;
  const Place place = placeOf(x);
  const Cell& cell = *leafAt(place).cell;
  if (!place.inside || cell.list == 0)
    return nearest;
  tree_.descend(
      tree_.nodeOfBlock(static_cast<std::size_t>(cell.slot / PointBlock::capacity)),
      x,
      nearest);
  const std::int32_t* list = &lists_[cell.list];
  for (std::int32_t k = 1; k <= list[0]; ++k) {
    const auto node = static_cast<std::size_t>(list[k]);
    if (tree_.box(node).squaredDistance(x) <=
        nearest.squared_distance * BlockTree::rounding)
      tree_.descend(node, x, nearest);
  }
  return nearest;
}

} // namespace pcl_cid
