/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex hulls by qhull, which no other file knows of. Unlike pcl::ConvexHull, it tells
 * want of memory from points that have no hull.
 */

#include "quick_hull.h"

#include "hull_mesh.h"
#include "principal_box.h"

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <limits>
#include <memory>
#include <new>
#include <utility>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

extern "C" {
#include <libqhull_r/libqhull_r.h>
}

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

/** A run of qhull, whose memory goes with it. */
class Qhull {
public:
  Qhull() { qh_zero(&state_, messages()); }

  ~Qhull()
  {
    qh_freeqhull(&state_, !qh_ALL);
    int blocks_left = 0;
    int bytes_left = 0;
    qh_memfreeshort(&state_, &blocks_left, &bytes_left);
  }

  Qhull(const Qhull&) = delete;
  Qhull&
  operator=(const Qhull&) = delete;

  /** \return whether there is a hull, now of triangles
   *  \throws std::bad_alloc */
  bool
  run(std::vector<coordT>& coordinates)
  {
    char command[] = "qhull ";
    const int count = static_cast<int>(coordinates.size() / 3);
    int error = qh_new_qhull(
        &state_, 3, count, coordinates.data(), False, command, nullptr, messages());
    if (error == 0)
      error = triangulate(&state_);
    if (error == qh_ERRmem)
      throw std::bad_alloc();
    return error == 0;
  }

  /** \brief Its vertices and triangles, where there is a hull. */
  TriangleMesh
  mesh(const Cloud& cloud)
  {
    qhT* const qh = &state_; // the macros of qhull know it by this name
    TriangleMesh mesh;
    std::vector<std::uint32_t> number(qh->vertex_id + 1);
    vertexT* vertex = nullptr;
    FORALLvertices
    {
      number[vertex->id] = static_cast<std::uint32_t>(mesh.vertices.size());
      const auto point = static_cast<std::size_t>(qh_pointid(qh, vertex->point));
      mesh.vertices.push_back(cloud[point].getVector3fMap().cast<double>());
    }
    facetT* facet = nullptr;
    FORALLfacets
    {
      Triangle triangle{};
      int vertex_n = 0;
      int vertex_i = 0;
      FOREACHvertex_i_(qh, facet->vertices)
          triangle.at(static_cast<std::size_t>(vertex_i)) = number[vertex->id];
      mesh.triangles.push_back(triangle);
    }
    return mesh;
  }

private:
  /** qh_triangulate() leaves by a long jump when it fails.
   *  \return qhull's number of the error, or 0 */
  static int
  triangulate(qhT* qh)
  {
    const int error = setjmp(qh->errexit);
    if (error == 0) {
      qh->NOerrexit = False;
      qh_triangulate(qh);
    }
    qh->NOerrexit = True;
    return error;
  }

  /** Where its explanations go: to nobody. */
  std::FILE*
  messages() const
  {
    return nobody_ ? nobody_.get() : stderr;
  }

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> nobody_{std::fopen("/dev/null", "we"),
                                                          std::fclose};
  qhT state_{};
};

std::vector<coordT>
coordinatesOf(const Cloud& cloud)
{
  std::vector<coordT> coordinates;
  coordinates.reserve(3 * cloud.size());
  for (const pcl::PointXYZ& p : cloud)
    coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  return coordinates;
}

} // namespace

TriangleMesh
quickHull(const std::vector<Eigen::Vector3d>& points)
{
  const PrincipalBox box = principalBox(points);
  const Cloud::Ptr cloud = scaledCloud(points, box);
  if (!fillsSpace(*cloud))
    return {};
  std::vector<coordT> coordinates = coordinatesOf(*cloud);
  Qhull qhull;
  if (!qhull.run(coordinates))
    return {};

  // Scaled, the triangles are well-shaped: that is where to see which way they face.
  TriangleMesh mesh = qhull.mesh(*cloud);
  orientOutward(mesh);
  const Eigen::Vector3d units = unitsOf(box);
  for (Eigen::Vector3d& v : mesh.vertices)
    v = box.fromLocal(v.cwiseProduct(units));
  return mesh;
}

} // namespace pcl_cid
