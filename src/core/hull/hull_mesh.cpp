/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Measures of a closed triangle mesh.
 */

#include "hull_mesh.h"

#include <algorithm>
#include <tuple>

namespace pcl_cid {
namespace {

/** A directed edge of a triangle, filed under its lower vertex. */
struct DirectedEdge {
  std::uint32_t low, high;
  bool upward;
  std::uint32_t triangle;

  bool
  operator<(const DirectedEdge& other) const
  {
    return std::tie(low, high, upward) < std::tie(other.low, other.high, other.upward);
  }
};

std::vector<DirectedEdge>
directedEdges(const TriangleMesh& mesh)
{
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k];
      const std::uint32_t b = mesh.triangles[t][(k + 1) % 3];
      edges.push_back(
          {std::min(a, b), std::max(a, b), a < b, static_cast<std::uint32_t>(t)});
    }
  std::sort(edges.begin(), edges.end());
  return edges;
}

bool
samePair(const DirectedEdge& a, const DirectedEdge& b)
{
  return a.low == b.low && a.high == b.high;
}

/** Six times the volume between a triangle and a point inside. */
double
sixfoldVolume(const TriangleMesh& mesh,
              const Triangle& triangle,
              const Eigen::Vector3d& inside)
{
  return doubleAreaNormal(mesh, triangle).dot(mesh.vertices[triangle[0]] - inside);
}

} // namespace

std::vector<HalfSpace>
halfSpacesOf(const TriangleMesh& mesh)
{
  std::vector<HalfSpace> half_spaces;
  half_spaces.reserve(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    const Eigen::Vector3d normal = doubleAreaNormal(mesh, triangle).normalized();
    half_spaces.push_back({normal, normal.dot(mesh.vertices[triangle[0]])});
  }
  return half_spaces;
}

std::vector<HullEdge>
edgesOf(const TriangleMesh& mesh)
{
  const std::vector<DirectedEdge> directed = directedEdges(mesh);
  if (directed.size() % 2 != 0)
    return {};
  std::vector<HullEdge> edges;
  edges.reserve(directed.size() / 2);
  for (std::size_t i = 0; i < directed.size(); i += 2) {
    const DirectedEdge& down = directed[i];
    const DirectedEdge& up = directed[i + 1];
    const bool is_pair = samePair(down, up) && !down.upward && up.upward;
    if (!is_pair || (i > 0 && samePair(directed[i - 1], down)))
      return {};
    edges.push_back({up.low, up.high, up.triangle, down.triangle});
  }
  return edges;
}

bool
isInside(const std::vector<HalfSpace>& half_spaces,
         const Eigen::Vector3d& p,
         double tolerance)
{
  return std::all_of(
      half_spaces.begin(), half_spaces.end(), [&](const HalfSpace& half_space) {
        return half_space.excess(p) <= tolerance;
      });
}

TriangleMesh
moved(TriangleMesh mesh, const Eigen::Vector3d& shift)
{
  for (Eigen::Vector3d& v : mesh.vertices)
    v += shift;
  return mesh;
}

Eigen::AlignedBox3d
boxOf(const TriangleMesh& mesh)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices)
    box.extend(v);
  return box;
}

double
diagonalOf(const TriangleMesh& mesh)
{
  const Eigen::AlignedBox3d box = boxOf(mesh);
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

double
volumeOf(const TriangleMesh& mesh)
{
  double volume = 0.0;
  for (const Triangle& triangle : mesh.triangles)
    volume += sixfoldVolume(mesh, triangle, mesh.vertices[0]) / 6.0;
  return volume;
}

double
areaOf(const TriangleMesh& mesh)
{
  double area = 0.0;
  for (const Triangle& triangle : mesh.triangles)
    area += 0.5 * doubleAreaNormal(mesh, triangle).norm();
  return area;
}

Eigen::Vector3d
centroidOf(const TriangleMesh& mesh)
{
  const Eigen::Vector3d apex = mesh.vertices[0];
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double weight = 0.0;
  for (const Triangle& triangle : mesh.triangles) {
    const double part = sixfoldVolume(mesh, triangle, apex);
    Eigen::Vector3d corners = apex;
    for (const std::uint32_t v : triangle)
      corners += mesh.vertices[v];
    moment += part * (0.25 * corners - apex);
    weight += part;
  }
  return apex + moment / weight;
}

} // namespace pcl_cid
