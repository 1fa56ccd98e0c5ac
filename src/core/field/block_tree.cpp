/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points in the order of a balanced kd-tree, in blocks that are contiguous in
 * memory.
 */

#include "block_tree.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace pcl_cid {
namespace {

struct IndexedPoint {
  Eigen::Vector3f position;
  std::int32_t index;
};

PointBox
boxOf(const IndexedPoint* begin, const IndexedPoint* end)
{
  PointBox box{padded(begin->position), padded(begin->position)};
  for (const IndexedPoint* p = begin; p != end; ++p) {
    box.low = box.low.min(padded(p->position));
    box.high = box.high.max(padded(p->position));
  }
  return box;
}

/** Order along an axis, ties by index: no two points compare equal. */
struct AlongAxis {
  Eigen::Index axis;

  bool
  operator()(const IndexedPoint& a, const IndexedPoint& b) const
  {
    return a.position[axis] < b.position[axis] ||
           (a.position[axis] == b.position[axis] && a.index < b.index);
  }
};

/** Longer ranges are narrowed step by step, so that cancelling takes effect soon. */
constexpr std::ptrdiff_t long_range = 1 << 18;

/** Roughly the median of a long range, and never its smallest point. */
IndexedPoint
guessMedian(const IndexedPoint* begin, const IndexedPoint* end, const AlongAxis& less)
{
  std::array<IndexedPoint, 255> guesses;
  for (std::size_t k = 0; k < guesses.size(); ++k)
    guesses[k] = begin[static_cast<std::size_t>(end - begin) * k / guesses.size()];
  const auto middle = guesses.begin() + guesses.size() / 2;
  std::nth_element(guesses.begin(), middle, guesses.end(), less);
  return *middle;
}

/** std::nth_element along the widest side; polls the progress. */
void
split(IndexedPoint* begin, IndexedPoint* middle, IndexedPoint* end, Progress& progress)
{
  const PointBox box = boxOf(begin, end);
  AlongAxis less{0};
  (box.high - box.low).maxCoeff(&less.axis);
  while (end - begin > long_range) {
    const IndexedPoint guess = guessMedian(begin, end, less);
    IndexedPoint* const cut = std::partition(
        begin, end, [&](const IndexedPoint& p) { return less(p, guess); });
    (middle < cut ? end : begin) = cut;
    progress.poll();
  }
  std::nth_element(begin, middle, end, less);
}

PointBlock
makeBlock(const IndexedPoint* begin, const IndexedPoint* end)
{
  PointBlock block;
  block.count = static_cast<std::int32_t>(end - begin);
  for (int row = 0; row < PointBlock::capacity; ++row) {
    const IndexedPoint& p = begin[std::min(row, block.count - 1)];
    block.x[row] = p.position.x();
    block.y[row] = p.position.y();
    block.z[row] = p.position.z();
    block.index[row] = p.index;
  }
  return block;
}

} // namespace

std::size_t
BlockTree::leafOf(std::size_t node) const
{
  std::size_t first_of_last_level = 1;
  while (first_of_last_level < size())
    first_of_last_level *= 2;
  return node >= first_of_last_level ? node - first_of_last_level
                                     : node + size() - first_of_last_level;
}

std::size_t
BlockTree::firstLeaf(std::size_t node) const
{
  while (!isBlock(node))
    node = 2 * node;
  return leafOf(node);
}

std::size_t
BlockTree::endLeaf(std::size_t node) const
{
  while (!isBlock(node))
    node = 2 * node + 1;
  return leafOf(node) + 1;
}

BlockTree::BlockTree(const Points& points, int threads, Progress& progress)
{
  std::vector<IndexedPoint> sorted(points.size());
  parallelFor(points.size(), 4096, threads, progress, {}, [&](auto begin, auto end) {
    for (std::size_t i = begin; i < end; ++i)
      sorted[i] = {points[i], static_cast<std::int32_t>(i)};
  });

  const std::size_t blocks =
      (points.size() + PointBlock::capacity - 1) / PointBlock::capacity;
  blocks_.resize(blocks);
  const auto firstOf = [&](std::size_t leaf) {
    return sorted.data() + leaf * points.size() / blocks;
  };
  for (std::size_t level = 1; level < blocks; level *= 2)
    parallelForEach(
        std::min(level, blocks - level), threads, progress, {}, [&](std::size_t i) {
          const std::size_t node = level + i;
          split(firstOf(firstLeaf(node)),
                firstOf(firstLeaf(2 * node + 1)),
                firstOf(endLeaf(node)),
                progress);
        });

  positions_.resize(blocks * PointBlock::capacity);
  boxes_.resize(2 * blocks);
  parallelFor(
      blocks, 64, threads, progress, {}, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
          IndexedPoint* const first = firstOf(firstLeaf(nodeOfBlock(b)));
          IndexedPoint* const last = firstOf(endLeaf(nodeOfBlock(b)));
          blocks_[b] = makeBlock(first, last);
          for (int row = 0; row < PointBlock::capacity; ++row)
            positions_[b * PointBlock::capacity + static_cast<std::size_t>(row)] =
                blocks_[b].point(row);
          boxes_[blocks + b] = boxOf(first, last);
        }
      });
  for (std::size_t node = blocks - 1; node > 0; --node) {
    const PointBox& left = boxes_[2 * node];
    const PointBox& right = boxes_[2 * node + 1];
    boxes_[node] = {left.low.min(right.low), left.high.max(right.high)};
  }
}

} // namespace pcl_cid
