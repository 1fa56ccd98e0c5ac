/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex hulls without degenerate triangles.
 */

#include "clean_hull.h"

#include "hull_mesh.h"
#include "quick_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace pcl_cid {
namespace {

using Vertices = std::vector<Eigen::Vector3d>;

/** The side of a triangle that is longest: its number. */
std::size_t
longestSide(const TriangleMesh& mesh, const Triangle& triangle)
{
  std::array<double, 3> squared_length{};
  for (std::size_t k = 0; k < 3; ++k)
    squared_length[k] =
        (mesh.vertices[triangle[(k + 1) % 3]] - mesh.vertices[triangle[k]])
            .squaredNorm();
  return static_cast<std::size_t>(
      std::max_element(squared_length.begin(), squared_length.end()) -
      squared_length.begin());
}

/** For each vertex, whether it is between two others in a triangle that is too low. Of
 *  a triangle, one vertex at a time: the two that it lies between stay. */
std::vector<bool>
verticesToDrop(const TriangleMesh& mesh, double least_height)
{
  std::vector<bool> drop(mesh.vertices.size(), false);
  std::vector<bool> keep(mesh.vertices.size(), false);
  for (const Triangle& triangle : mesh.triangles) {
    const std::size_t side = longestSide(mesh, triangle);
    const std::uint32_t a = triangle[side];
    const std::uint32_t b = triangle[(side + 1) % 3];
    const std::uint32_t between = triangle[(side + 2) % 3];
    const double length = (mesh.vertices[b] - mesh.vertices[a]).norm();
    const double double_area = doubleAreaNormal(mesh, triangle).norm();
    if (double_area >= least_height * length || drop[a] || drop[b] || keep[between])
      continue;
    drop[between] = true;
    keep[a] = keep[b] = true;
  }
  return drop;
}

/** The vertices that are not to be dropped; the others join those dropped before. */
Vertices
splitOff(const std::vector<bool>& drop, const Vertices& vertices, Vertices& dropped)
{
  Vertices kept;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    (drop[i] ? dropped : kept).push_back(vertices[i]);
  return kept;
}

bool
contains(const TriangleMesh& hull, const Vertices& points, double tolerance)
{
  const std::vector<HalfSpace> faces = halfSpacesOf(hull);
  return std::all_of(points.begin(), points.end(), [&](const Eigen::Vector3d& p) {
    return isInside(faces, p, tolerance);
  });
}

/** Points that qhull found in the inside of a flat face belong to no triangle. */
void
dropUnusedVertices(TriangleMesh& mesh)
{
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t v : triangle)
      used[v] = true;
  std::vector<std::uint32_t> number(mesh.vertices.size());
  Vertices vertices;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) {
      number[v] = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(mesh.vertices[v]);
    }
  mesh.vertices = std::move(vertices);
  for (Triangle& triangle : mesh.triangles)
    for (std::uint32_t& v : triangle)
      v = number[v];
}

} // namespace

TriangleMesh
convexHull(const Vertices& points)
{
  constexpr int most_rounds = 20;
  TriangleMesh hull = quickHull(points);
  const double diagonal = diagonalOf(hull);
  Vertices dropped;
  for (int round = 0; round < most_rounds && !hull.triangles.empty(); ++round) {
    const std::vector<bool> drop =
        verticesToDrop(hull, least_triangle_height * diagonal);
    if (std::find(drop.begin(), drop.end(), true) == drop.end()) {
      dropUnusedVertices(hull);
      const bool is_right = !edgesOf(hull).empty() &&
                            contains(hull, dropped, 0.5 * hull_tolerance * diagonal);
      return is_right ? hull : TriangleMesh();
    }
    hull = quickHull(splitOff(drop, hull.vertices, dropped));
  }
  return {};
}

} // namespace pcl_cid
