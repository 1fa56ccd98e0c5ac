/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What points and indices must be; settings have their own table (settings.h).
 */

#pragma once

#include "sentence.h"

#include <pcl_cid/core/point_set.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

template <typename Number>
void
requireAtLeast(const char* name, Number value, Number least)
{
  if (value < least)
    throw CIDException(
        sentence("the ", name, " is ", value, "; it must be at least ", least));
}

/** A setting that the table has as an int, in a struct that counts by sizes. */
inline void
requireCount(const NumberSetting<int>& setting, std::size_t value)
{
  constexpr int largest = std::numeric_limits<int>::max();
  require(setting, static_cast<int>(std::min(value, std::size_t{largest})));
}

inline void
requireIndex(const char* name, pcl::index_t index, std::size_t count)
{
  if (index < 0 || static_cast<std::size_t>(index) >= count)
    throw CIDException(sentence(
        "the ", name, " is ", index, "; it must be 0 to ", count, " - 1 (the points)"));
}

inline void
requireFinite(const std::vector<Eigen::Vector3d>& viewpoints)
{
  for (std::size_t i = 0; i < viewpoints.size(); ++i)
    if (!viewpoints[i].allFinite())
      throw CIDException(
          sentence("viewpoint ", i, " is not finite; it must be a position"));
}

inline void
requirePoints(const Points& points)
{
  if (points.empty())
    throw CIDException("there is no finite point to work on; at least 1 is needed");
}

} // namespace pcl_cid
