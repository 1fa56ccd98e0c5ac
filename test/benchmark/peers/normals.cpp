/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Normals, as a user of PCL estimates and orients them.
 */

#include "normals.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <tuple>

#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>

#include <Eigen/Geometry>

namespace pcl_cid::benchmarks {
namespace {

using Vectors = std::vector<Eigen::Vector3f>;

/** Points seen on a patch of unit size, up to a factor; the sign is that of the side.
 */
float
seenFrom(const Eigen::Vector3f& viewpoint,
         const Eigen::Vector3f& point,
         const Eigen::Vector3f& normal)
{
  const Eigen::Vector3f ray = viewpoint - point;
  const float squared = ray.squaredNorm();
  return squared == 0.0f ? 0.0f : normal.dot(ray) / (squared * std::sqrt(squared));
}

void
lookAtViewpoints(const Vectors& points, const Vectors& viewpoints, Vectors& normals)
{
  for (std::size_t i = 0; i < points.size(); ++i) {
    float most = 0.0f;
    for (const Eigen::Vector3f& viewpoint : viewpoints) {
      const float seen = seenFrom(viewpoint, points[i], normals[i]);
      if (std::abs(seen) > std::abs(most))
        most = seen;
    }
    if (most < 0.0f)
      normals[i] = -normals[i];
  }
}

Eigen::Vector3f
centerOf(const Vectors& points)
{
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& point : points)
    box.extend(point);
  return box.center();
}

/** Prim's algorithm; an edge costs what the normals turn along it. */
void
followTree(const Vectors& points,
           const std::vector<std::vector<int>>& graph,
           Vectors& normals)
{
  std::vector<int> from_top(points.size());
  std::iota(from_top.begin(), from_top.end(), 0);
  std::stable_sort(from_top.begin(), from_top.end(), [&](int a, int b) {
    return points[static_cast<std::size_t>(a)].z() >
           points[static_cast<std::size_t>(b)].z();
  });
  std::vector<char> done(points.size(), 0);
  using Step = std::tuple<float, int, int>; // cost, to, from
  std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
  const auto visit = [&](int i) {
    done[static_cast<std::size_t>(i)] = 1;
    for (const int to : graph[static_cast<std::size_t>(i)])
      if (!done[static_cast<std::size_t>(to)])
        open.emplace(1.0f - std::abs(normals[static_cast<std::size_t>(i)].dot(
                                normals[static_cast<std::size_t>(to)])),
                     to,
                     i);
  };
  for (const int root : from_top) {
    if (done[static_cast<std::size_t>(root)])
      continue;
    Eigen::Vector3f& top = normals[static_cast<std::size_t>(root)];
    if (top.z() < 0.0f)
      top = -top;
    visit(root);
    while (!open.empty()) {
      const auto [cost, to, from] = open.top();
      open.pop();
      if (done[static_cast<std::size_t>(to)])
        continue;
      Eigen::Vector3f& normal = normals[static_cast<std::size_t>(to)];
      if (normal.dot(normals[static_cast<std::size_t>(from)]) < 0.0f)
        normal = -normal;
      visit(to);
    }
  }
}

} // namespace

pcl::PointCloud<pcl::Normal>::Ptr
estimateNormals(const Cloud::ConstPtr& cloud, int neighbors)
{
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setKSearch(neighbors);
  auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  estimation.compute(*normals);
  return normals;
}

void
orientNormals(const Vectors& points,
              const std::vector<std::vector<int>>& graph,
              const Vectors& viewpoints,
              Orientation orientation,
              Vectors& normals)
{
  switch (orientation) {
  case Orientation::viewpoint:
    return lookAtViewpoints(points, viewpoints, normals);
  case Orientation::center:
    return lookAtViewpoints(points, {centerOf(points)}, normals);
  case Orientation::tree:
    return followTree(points, graph, normals);
  }
}

} // namespace pcl_cid::benchmarks
