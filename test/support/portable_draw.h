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

} // namespace pcl_cid::test
