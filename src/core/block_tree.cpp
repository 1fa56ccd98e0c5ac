/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points in the order of a balanced kd-tree, in blocks that are neighbours in
 * memory.
 */

#include "block_tree.h"

#include "parallel_for.h"

#include <algorithm>

namespace pcl_cid {
namespace {

struct IndexedPoint {
  Eigen::Vector3f position;
  std::int32_t index;
};

PointBox
boxOf(const IndexedPoint* begin, const IndexedPoint* end)
{
  PointBox box{begin->position.array(), begin->position.array()};
  for (const IndexedPoint* p = begin; p != end; ++p) {
    box.low = box.low.min(p->position.array());
    box.high = box.high.max(p->position.array());
  }
  return box;
}

void
splitAtMedian(IndexedPoint* begin, IndexedPoint* middle, IndexedPoint* end)
{
  const PointBox box = boxOf(begin, end);
  Eigen::Index axis = 0;
  (box.high - box.low).maxCoeff(&axis);
  std::nth_element(
      begin, middle, end, [axis](const IndexedPoint& a, const IndexedPoint& b) {
        return a.position[axis] < b.position[axis] ||
               (a.position[axis] == b.position[axis] && a.index < b.index);
      });
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

BlockTree::BlockTree(const Points& points, int threads, Progress& progress)
{
  std::vector<IndexedPoint> sorted(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    sorted[i] = {points[i], static_cast<std::int32_t>(i)};

  std::size_t blocks = 1;
  while (points.size() > blocks * PointBlock::capacity)
    blocks *= 2;
  const auto firstOf = [&](std::size_t part, std::size_t parts) {
    return sorted.data() + part * points.size() / parts;
  };
  for (std::size_t parts = 1; parts < blocks; parts *= 2)
    parallelFor(
        parts, 1, threads, progress, {}, [&](std::size_t begin, std::size_t end) {
          for (std::size_t part = begin; part < end; ++part)
            splitAtMedian(firstOf(part, parts),
                          firstOf(2 * part + 1, 2 * parts),
                          firstOf(part + 1, parts));
        });

  blocks_.resize(blocks);
  positions_.resize(blocks * PointBlock::capacity);
  boxes_.resize(2 * blocks);
  parallelFor(
      blocks, 64, threads, progress, {}, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
          blocks_[b] = makeBlock(firstOf(b, blocks), firstOf(b + 1, blocks));
          for (int row = 0; row < PointBlock::capacity; ++row)
            positions_[b * PointBlock::capacity + static_cast<std::size_t>(row)] =
                blocks_[b].point(row);
          boxes_[blocks + b] = boxOf(firstOf(b, blocks), firstOf(b + 1, blocks));
        }
      });
  for (std::size_t node = blocks - 1; node > 0; --node) {
    const PointBox& left = boxes_[2 * node];
    const PointBox& right = boxes_[2 * node + 1];
    boxes_[node] = {left.low.min(right.low), left.high.max(right.high)};
  }
}

} // namespace pcl_cid
