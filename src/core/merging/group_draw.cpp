/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which pairs of points represent two groups: Eq. 4 with spread draws.
 */

#include "group_draw.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

using Member = pcl::Indices::iterator;

Eigen::Index
widestAxis(const Points& points, Member begin, Member end)
{
  Eigen::AlignedBox<float, 3> box;
  for (Member m = begin; m != end; ++m)
    box.extend(points[static_cast<std::size_t>(*m)]);
  Eigen::Index axis;
  box.sizes().maxCoeff(&axis);
  return axis;
}

void
drawFromCells(const Points& points,
              Member begin,
              Member end,
              std::size_t cells,
              RandomGenerator& generator,
              pcl::Indices& drawn)
{
  const auto count = static_cast<std::size_t>(end - begin);
  if (cells == 1) {
    // What is drawn must not depend on how nth_element leaves the others.
    const Member chosen =
        begin + static_cast<std::ptrdiff_t>(drawBelow(generator, count));
    std::nth_element(begin, chosen, end);
    drawn.push_back(*chosen);
    return;
  }
  const std::size_t left = cells / 2;
  const Member middle = begin + static_cast<std::ptrdiff_t>(count * left / cells);
  const auto along = [&points, axis = widestAxis(points, begin, end)](auto m) {
    return std::make_pair(points[static_cast<std::size_t>(m)][axis], m);
  };
  std::nth_element(
      begin, middle, end, [&](auto a, auto b) { return along(a) < along(b); });
  drawFromCells(points, begin, middle, left, generator, drawn);
  drawFromCells(points, middle, end, cells - left, generator, drawn);
}

} // namespace

pcl::Indices
drawSpread(const Points& points,
           pcl::Indices members,
           std::size_t count,
           RandomGenerator& generator)
{
  pcl::Indices drawn;
  drawFromCells(points,
                members.begin(),
                members.end(),
                std::min(count, members.size()),
                generator,
                drawn);
  return drawn;
}

PairLattice::PairLattice(std::size_t size) : size_(size)
{
  constexpr double golden_ratio = 1.6180339887498949;
  const auto wanted = std::llround(static_cast<double>(size) / golden_ratio);
  for (long long offset = 0; step_ == 0; ++offset)
    for (const long long step : {wanted + offset, wanted - offset})
      if (step > 0 && std::gcd(static_cast<std::size_t>(step), size) == 1)
        step_ = static_cast<std::size_t>(step);
}

} // namespace pcl_cid
