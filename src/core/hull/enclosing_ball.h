/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Small balls and circles around points.
 */

#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief A ball, or a circle. */
template <int Dimension>
struct Ball {
  Eigen::Matrix<double, Dimension, 1> center;
  double radius;
};

/** \brief A ball around points, about the smallest: the center goes to the farthest
 *  point by ever smaller shares of the way (Badoiu and Clarkson 2003).
 *  \param[in] points at least 1
 *  \param[in] steps the radius is too large by about a share of 1 / steps, or less */
template <int Dimension>
Ball<Dimension>
enclosingBall(const std::vector<Eigen::Matrix<double, Dimension, 1>>& points, int steps)
{
  using Point = Eigen::Matrix<double, Dimension, 1>;
  const auto farthestFrom = [&](const Point& center) -> const Point& {
    return *std::max_element(
        points.begin(), points.end(), [&](const Point& a, const Point& b) {
          return (a - center).squaredNorm() < (b - center).squaredNorm();
        });
  };
  Ball<Dimension> ball = {points.front(), 0.0};
  ball.radius = (farthestFrom(ball.center) - ball.center).norm();
  Point center = ball.center;
  for (int step = 1; step <= steps; ++step) {
    center += (farthestFrom(center) - center) / (step + 1.0);
    const double radius = (farthestFrom(center) - center).norm();
    if (radius < ball.radius)
      ball = {center, radius};
  }
  return ball;
}

} // namespace pcl_cid
