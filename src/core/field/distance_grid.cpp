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
#include "grid_growth.h"

#include "base/parallel_for.h"
#include "base/rounding.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace pcl_cid {
namespace {

/** A cell with no more nodes than this has a list of its own, which its parts use, too;
 *  one with more shares the list of the region that it is a part of. */
constexpr std::size_t few_nodes = 8;
/** Longest list that is kept for exact answers. */
constexpr std::size_t most_nodes = 128;
/** How far off bounds may be, as a share of the radius of a block (a few times the
 *  spacing of its points); grows with their number, see tolerateErrors(). */
constexpr float error_to_radius = 0.08f;
/** A cell that is farther from the surface than this many of its half diagonals is fine
 *  enough, whatever its error. */
constexpr float far_away = 4.0f;
/** Cells of the regular grid for each point, roughly. */
constexpr double cells_per_point = 1.0;
/** Finest division of the regular grid into pieces: 2^this a side. */
constexpr int most_piece_bits = 3;

} // namespace

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
  corner_ = box.center() - Eigen::Vector3f::Constant(0.5f * side);
  finest_ = std::ldexp(side, -levels);
  inverse_finest_ = 1.0f / finest_;
  slack_ = rounding::ofSample(magnitude + 2.0f * side);

  const double points = static_cast<double>(tree.size()) * PointBlock::capacity;
  const auto cells = [](int bits) { return std::size_t{1} << (3 * bits); };
  while (root_bits_ < 8 &&
         static_cast<double>(cells(root_bits_ + 1)) <= cells_per_point * points &&
         cells(root_bits_ + 1) * sizeof(Cell) <= memory_budget / 2)
    ++root_bits_;
  piece_bits_ = std::min(root_bits_, most_piece_bits);
  tolerateErrors();

  const std::vector<Region> regions = divideWhole();
  std::size_t nodes = 0;
  for (const Region& region : regions)
    nodes += region.nodes.size();
  const std::size_t even = cells(root_bits_) * sizeof(Cell);
  const double for_each_node =
      static_cast<double>(memory_budget - std::min(even, memory_budget)) /
      static_cast<double>(nodes);
  pieces_.resize(regions.size());
  parallelForEach(regions.size(), threads, progress, {}, [&](std::size_t k) {
    const double share = for_each_node * static_cast<double>(regions[k].nodes.size());
    growPiece(
        regions[k], even / regions.size() + static_cast<std::size_t>(share), progress);
  });
  tolerated_error_ = {};
}

/** The denser the points, the larger the tolerated share of a radius: the differences
 *  in CID that bounds must resolve shrink with the spacing, but more slowly. The sixth
 *  root of the number of blocks was measured to be right for rooms of 20,000 to
 *  10,000,000 points.
 *
 *  A block of equal points has radius 0, so the radii of the nodes above it count, too,
 *  each level up by a quarter. */
void
DistanceGrid::tolerateErrors()
{
  const float share =
      error_to_radius * std::pow(static_cast<float>(tree_.size()), 1.0f / 6.0f);
  std::vector<float> radius(2 * tree_.size());
  for (std::size_t node = 1; node < radius.size(); ++node)
    radius[node] = std::max(tree_.box(node).radius(), 0.25f * radius[node / 2]);
  tolerated_error_.resize(tree_.size());
  for (std::size_t b = 0; b < tree_.size(); ++b)
    tolerated_error_[b] = share * radius[tree_.nodeOfBlock(b)];
}

std::size_t
DistanceGrid::bytes() const
{
  std::size_t sum = 0;
  for (const Piece& piece : pieces_)
    sum += piece.bytes();
  return sum;
}

/** The region of each piece. */
std::vector<DistanceGrid::Region>
DistanceGrid::divideWhole() const
{
  std::vector<Region> regions = {wholeRegion()};
  Boxes boxes;
  for (int bits = 0; bits < piece_bits_; ++bits) {
    std::vector<Region> finer(8 * regions.size());
    for (std::size_t k = 0; k < finer.size(); ++k) {
      if (k % 8 == 0)
        open(regions[k / 8], boxes);
      makePart(regions[k / 8], boxes, static_cast<int>(k % 8), finer[k]);
      keepNodes(boxes, finer[k]);
    }
    regions = std::move(finer);
  }
  return regions;
}

