/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Shape diameters of a segment, and how unlike those of two segments are.
 */

#include "shape_diameter.h"

#include "euclidean_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl_cid::benchmarks {
namespace {

constexpr std::size_t bins = 10;
/** Cosine of half the opening of the cone: 60 degrees. */
constexpr float cone = 0.5f;
/** Samples of a segment: a tenth of its points, and this many at least. */
constexpr std::size_t least_samples = 100;

using Histogram = std::array<double, bins>;

/** \a values is not empty. */
Histogram
histogramOf(const std::vector<double>& values, double least, double most)
{
  Histogram share{};
  for (const double value : values) {
    const double place = most > least ? (value - least) / (most - least) : 0.0;
    const auto bin = static_cast<std::size_t>(place * static_cast<double>(bins));
    share[std::min(bin, bins - 1)] += 1.0 / static_cast<double>(values.size());
  }
  return share;
}

/** On a line: the sum of the differences of the cumulated shares. */
double
earthMoversDistance(const Histogram& first, const Histogram& second)
{
  double surplus = 0.0;
  double work = 0.0;
  for (std::size_t k = 0; k < bins; ++k) {
    surplus += first[k] - second[k];
    work += std::abs(surplus);
  }
  return work / static_cast<double>(bins - 1);
}

} // namespace

std::vector<double>
shapeDiameters(const OrientedPoints& surface, const std::vector<std::size_t>& segment)
{
  Points members;
  for (const std::size_t i : segment)
    members.push_back(surface.points[i]);
  const std::size_t count = std::max(least_samples, segment.size() / 10);
  std::vector<double> diameters;
  std::vector<double> depths;
  for (const pcl::index_t sample : sampleFarthestFirst(members, 0, count).seeds) {
    const std::size_t at = segment[static_cast<std::size_t>(sample)];
    const Eigen::Vector3f inwards = -surface.normals[at];
    depths.clear();
    for (const std::size_t i : segment) {
      const Eigen::Vector3f ray = surface.points[i] - surface.points[at];
      const float depth = ray.dot(inwards);
      if (depth > cone * ray.norm() && ray.dot(surface.normals[i]) > 0.0f)
        depths.push_back(static_cast<double>(depth));
    }
    if (depths.empty())
      continue;
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), middle, depths.end());
    diameters.push_back(*middle);
  }
  return diameters;
}

Eigen::MatrixXd
histogramDistances(const std::vector<std::vector<double>>& values)
{
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  for (const std::vector<double>& set : values)
    for (const double value : set) {
      least = std::min(least, value);
      most = std::max(most, value);
    }
  const auto size = static_cast<Eigen::Index>(values.size());
  Eigen::MatrixXd distances = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t a = 0; a < values.size(); ++a)
    for (std::size_t b = a + 1; b < values.size(); ++b) {
      if (values[a].empty() || values[b].empty())
        continue;
      const double distance = earthMoversDistance(histogramOf(values[a], least, most),
                                                  histogramOf(values[b], least, most));
      distances(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) = distance;
      distances(static_cast<Eigen::Index>(b), static_cast<Eigen::Index>(a)) = distance;
    }
  return distances;
}

} // namespace pcl_cid::benchmarks
