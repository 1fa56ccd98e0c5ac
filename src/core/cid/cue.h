/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What makes the cost of a pair of points larger besides its CID.
 */

#pragma once

#include "field/block_tree.h"
#include <pcl_cid/core/point_set.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl_cid {

/** \brief Squared length, each square rounded on its own: it never falls when one of
 *  the differences grows, in float too. */
inline float
roundedSquare(const Eigen::Vector3f& difference)
{
  const Eigen::Vector3f squared = difference.cwiseProduct(difference);
  return (squared.x() + squared.y()) + squared.z();
}

/** \brief A property of points, three numbers each, and what it costs when two points
 *  differ in it (*ours*): symmetric to the bit, never negative, 0 for equal values. */
struct Cue {
  enum class Property {
    /** CIE L*a*b* times the weight: `|a - b|`. */
    color,
    /** A unit vector whose sign means nothing, times sqrt(weight / 2):
     *  `min(|a - b|^2, |a + b|^2)`, that is `weight (1 - |cos(a, b)|)`. */
    normal
  };

  Property property = Property::color;
  /** Of each point, scaled so that what they cost is in metres. */
  Points values;

  float
  between(std::size_t p, std::size_t q) const
  {
    const Eigen::Vector3f& a = values[p];
    const Eigen::Vector3f& b = values[q];
    if (property == Property::color)
      return std::sqrt(roundedSquare(a - b));
    return std::min(roundedSquare(a - b), roundedSquare(a + b));
  }

  /** \brief Lower bound of the cue of a point and any point whose value is in a box. */
  float
  least(const PointBox& box, std::size_t p) const
  {
    const Eigen::Array4f value = padded(values[p]);
    const float squared = roundedSquare(gap(box, value));
    return property == Property::color
               ? std::sqrt(squared)
               : std::min(squared, roundedSquare(gap(box, -value)));
  }

  /** \brief Upper bound of the same. */
  float
  most(const PointBox& box, std::size_t p) const
  {
    const Eigen::Array4f value = padded(values[p]);
    const float squared = roundedSquare(farthest(box, value));
    return property == Property::color
               ? std::sqrt(squared)
               : std::min(squared, roundedSquare(farthest(box, -value)));
  }

private:
  static Eigen::Vector3f
  gap(const PointBox& box, const Eigen::Array4f& value)
  {
    return (box.low - value).max(value - box.high).max(0.0f).matrix().head<3>();
  }

  static Eigen::Vector3f
  farthest(const PointBox& box, const Eigen::Array4f& value)
  {
    return (value - box.low).max(box.high - value).matrix().head<3>();
  }
};

} // namespace pcl_cid
