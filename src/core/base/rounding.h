/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What rounding can take: the slacks that keep bounds in float certified.
 */

#pragma once

#include <limits>

namespace pcl_cid::rounding {

/** \brief Twice the largest relative error of one operation in float. */
constexpr float epsilon = std::numeric_limits<float>::epsilon();

/** \brief A norm of three differences, times this, is at least the true one: three
 *  squares, two sums, a root and the differences themselves are seven roundings, 3.5
 *  epsilon or 4.2e-7; the rest is margin. The same holds for squared norms. */
constexpr float widening = 1.00001f;

/** \brief A norm of given differences, times these, is at least and at most the true
 *  one: three squares, two sums and a root are 3 epsilon, or 3.6e-7. */
constexpr float norm_widening = 1.000002f;
constexpr float norm_narrowing = 0.999998f;

/** \brief What a distance loses where float cannot hold its square. Three squares, each
 *  off by up to 2^-150 (half the smallest number above 0), move their root by less than
 *  2^-74. Eigen, which takes many roots at a time, takes what is below the smallest
 *  normal number for 0: 2^-63. Bounds are made of a few such roots. */
constexpr float of_lost_squares = 0x1p-60f;

/** \brief How far a sample p + t (q - p), computed in float, can be from the true one,
 *  no coordinate of p and q being larger than \a largest: on each axis the difference
 *  is off by 1 epsilon of it, the product by 2, the sum by 1; that is less than 7
 *  epsilon in three dimensions, and there is as much again for the distance that is
 *  then taken. */
constexpr float
ofSample(float largest)
{
  return 16.0f * epsilon * largest + of_lost_squares;
}

/** \brief The same for two samples that are compared with each other. */
constexpr float
ofTwoSamples(float largest)
{
  return 2.0f * ofSample(largest);
}

/** \brief A product or quotient of values that are each rounded once, its square or its
 *  root, is off by less than this share: three roundings are 1.5 epsilon. */
constexpr float of_product = 4.0f * epsilon;

/** \brief A mean of bounds, each scaled and reduced, is off by less than this share. */
constexpr float of_bound = 8.0f * epsilon;

/** \brief The polynomial a + b t + c t^2 of a squared distance, t from 0 to 1: each of
 *  its terms is at most 4 (a + c), and is off by three roundings, 1.5 epsilon; what
 *  float cannot tell from 0 is at most its smallest normal number. */
constexpr float
ofSquaredDistance(float a, float c)
{
  return 16.0f * epsilon * (a + c) + std::numeric_limits<float>::min();
}

} // namespace pcl_cid::rounding
