/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Whether triangles make up one closed surface, the first guarantee of a hull.
 */

#include "surface_check.h"

#include "base/sentence.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

using Verdict = std::optional<std::string>;
using Triangle = std::array<std::uint32_t, 3>;

/** How often each directed edge occurs. */
using EdgeUses = std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t>;

/** A triangle no higher than this share of the diagonal is degenerate. */
constexpr double degenerate_height = 1e-7;

Verdict
findBadVertex(const TriangleMesh& mesh)
{
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (!mesh.vertices[v].allFinite())
      return sentence("vertex ", v, " is not finite");
  std::vector<bool> used(mesh.vertices.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t]) {
      if (v >= used.size())
        return sentence(
            "triangle ", t, " names vertex ", v, "; there are ", used.size());
      used[v] = true;
    }
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused != used.end())
    return sentence("vertex ", unused - used.begin(), " is not used by any triangle");
  return {};
}

EdgeUses
edgeUses(const TriangleMesh& mesh)
{
  EdgeUses uses;
  for (const Triangle& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      ++uses[{triangle[k], triangle[(k + 1) % 3]}];
  return uses;
}

Verdict
findOpenEdge(const EdgeUses& uses)
{
  for (const auto& [edge, count] : uses) {
    const auto back = uses.find({edge.second, edge.first});
    const std::size_t count_back = back == uses.end() ? 0 : back->second;
    if (count != 1 || count_back != 1)
      return sentence("the surface is not closed: the edge from vertex ",
                      edge.first,
                      " to ",
                      edge.second,
                      " occurs ",
                      count,
                      " times, and ",
                      count_back,
                      " times in the other direction; each must be 1");
  }
  return {};
}

Verdict
findWrongShape(const TriangleMesh& mesh, const EdgeUses& uses)
{
  const std::size_t edges = uses.size() / 2;
  if (mesh.vertices.size() + mesh.triangles.size() == edges + 2)
    return {};
  return sentence("the surface is not like a sphere's: ",
                  mesh.vertices.size(),
                  " vertices - ",
                  edges,
                  " edges + ",
                  mesh.triangles.size(),
                  " triangles is not 2");
}

Verdict
findDegenerateTriangle(const TriangleMesh& mesh)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices)
    box.extend(v);
  const double least = degenerate_height * box.diagonal().norm();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    const Eigen::Vector3d a = mesh.vertices[triangle[1]] - mesh.vertices[triangle[0]];
    const Eigen::Vector3d b = mesh.vertices[triangle[2]] - mesh.vertices[triangle[1]];
    const double longest = std::max({a.norm(), b.norm(), (a + b).norm()});
    const double height = longest > 0.0 ? a.cross(b).norm() / longest : 0.0;
    if (!(height > least))
      return sentence("triangle ",
                      t,
                      " is degenerate: it is ",
                      height,
                      " metres high; it must be above ",
                      least);
  }
  return {};
}

Verdict
findInwardSurface(const TriangleMesh& mesh)
{
  double volume = 0.0;
  const Eigen::Vector3d& apex = mesh.vertices[0];
  for (const auto& [a, b, c] : mesh.triangles)
    volume += (mesh.vertices[a] - apex)
                  .dot((mesh.vertices[b] - apex).cross(mesh.vertices[c] - apex)) /
              6.0;
  if (volume > 0.0)
    return {};
  return sentence(
      "the surface is not oriented outward: its volume is ", volume, " cubic metres");
}

} // namespace

std::optional<std::string>
findBrokenSurface(const TriangleMesh& mesh)
{
  if (mesh.triangles.empty())
    return "the surface has no triangle";
  if (Verdict broken = findBadVertex(mesh))
    return broken;
  const EdgeUses uses = edgeUses(mesh);
  if (Verdict broken = findOpenEdge(uses))
    return broken;
  if (Verdict broken = findWrongShape(mesh, uses))
    return broken;
  if (Verdict broken = findDegenerateTriangle(mesh))
    return broken;
  return findInwardSurface(mesh);
}

} // namespace pcl_cid
