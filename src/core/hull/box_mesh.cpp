/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The simplest meshes around some points: a box, or a tetrahedron.
 */

#include "box_mesh.h"

namespace pcl_cid {
namespace {

TriangleMesh
cuboid()
{
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.vertices.emplace_back(
        corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
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

/** The regular tetrahedron around that cube: each face touches one of its corners. */
TriangleMesh
tetrahedron()
{
  TriangleMesh mesh;
  mesh.vertices = {
      {3.0, 3.0, 3.0}, {3.0, -3.0, -3.0}, {-3.0, 3.0, -3.0}, {-3.0, -3.0, 3.0}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  return mesh;
}

} // namespace

TriangleMesh
boxMesh(const PrincipalBox& box, std::size_t max_vertices)
{
  constexpr std::size_t corners = 8;
  const bool fits = max_vertices == 0 || max_vertices >= corners;
  TriangleMesh mesh = fits ? cuboid() : tetrahedron();
  for (Eigen::Vector3d& v : mesh.vertices)
    v = box.fromLocal(v.cwiseProduct(0.5 * box.extents));
  return mesh;
}

} // namespace pcl_cid