DistanceGrid::Region
DistanceGrid::wholeRegion() const
{
  Region whole;
  whole.nodes = {1};
  const Eigen::Vector3f center = centerOf(whole.corner(), levels);
  BlockTree::Nearest nearest;
  tree_.descend(1, padded(center), nearest);
  whole.slot = nearest.slot;
  whole.distance = std::sqrt(nearest.squared_distance);
  return whole;
}

/** The nodes of a region for its parts: nodes larger than a part are replaced by their
 *  children. */
void
DistanceGrid::open(const Region& region, Boxes& boxes) const
{
  const float part = halfDiagonal(region.shift - 1);
  std::vector<std::int32_t>& nodes = boxes.nodes;
  nodes = region.nodes;
  for (std::size_t k = 0; k < nodes.size();) {
    const auto node = static_cast<std::size_t>(nodes[k]);
    if (tree_.isBlock(node) || tree_.box(node).radius() <= part) {
      ++k;
      continue;
    }
    nodes[k] = static_cast<std::int32_t>(2 * node);
    nodes.push_back(static_cast<std::int32_t>(2 * node + 1));
  }
  boxes.load(tree_);
  boxes.measureGaps(centerOf(region.octant(0), region.shift - 1),
                    centerOf(region.octant(7), region.shift - 1));
}

/** One eighth of a region. */
void
DistanceGrid::makePart(const Region& whole,
                       Boxes& boxes,
                       int octant,
                       Region& part) const
{
  part.shift = whole.shift - 1;
  const Place corner = whole.octant(octant);
  part.x = corner.x;
  part.y = corner.y;
  part.z = corner.z;
  const Eigen::Vector3f center = centerOf(corner, part.shift);
  const Eigen::Array4f x = padded(center);
  boxes.measure(octant);
  // Start with the point nearest to the whole's center: few others are nearer. Its
  // distance is rounded up, so the search finds that point again and sets its exact
  // distance.
  BlockTree::Nearest nearest;
  nearest.slot = whole.slot;
  nearest.squared_distance =
      (center - tree_.position(whole.slot)).squaredNorm() * rounding::widening;
  for (Eigen::Index k = 0; k < boxes.size(); ++k)
    if (boxes.squared_distance[k] <= nearest.squared_distance * rounding::widening)
      tree_.descend(static_cast<std::size_t>(boxes.nodes[static_cast<std::size_t>(k)]),
                    x,
                    nearest);
  part.slot = nearest.slot;
  part.distance = std::sqrt(nearest.squared_distance);
}

/** Keep, for a part, the nodes that can hold the point nearest to an x inside it. */
void
DistanceGrid::keepNodes(const Boxes& boxes, Region& part) const
{
  // For any x in the cell: d(x) <= d(c) + |x - c|, and a node at distance b from c is
  // no nearer to x than b - |x - c|.
  const float reach =
      (part.distance + 2.0f * halfDiagonal(part.shift)) * rounding::widening + slack_;
  part.nodes.resize(boxes.nodes.size());
  std::size_t kept = 0;
  for (std::size_t k = 0; k < boxes.nodes.size(); ++k) { // branch-free
    part.nodes[kept] = boxes.nodes[k];
    kept += boxes.squared_distance[static_cast<Eigen::Index>(k)] <= reach * reach;
  }
  part.nodes.resize(kept);
}

/** Whether a cell may hold samples of segments between points: they do not leave the
 *  box of the points. */
bool
DistanceGrid::isVisited(const Region& cell) const
{
  const PointBox& box = tree_.box(1);
  const Eigen::Array4f center = padded(centerOf(cell.corner(), cell.shift));
  const float half = 0.5f * finest_ * static_cast<float>(1 << cell.shift) + slack_;
  return (center - half <= box.high).all() && (center + half >= box.low).all();
}

/** Whether a cell is worth dividing. At x = c + e, |x - n| exceeds d(x) by no more than
 *  about |e|^2 / d(c) where the surface is flat, and by |e| close to it. */
bool
DistanceGrid::isCoarse(const Region& cell) const
{
  const float h = halfDiagonal(cell.shift);
  const auto block = static_cast<std::size_t>(cell.slot / PointBlock::capacity);
  return cell.shift > 0 && h > slack_ && cell.distance <= far_away * h &&
         h * h > tolerated_error_[block] * std::max(cell.distance, h) &&
         isVisited(cell);
}

