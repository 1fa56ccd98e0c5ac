/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Regions of a surface where normals are alike, by region growing.
 */

#include "smooth_regions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace pcl_cid {
namespace {

/** The cosine of 8 degrees. */
constexpr double least_cosine = 0.99026806874157036;

/** The points, the flattest first. */
std::vector<std::size_t>
flattestFirst(const std::vector<float>& curvatures)
{
  std::vector<std::size_t> order(curvatures.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) {
    return std::tie(curvatures[p], p) < std::tie(curvatures[q], q);
  });
  return order;
}

/** Whether two normals, whose signs mean nothing, are alike. */
bool
areAlike(const Eigen::Vector3f& a, const Eigen::Vector3f& b)
{
  if (a.isZero(0.0f) && b.isZero(0.0f))
    return true;
  return std::abs(a.cast<double>().dot(b.cast<double>())) >= least_cosine;
}

/** All points that a region reaches from its first one, that one included. */
std::size_t
growRegion(const SurfaceGraph& graph,
           const std::vector<Eigen::Vector3f>& normals,
           std::size_t first,
           pcl::index_t number,
           Progress& progress,
           std::vector<pcl::index_t>& region)
{
  std::vector<std::size_t> reached = {first};
  region[first] = number;
  for (std::size_t k = 0; k < reached.size(); ++k) {
    progress.poll();
    graph.forEachEdge(graph.vertexOf(reached[k]), [&](SurfaceGraph::Vertex vertex) {
      const std::size_t q = graph.pointOf(vertex);
      if (region[q] >= 0 || !areAlike(normals[first], normals[q]))
        return;
      region[q] = number;
      reached.push_back(q);
    });
  }
  return reached.size();
}

} // namespace

SmoothRegions
growRegions(const SurfaceGraph& graph, const SurfaceShape& shape, Progress& progress)
{
  SmoothRegions regions;
  regions.of_points.assign(graph.size(), -1);
  for (const std::size_t first : flattestFirst(shape.curvatures)) {
    if (regions.of_points[first] >= 0)
      continue;
    regions.sizes.push_back(growRegion(graph,
                                       shape.normals,
                                       first,
                                       static_cast<pcl::index_t>(regions.sizes.size()),
                                       progress,
                                       regions.of_points));
  }
  return regions;
}

SmoothRegions
largestRegions(const SmoothRegions& regions, std::size_t most)
{
  std::vector<std::size_t> order(regions.sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return regions.sizes[a] > regions.sizes[b];
  });
  order.resize(std::min(order.size(), most));
  std::vector<pcl::index_t> place(regions.sizes.size(), -1);
  SmoothRegions largest;
  for (const std::size_t region : order) {
    place[region] = static_cast<pcl::index_t>(largest.sizes.size());
    largest.sizes.push_back(regions.sizes[region]);
  }
  largest.of_points.reserve(regions.of_points.size());
  for (const pcl::index_t region : regions.of_points)
    largest.of_points.push_back(place[static_cast<std::size_t>(region)]);
  return largest;
}

} // namespace pcl_cid
