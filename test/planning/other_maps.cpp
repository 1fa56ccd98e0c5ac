/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Maps that other people would make of a scan.
 */

#include "other_maps.h"

#include <octomap/OcTree.h>
#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/gp3.h>

namespace planning {
namespace {

pcl::PointCloud<pcl::PointNormal>::Ptr
withNormals(const Cloud::ConstPtr& scan)
{
  constexpr int neighbors = 20;
  pcl::NormalEstimation<pcl::PointXYZ, pcl::PointNormal> estimation;
  estimation.setInputCloud(scan);
  estimation.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setKSearch(neighbors);
  auto points = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  estimation.compute(*points);
  for (std::size_t i = 0; i < points->size(); ++i)
    (*points)[i].getVector3fMap() = (*scan)[i].getVector3fMap();
  return points;
}

} // namespace

std::vector<pcl::Vertices>
triangulate(const Cloud::ConstPtr& scan)
{
  // The settings of PCL's tutorial, and edges of up to 10 cm.
  pcl::GreedyProjectionTriangulation<pcl::PointNormal> triangulation;
  triangulation.setSearchRadius(0.1);
  triangulation.setMu(2.5);
  triangulation.setMaximumNearestNeighbors(100);
  triangulation.setMaximumSurfaceAngle(M_PI / 4.0);
  triangulation.setMinimumAngle(M_PI / 18.0);
  triangulation.setMaximumAngle(2.0 * M_PI / 3.0);
  triangulation.setNormalConsistency(false);
  triangulation.setSearchMethod(
      pcl::make_shared<pcl::search::KdTree<pcl::PointNormal>>());
  triangulation.setInputCloud(withNormals(scan));
  std::vector<pcl::Vertices> triangles;
  triangulation.reconstruct(triangles);
  return triangles;
}

Shape
triangleShape(const Cloud& scan, const std::vector<pcl::Vertices>& triangles)
{
  std::vector<fcl::Vector3d> vertices;
  vertices.reserve(scan.size());
  for (const pcl::PointXYZ& point : scan)
    vertices.push_back(point.getVector3fMap().cast<double>());
  std::vector<fcl::Triangle> faces;
  faces.reserve(triangles.size());
  for (const pcl::Vertices& triangle : triangles) {
    const auto corner = [&triangle](std::size_t i) {
      return static_cast<std::size_t>(triangle.vertices[i]);
    };
    faces.emplace_back(corner(0), corner(1), corner(2));
  }
  const auto mesh = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  mesh->beginModel(static_cast<int>(faces.size()), static_cast<int>(vertices.size()));
  mesh->addSubModel(vertices, faces);
  mesh->endModel();
  return mesh;
}

Shape
octreeShape(const Cloud& scan, double cell)
{
  const auto tree = std::make_shared<octomap::OcTree>(cell);
  constexpr bool occupied = true;
  constexpr bool inner_nodes_later = true;
  for (const pcl::PointXYZ& point : scan)
    tree->updateNode(
        octomap::point3d(point.x, point.y, point.z), occupied, inner_nodes_later);
  tree->updateInnerOccupancy();
  tree->prune();
  return std::make_shared<fcl::OcTreed>(tree);
}

} // namespace planning
