/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Few points in the place of many.
 */

#include "thinning.h"

#include <algorithm>
#include <cstdint>
#include <random>

namespace pcl_cid::tools {
namespace {

/** How often the grid can be made twice as fine: three times as many bits fill a
 *  number. */
constexpr int levels = 21;

/** A point in the order of its cells of all grids (Morton 1966). */
struct Cell {
  std::uint64_t code;
  std::size_t point;
};

/** When a point is taken: by the grid in which it is the first of its cell, then by
 *  chance. */
struct Turn {
  int level;
  std::uint64_t draw;
  std::size_t point;
};

/** 21 bits with two zeros before each. */
std::uint64_t
spreadBits(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x1F00000000FFFFu;
  bits = (bits | bits << 16) & 0x1F0000FF0000FFu;
  bits = (bits | bits << 8) & 0x100F00F00F00F00Fu;
  bits = (bits | bits << 4) & 0x10C30C30C30C30C3u;
  return (bits | bits << 2) & 0x1249249249249249u;
}

/** Of the cell of the finest grid. */
std::uint64_t
codeOf(const Eigen::Vector3f& point, const Eigen::AlignedBox3d& box, double cells)
{
  constexpr double last = (std::uint64_t{1} << levels) - 1;
  const Eigen::Array3d at = (point.cast<double>() - box.min()).array() * cells;
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis)
    code |= spreadBits(static_cast<std::uint64_t>(std::clamp(at[axis], 0.0, last)))
            << axis;
  return code;
}

std::vector<Cell>
cellsOf(const Points& points, const Eigen::AlignedBox3d& box)
{
  const double side = std::max(box.sizes().maxCoeff(), 1e-9);
  std::vector<Cell> cells;
  cells.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    cells.push_back({codeOf(points[i], box, (std::uint64_t{1} << levels) / side), i});
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
    return a.code != b.code ? a.code < b.code : a.point < b.point;
  });
  return cells;
}

/** The coarsest grid that parts two cells; `levels` when none does. */
int
partingLevel(std::uint64_t a, std::uint64_t b)
{
  int level = levels;
  for (std::uint64_t different = a ^ b; different != 0; different >>= 3)
    --level;
  return level;
}

} // namespace

Eigen::AlignedBox3f
usualBox(const Points& points)
{
  Eigen::AlignedBox3f all;
  for (const Eigen::Vector3f& point : points)
    all.extend(point);
  Eigen::AlignedBox3f box;
  Eigen::Vector3f low;
  Eigen::Vector3f high;
  std::vector<float> values(points.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < points.size(); ++i)
      values[i] = points[i][axis];
    const auto astray = static_cast<std::ptrdiff_t>(points.size() / 1000);
    std::nth_element(values.begin(), values.begin() + astray, values.end());
    low[axis] = values[static_cast<std::size_t>(astray)];
    std::nth_element(values.begin(), values.end() - 1 - astray, values.end());
    high[axis] = *(values.end() - 1 - astray);
  }
  const Eigen::Vector3f margin = 0.1f * (high - low);
  box.extend(low - margin);
  box.extend(high + margin);
  return box.intersection(all);
}

std::vector<std::size_t>
spreadEvenly(const Points& points, const Eigen::AlignedBox3f& box, std::size_t most)
{
  const std::vector<Cell> cells = cellsOf(points, box.cast<double>());
  std::mt19937_64 random; // the same draws each time
  std::vector<Turn> turns;
  turns.reserve(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int level = i == 0 ? 0 : partingLevel(cells[i - 1].code, cells[i].code);
    turns.push_back({level, random(), cells[i].point});
  }
  const std::size_t size = std::min(most, turns.size());
  std::partial_sort(turns.begin(),
                    turns.begin() + static_cast<std::ptrdiff_t>(size),
                    turns.end(),
                    [](const Turn& a, const Turn& b) {
                      if (a.level != b.level)
                        return a.level < b.level;
                      return a.draw != b.draw ? a.draw < b.draw : a.point < b.point;
                    });
  std::vector<std::size_t> taken;
  taken.reserve(size);
  for (std::size_t i = 0; i < size; ++i)
    taken.push_back(turns[i].point);
  return taken;
}

} // namespace pcl_cid::tools
