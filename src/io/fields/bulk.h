/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Where most of many values are.
 */

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace pcl_cid {

/** \brief Where most values are: single ones astray have no say in it. */
struct Bulk {
  double middle = 0.0; ///< the median
  double extent = 0.0; ///< how far apart the middle 90 percent are
};

/** \brief Every so many values are a sample of about 10,000 of them, from the first. */
inline std::size_t
strideOfSample(std::size_t count)
{
  constexpr std::size_t sample_size = 10000;
  return 1 + count / sample_size;
}

/** \brief The bulk of finite values. */
inline Bulk
bulkOfSample(std::vector<double> sample)
{
  if (sample.empty()) // nothing is known to be astray
    return {0.0, std::numeric_limits<double>::infinity()};
  std::sort(sample.begin(), sample.end());
  const std::size_t last = sample.size() - 1;
  return {sample[last / 2], sample[last - last / 20] - sample[last / 20]};
}

/** \brief The bulk of values, from a sample of them.
 *  \param[in] value called as value(i); what is not finite does not count */
template <typename Value>
Bulk
bulkOf(std::size_t count, const Value& value)
{
  const std::size_t stride = strideOfSample(count);
  std::vector<double> sample;
  for (std::size_t i = 0; i < count; i += stride)
    if (const double each = value(i); std::isfinite(each))
      sample.push_back(each);
  return bulkOfSample(std::move(sample));
}

} // namespace pcl_cid
