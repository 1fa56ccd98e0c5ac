/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex hulls by pcl::ConvexHull, which no other file knows of.
 */

#include "parallel_for.h"
#include "validation.h"

#include <pcl_cid/core/convex_part.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/surface/convex_hull.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

/** The principal axes of a part and its extent along each. */
struct PrincipalBox {
  Eigen::Vector3d centre;
  Eigen::Matrix3d axes; ///< columns, a right-handed basis
  Eigen::Vector3d extents;
};

bool
lexicographicallyLess(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
}

std::vector<Eigen::Vector3d>
distinctPoints(const Points& points, const pcl::Indices& members)
{
  std::vector<Eigen::Vector3d> distinct;
  distinct.reserve(members.size());
  for (const pcl::index_t member : members)
    distinct.push_back(points[static_cast<std::size_t>(member)].cast<double>());
  std::sort(distinct.begin(), distinct.end(), lexicographicallyLess);
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  return distinct;
}

PrincipalBox
principalBox(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points)
    mean += p;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points)
    covariance += (p - mean) * (p - mean).transpose();

  PrincipalBox box;
  box.axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
  box.axes.col(2) = box.axes.col(0).cross(box.axes.col(1));
  Eigen::AlignedBox3d local;
  for (const Eigen::Vector3d& p : points)
    local.extend((box.axes.transpose() * (p - mean)).eval());
  box.centre = mean + box.axes * local.center();
  box.extents = local.sizes();
  return box;
}

/** PCL's points are float: below this share of its size, a thin part would be flat
 *  again after rounding. */
double
feasibleThickness(const PrincipalBox& box, double min_thickness)
{
  return std::max(min_thickness, 1e-5 * box.extents.norm());
}

/** Widen the points along a direction by as much as is missing there, half to either
 *  side: the hull then contains them, is as thick as asked, and symmetric about
 *  them. */
void
widen(std::vector<Eigen::Vector3d>& points,
      const Eigen::Vector3d& direction,
      double missing)
{
  const Eigen::Vector3d shift = 0.5 * missing * direction;
  const std::size_t count = points.size();
  points.reserve(2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(points[i] + shift);
    points[i] -= shift;
  }
}

/** Thicken along the principal axes, so that qhull gets points that fill space. */
void
thicken(std::vector<Eigen::Vector3d>& points, const PrincipalBox& box, double thickness)
{
  for (int axis = 0; axis < 3; ++axis)
    if (box.extents[axis] < thickness)
      widen(points, box.axes.col(axis), thickness - box.extents[axis]);
}

/** The hull by qhull; no triangles when qhull fails. */
TriangleMesh
hullByQhull(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& centre)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->reserve(points.size());
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3f local = (p - centre).cast<float>();
    cloud->emplace_back(local.x(), local.y(), local.z());
  }
  pcl::ConvexHull<pcl::PointXYZ> hull;
  hull.setInputCloud(cloud);
  hull.setDimension(3);
  pcl::PointCloud<pcl::PointXYZ> vertices;
  std::vector<pcl::Vertices> polygons;
  hull.reconstruct(vertices, polygons);

  TriangleMesh mesh;
  for (const pcl::PointXYZ& v : vertices)
    mesh.vertices.push_back(v.getVector3fMap().cast<double>() + centre);
  for (const pcl::Vertices& polygon : polygons)
    mesh.triangles.push_back({static_cast<std::uint32_t>(polygon.vertices.at(0)),
                              static_cast<std::uint32_t>(polygon.vertices.at(1)),
                              static_cast<std::uint32_t>(polygon.vertices.at(2))});
  return mesh;
}

/** The box itself, at least \a min_thickness wide. */
TriangleMesh
boxMesh(const PrincipalBox& box, double min_thickness)
{
  const Eigen::Vector3d half = 0.5 * box.extents.cwiseMax(min_thickness);
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d side(
        corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
    mesh.vertices.push_back(box.centre + box.axes * side.cwiseProduct(half));
  }
  mesh.triangles = {{0, 2, 1},
                    {1, 2, 3},
                    {4, 5, 6},
                    {5, 7, 6},
                    {0, 1, 4},
                    {1, 5, 4},
                    {2, 6, 3},
                    {3, 6, 7},
                    {0, 4, 2},
                    {2, 4, 6},
                    {1, 3, 5},
                    {3, 7, 5}};
  return mesh;
}

/** Twice the area of a triangle along its normal. */
Eigen::Vector3d
doubleAreaNormal(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle)
{
  const Eigen::Vector3d& a = mesh.vertices[triangle[0]];
  return (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a);
}

Eigen::Vector3d
meanVertex(const TriangleMesh& mesh)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : mesh.vertices)
    mean += v;
  return mean / static_cast<double>(mesh.vertices.size());
}

