/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex hulls by pcl::ConvexHull, which no other file knows of.
 */

#include "quick_hull.h"

#include "hull_mesh.h"
#include "principal_box.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/surface/convex_hull.h>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** Half the extents, by which coordinates are scaled to -1 ... 1. */
Eigen::Vector3d
unitsOf(const PrincipalBox& box)
{
  return (0.5 * box.extents).cwiseMax(std::numeric_limits<double>::min());
}

Cloud::Ptr
scaledCloud(const std::vector<Eigen::Vector3d>& points, const PrincipalBox& box)
{
  const Eigen::Vector3d units = unitsOf(box);
  const auto cloud = pcl::make_shared<Cloud>();
  cloud->reserve(points.size());
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3f scaled = box.toLocal(p).cwiseQuotient(units).cast<float>();
    cloud->emplace_back(scaled.x(), scaled.y(), scaled.z());
  }
  return cloud;
}

/** The point of a cloud at which a function is largest. */
template <typename Function>
Eigen::Vector3f
farthest(const Cloud& cloud, const Function& function)
{
  return std::max_element(cloud.begin(),
                          cloud.end(),
                          [&](const pcl::PointXYZ& a, const pcl::PointXYZ& b) {
                            return function(a.getVector3fMap()) <
                                   function(b.getVector3fMap());
                          })
      ->getVector3fMap();
}

/** Whether the points fill space: a simplex of extreme ones is not flat. */
bool
fillsSpace(const Cloud& cloud)
{
  constexpr float flat = 1e-6f;
  const Eigen::Vector3f a = farthest(cloud, [](const auto& p) { return p.x(); });
  const Eigen::Vector3f b =
      farthest(cloud, [&](const auto& p) { return (p - a).squaredNorm(); });
  if (!((b - a).norm() > flat))
    return false;
  const Eigen::Vector3f line = (b - a).normalized();
  const auto off_line = [&](const auto& p) { return (p - a).cross(line).norm(); };
  const Eigen::Vector3f c = farthest(cloud, off_line);
  if (!(off_line(c) > flat))
    return false;
  const Eigen::Vector3f normal = (c - a).cross(line).normalized();
  const auto off_plane = [&](const auto& p) { return std::abs((p - a).dot(normal)); };
  return off_plane(farthest(cloud, off_plane)) > flat;
}

void
orientOutward(TriangleMesh& mesh)
{
  Eigen::Vector3d inside = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : mesh.vertices)
    inside += v / static_cast<double>(mesh.vertices.size());
  for (Triangle& triangle : mesh.triangles)
    if (doubleAreaNormal(mesh, triangle).dot(mesh.vertices[triangle[0]] - inside) < 0.0)
      std::swap(triangle[1], triangle[2]);
}

/** Vertices and triangles by PCL; none when qhull fails. */
struct Hull {
  Cloud vertices;
  std::vector<pcl::Vertices> triangles;

  explicit Hull(const Cloud::Ptr& cloud)
  {
    pcl::ConvexHull<pcl::PointXYZ> hull;
    hull.setInputCloud(cloud);
    hull.setDimension(3);
    hull.reconstruct(vertices, triangles);
  }
};

/** qhull fails in silence when memory lacks, too, and that must not become another
 *  hull. It is asked again, after memory is asked for, which throws when there is none.
 */
Hull
hullOf(const Cloud::Ptr& cloud)
{
  Hull hull(cloud);
  if (!hull.triangles.empty())
    return hull;
  constexpr std::size_t bytes_for_a_point = 1000;
  ::operator delete(::operator new(bytes_for_a_point * cloud->size()));
  return Hull(cloud);
}

} // namespace

TriangleMesh
quickHull(const std::vector<Eigen::Vector3d>& points)
{
  const PrincipalBox box = principalBox(points);
  const Cloud::Ptr cloud = scaledCloud(points, box);
  if (!fillsSpace(*cloud))
    return {};
  const Hull hull = hullOf(cloud);

  // Scaled, the triangles are well-shaped: that is where to see which way they face.
  TriangleMesh mesh;
  for (const pcl::PointXYZ& v : hull.vertices)
    mesh.vertices.push_back(v.getVector3fMap().cast<double>());
  for (const pcl::Vertices& polygon : hull.triangles)
    mesh.triangles.push_back({static_cast<std::uint32_t>(polygon.vertices.at(0)),
                              static_cast<std::uint32_t>(polygon.vertices.at(1)),
                              static_cast<std::uint32_t>(polygon.vertices.at(2))});
  orientOutward(mesh);
  const Eigen::Vector3d units = unitsOf(box);
  for (Eigen::Vector3d& v : mesh.vertices)
    v = box.fromLocal(v.cwiseProduct(units));
  return mesh;
}

} // namespace pcl_cid
