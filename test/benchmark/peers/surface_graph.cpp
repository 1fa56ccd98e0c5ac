/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points with normals in a graph of neighbors.
 */

#include "surface_graph.h"

#include <algorithm>

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

namespace pcl_cid::benchmarks {
namespace {

/** How far above a tangent plane a neighbor may be and still count as in it: the sine
 *  of the angle. */
constexpr float flat = 0.01f;

double
weightOf(Bend bend)
{
  switch (bend) {
  case Bend::convex:
    return 0.95;
  case Bend::concave:
    return 0.01;
  case Bend::unclear:
    return 0.5;
  }
  return 0.0;
}

} // namespace

Bend
bendBetween(const OrientedPoints& surface, std::size_t first, std::size_t second)
{
  const Eigen::Vector3f way =
      (surface.points[second] - surface.points[first]).normalized();
  const bool second_above = surface.normals[first].dot(way) > flat;
  const bool first_above = surface.normals[second].dot(-way) > flat;
  if (second_above && first_above)
    return Bend::concave;
  return second_above || first_above ? Bend::unclear : Bend::convex;
}

std::vector<std::vector<int>>
nearestNeighbors(const std::vector<Eigen::Vector3f>& points, int neighbors)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector3f& p : points)
    cloud->push_back(pcl::PointXYZ(p.x(), p.y(), p.z()));
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);

  std::vector<std::vector<int>> near(points.size());
  pcl::Indices found;
  std::vector<float> squared;
  for (std::size_t i = 0; i < points.size(); ++i) {
    tree.nearestKSearch((*cloud)[i], neighbors + 1, found, squared); // itself, too
    for (const pcl::index_t j : found)
      if (static_cast<std::size_t>(j) != i) {
        near[i].push_back(j);
        near[static_cast<std::size_t>(j)].push_back(static_cast<int>(i));
      }
  }
  for (std::vector<int>& list : near) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return near;
}

Graph
weighByBend(const OrientedPoints& surface,
            const std::vector<std::vector<int>>& neighbors)
{
  Graph graph(surface.size());
  for (std::size_t i = 0; i < surface.size(); ++i)
    for (const int to : neighbors[i]) {
      const auto j = static_cast<std::size_t>(to);
      if (surface.normals[i].dot(surface.normals[j]) >= 0.0f)
        graph[i].push_back({to, weightOf(bendBetween(surface, i, j))});
    }
  return graph;
}

} // namespace pcl_cid::benchmarks
