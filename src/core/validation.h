/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One sentence for each value that is out of its range.
 */

#pragma once

#include <pcl_cid/core/concavity.h>
#include <pcl_cid/core/nearest_neighbors.h>
#include <pcl_cid/core/pair_cost.h>
#include <pcl_cid/exceptions.h>

#include <limits>
#include <sstream>
#include <string>

namespace pcl_cid {

template <typename... Parts>
std::string
sentence(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

template <typename Number>
void
requireAtLeast(const char* name, Number value, Number least)
{
  if (value < least)
    throw CIDException(
        sentence("the ", name, " is ", value, "; it must be at least ", least));
}

/** Refuses NaN and infinity, too. */
template <typename Number>
void
requireNotNegative(const char* name, Number value, const char* unit)
{
  if (!(value >= 0) || !(value <= std::numeric_limits<Number>::max()))
    throw CIDException(sentence(
        "the ", name, " is ", value, "; it must be a number of ", unit, ", 0 or more"));
}

inline void
requireSamples(int samples)
{
  if (samples < min_samples || samples > max_samples)
    throw CIDException(sentence("the number of samples on a segment is ",
                                samples,
                                "; it must be ",
                                min_samples,
                                " to ",
                                max_samples));
}

/** An exponent of the local spacing. */
inline void
requireDensityPower(float power)
{
  constexpr float most = 4.0f; // so that spacings stay numbers
  if (!(power >= 0.0f && power <= most))
    throw CIDException(
        sentence("the density power is ", power, "; it must be 0 to ", most));
}

inline void
requireNearNeighbors(int least)
{
  if (least < 0 || static_cast<std::size_t>(least) > NearestNeighbors::most)
    throw CIDException(sentence("the least number of near neighbours is ",
                                least,
                                "; it must be 0 to ",
                                NearestNeighbors::most));
}

inline void
requireIndex(const char* name, pcl::index_t index, std::size_t count)
{
  if (index < 0 || static_cast<std::size_t>(index) >= count)
    throw CIDException(sentence(
        "the ", name, " is ", index, "; it must be 0 to ", count, " - 1 (the points)"));
}

inline void
requireCosts(const PairCosts& costs, std::size_t points)
{
  if ((!costs.spacing.empty() && costs.spacing.size() != points) ||
      (!costs.color.empty() && costs.color.size() != points))
    throw CIDException(sentence("the costs have the spacing of ",
                                costs.spacing.size(),
                                " and the colour of ",
                                costs.color.size(),
                                " points; they must be of all ",
                                points,
                                " points, or of none"));
  for (const float spacing : costs.spacing)
    if (!(spacing > 0.0f) || !(spacing <= std::numeric_limits<float>::max()))
      throw CIDException(sentence(
          "the spacing of a point is ", spacing, "; it must be a number above 0"));
  for (const Eigen::Vector3f& color : costs.color)
    if (!color.allFinite())
      throw CIDException("the colour of a point is not a number; it must be finite");
}

inline void
requirePoints(const Points& points)
{
  if (points.empty())
    throw CIDException("there is no finite point to work on; at least 1 is needed");
}

} // namespace pcl_cid
