/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Meshes of parts as PCL's own.
 */

#include <pcl_cid/io/polygon_mesh.h>

#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_cid {

pcl::PolygonMesh
toPolygonMesh(const TriangleMesh& mesh)
{
  pcl::PointCloud<pcl::PointXYZ> vertices;
  for (const Eigen::Vector3d& v : mesh.vertices)
    vertices.emplace_back(static_cast<float>(v.x()),
                          static_cast<float>(v.y()),
                          static_cast<float>(v.z()));
  pcl::PolygonMesh result;
  pcl::toPCLPointCloud2(vertices, result.cloud);
  for (const auto& triangle : mesh.triangles) {
    pcl::Vertices polygon;
    polygon.vertices.assign(triangle.begin(), triangle.end());
    result.polygons.push_back(polygon);
  }
  return result;
}

} // namespace pcl_cid