void
DistanceGrid::growPiece(const Region& region, std::size_t budget, Progress& progress)
{
  Piece& piece = pieces_[pieceAt(region.corner())];
  piece.resize(std::size_t{1} << (3 * (root_bits_ - piece_bits_)));
  piece.lists.push_back(0);
  const auto growth = std::make_unique<Growth>(Growth{piece, budget, progress, {}, {}});
  SharedList whole{region, 0};
  grow(region, whole, *growth);
  piece.slot.shrink_to_fit();
  piece.list.shrink_to_fit();
  piece.lists.shrink_to_fit();
}

/** Fill the regular grid inside a region, and divide its cells where that pays. */
void
DistanceGrid::grow(const Region& region, SharedList& whole, Growth& growth) const
{
  if (region.shift == rootShift()) {
    growth.progress.poll();
    growth.piece.set(rootAt(region.corner()), makeCell(region, 0, whole, growth));
    return;
  }
  Boxes& boxes = growth.boxes[static_cast<std::size_t>(region.shift)];
  Region& part = growth.regions[static_cast<std::size_t>(region.shift - 1)];
  open(region, boxes);
  SharedList shared{region, 0};
  for (int octant = 0; octant < 8; ++octant) {
    makePart(region, boxes, octant, part);
    keepNodes(boxes, part);
    grow(part, shared, growth);
  }
}

/** Divide a cell where that pays.
 *  \param[in] list that of a larger cell around this one if it has few nodes; else 0
 *  \param[in,out] whole what this cell is an eighth of */
DistanceGrid::Cell
DistanceGrid::makeCell(const Region& region,
                       std::uint32_t list,
                       SharedList& whole,
                       Growth& growth) const
{
  if (list == 0 && region.nodes.size() <= few_nodes)
    list = makeList(region, growth);
  if (!isCoarse(region) || !growth.hasMemory())
    return {region.slot, list != 0 ? list : whole.make(*this, growth)};
  const std::size_t first = growth.piece.slot.size();
  growth.piece.resize(first + 8);
  Boxes& boxes = growth.boxes[static_cast<std::size_t>(region.shift)];
  Region& part = growth.regions[static_cast<std::size_t>(region.shift - 1)];
  open(region, boxes);
  SharedList shared{region, 0};
  for (int octant = 0; octant < 8; ++octant) {
    makePart(region, boxes, octant, part);
    if (list == 0 || isCoarse(part))
      keepNodes(boxes, part);
    growth.piece.set(first + static_cast<std::size_t>(octant),
                     makeCell(part, list, shared, growth));
  }
  return {~static_cast<std::int32_t>(first), 0};
}

/** \return 0 when it would be too long, or memory has run out */
std::uint32_t
DistanceGrid::makeList(const Region& region, Growth& growth) const
{
  if (region.nodes.size() > most_nodes || !growth.hasMemory())
    return 0;
  const auto list = static_cast<std::uint32_t>(growth.piece.lists.size());
  growth.piece.lists.push_back(static_cast<std::int32_t>(region.nodes.size()));
  growth.piece.lists.insert(
      growth.piece.lists.end(), region.nodes.begin(), region.nodes.end());
  return list;
}

BlockTree::Nearest
DistanceGrid::nearest(const Eigen::Vector3f& x) const
{
  const Place place = placeOf(x);
  const Leaf leaf = leafAt(place);
  const std::uint32_t first = leaf.piece->list[leaf.index];
  if (!place.inside || first == 0)
    return {};
  const std::int32_t* list = &leaf.piece->lists[first];
  // The block of the point nearest to the center first: it rules out most others.
  const auto likely = static_cast<std::size_t>(leaf.slot / PointBlock::capacity);
  const Eigen::Array4f padded_x = padded(x);
  BlockTree::Nearest nearest;
  tree_.scan(likely, padded_x, nearest);
  for (std::int32_t k = 1; k <= list[0]; ++k) {
    const auto node = static_cast<std::size_t>(list[k]);
    if (node != tree_.nodeOfBlock(likely) &&
        tree_.box(node).squaredDistance(padded_x) <=
            nearest.squared_distance * rounding::widening)
      tree_.descend(node, padded_x, nearest);
  }
  return nearest;
}

} // namespace pcl_cid