void
orientOutward(TriangleMesh& mesh)
{
  const Eigen::Vector3d inside = meanVertex(mesh);
  for (auto& triangle : mesh.triangles)
    if (doubleAreaNormal(mesh, triangle).dot(mesh.vertices[triangle[0]] - inside) < 0.0)
      std::swap(triangle[1], triangle[2]);
}

/** The direction in which a hull is thinnest, among its face normals. */
struct Width {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  double width = std::numeric_limits<double>::infinity();
};

Width
leastWidth(const TriangleMesh& hull)
{
  Width least;
  for (const auto& triangle : hull.triangles) {
    const Eigen::Vector3d normal = doubleAreaNormal(hull, triangle);
    if (normal.norm() == 0.0)
      continue;
    const Eigen::Vector3d direction = normal.normalized();
    double width = 0.0;
    for (const Eigen::Vector3d& v : hull.vertices)
      width = std::max(width, direction.dot(hull.vertices[triangle[0]] - v));
    if (width < least.width)
      least = {direction, width};
  }
  return least;
}

/** Make the hull of a part, thickened until no face normal sees less than asked; no
 *  triangles when qhull fails. Each round makes one more direction thick and none
 * thinner; a handful are enough. */
void
makeThickHull(std::vector<Eigen::Vector3d> points,
              const PrincipalBox& box,
              double thickness,
              ConvexPart& part)
{
  constexpr int most_rounds = 20;
  part.thickened = box.extents.minCoeff() < thickness;
  thicken(points, box, thickness);
  part.hull = hullByQhull(points, box.centre);
  for (int round = 0; round < most_rounds && !part.hull.triangles.empty(); ++round) {
    orientOutward(part.hull);
    const Width least = leastWidth(part.hull);
    if (least.width >= thickness * (1.0 - 1e-5))
      return;
    part.thickened = true;
    points = part.hull.vertices;
    widen(points, least.direction, thickness * (1.0 + 1e-6) - least.width);
    part.hull = hullByQhull(points, box.centre);
  }
  part.hull = TriangleMesh();
}

/** Volume, area and thickness of the part's hull. */
void
measure(ConvexPart& part)
{
  const TriangleMesh& hull = part.hull;
  const Eigen::Vector3d inside = meanVertex(hull);
  for (const auto& triangle : hull.triangles) {
    const Eigen::Vector3d normal = doubleAreaNormal(hull, triangle);
    part.area += 0.5 * normal.norm();
    part.volume += normal.dot(hull.vertices[triangle[0]] - inside) / 6.0;
  }
  part.thickness = leastWidth(hull).width;
}

/** Back to the frame of the input cloud. */
void
translate(TriangleMesh& mesh, const Eigen::Vector3d& origin)
{
  for (Eigen::Vector3d& v : mesh.vertices)
    v += origin;
}

} // namespace

ConvexPart
makeConvexPart(const PointSet& points,
               const pcl::Indices& members,
               const ConvexPartOptions& options)
{
  if (members.empty())
    throw CIDException("a convex part has no point; at least 1 is needed");
  if (!(options.min_thickness > 0.0))
    throw CIDException(sentence("the minimum thickness is ",
                                options.min_thickness,
                                "; it must be above 0 metres"));
  ConvexPart part;
  for (const pcl::index_t member : members)
    part.indices.push_back(points.source[static_cast<std::size_t>(member)]);
  std::sort(part.indices.begin(), part.indices.end());

  const std::vector<Eigen::Vector3d> distinct = distinctPoints(points.points, members);
  const PrincipalBox box = principalBox(distinct);
  const double thickness = feasibleThickness(box, options.min_thickness);
  makeThickHull(distinct, box, thickness, part);
  part.boxed = part.hull.triangles.empty();
  if (part.boxed) {
    part.hull = boxMesh(box, thickness);
    orientOutward(part.hull);
  }
  measure(part);
  translate(part.hull, points.origin);
  return part;
}

std::vector<ConvexPart>
makeConvexParts(const PointSet& points,
                const std::vector<int>& part,
                const ConvexPartOptions& options,
                const ExecutionOptions& execution)
{
  std::vector<pcl::Indices> members;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part[i] < 0)
      continue;
    const auto number = static_cast<std::size_t>(part[i]);
    members.resize(std::max(members.size(), number + 1));
    members[number].push_back(static_cast<pcl::index_t>(i));
  }
  std::vector<ConvexPart> parts(members.size());
  Progress progress(execution.progress);
  parallelFor(parts.size(),
              1,
              threadCount(execution.threads),
              progress,
              {0.0, 1.0},
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end; ++k)
                  parts[k] = makeConvexPart(points, members[k], options);
              });
  return parts;
}

} // namespace pcl_cid
