/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Real-valued draws that are the same on every machine: no std distributions, no libm.
 */

#pragma once

#include "base/random.h"

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid::test {

/** \brief A closed interval to draw from. */
struct Range {
  double low;
  double high;
};

/** \brief Uniform in [0, 1), a multiple of 2^-53; one draw. */
inline double
drawUnit(RandomGenerator& generator)
{
  return static_cast<double>(generator() >> 11) * 0x1p-53;
}

/** \brief Uniform in [range.low, range.high); one draw. */
inline double
drawWithin(RandomGenerator& generator, const Range& range)
{
  return range.low + (range.high - range.low) * drawUnit(generator);
}

/** \brief Mean 0, variance 1, nearly normal, never beyond 6: the sum of twelve uniform
 *  draws (Irwin-Hall), because log and cos differ in the last bit between machines. */
inline double
drawNormal(RandomGenerator& generator)
{
  double sum = -6.0;
  for (int draw = 0; draw < 12; ++draw)
    sum += drawUnit(generator);
  return sum;
}

/** \brief A whole number from \a low to \a high. */
inline unsigned
drawCount(RandomGenerator& generator, unsigned low, unsigned high)
{
  return low + static_cast<unsigned>(drawBelow(generator, high - low + 1));
}

/** \brief A range of a single value, from \a range. */
inline Range
drawMeasure(RandomGenerator& generator, const Range& range)
{
  const double measure = drawWithin(generator, range);
  return {measure, measure};
}

/** \brief A direction in plan; the tangent of half its angle is at most \a limit. */
inline Eigen::Vector2d
drawTurn(RandomGenerator& generator, double limit)
{
  const double t = drawWithin(generator, {-limit, limit});
  return Eigen::Vector2d{1.0 - t * t, 2.0 * t} / (1.0 + t * t);
}

/** \brief Keeps \a wanted of the items, at most all, each as likely as any other, in
 *  their order. */
template <typename Item>
void
thin(std::vector<Item>& items, std::size_t wanted, RandomGenerator& generator)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; kept < wanted; ++i)
    if (drawBelow(generator, items.size() - i) < wanted - kept)
      items[kept++] = items[i];
  items.resize(wanted);
}

} // namespace pcl_cid::test
