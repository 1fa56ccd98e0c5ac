/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Measures of a closed triangle mesh.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pcl_cid {

/** \brief Three vertices of a mesh. */
using Triangle = std::array<std::uint32_t, 3>;

/** \brief Twice the area of a triangle along its normal. */
inline Eigen::Vector3d
doubleAreaNormal(const TriangleMesh& mesh, const Triangle& triangle)
{
  const Eigen::Vector3d& a = mesh.vertices[triangle[0]];
  return (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a);
}

/** \brief The points below normal . x = offset; the normal has length 1. */
struct HalfSpace {
  Eigen::Vector3d normal;
  double offset;

  /** \brief How far a point is outside, negative inside, metres. */
  double
  excess(const Eigen::Vector3d& p) const
  {
    return normal.dot(p) - offset;
  }
};

/** \brief The half-space of each triangle. */
std::vector<HalfSpace>
halfSpacesOf(const TriangleMesh& mesh);

/** \brief Two triangles that share an edge, and the edge as the first one has it. */
struct HullEdge {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint32_t triangle;
  std::uint32_t neighbor;
};

/** \brief The edges of a mesh, each once; none at all when the mesh is not closed, that
 *  is, when not every edge occurs once in either direction. */
std::vector<HullEdge>
edgesOf(const TriangleMesh& mesh);

/** \brief Whether a point is inside of all half-spaces, or outside of none by more than
 *  \a tolerance metres; below 0 it must be so far inside. */
bool
isInside(const std::vector<HalfSpace>& half_spaces,
         const Eigen::Vector3d& p,
         double tolerance = 0.0);

/** \brief The mesh somewhere else. */
TriangleMesh
moved(TriangleMesh mesh, const Eigen::Vector3d& shift);

/** \brief The axis-aligned bounding box. */
Eigen::AlignedBox3d
boxOf(const TriangleMesh& mesh);

/** \brief Diagonal of the axis-aligned bounding box. */
double
diagonalOf(const TriangleMesh& mesh);

/** \brief Volume of a closed mesh. */
double
volumeOf(const TriangleMesh& mesh);

/** \brief Area of its surface. */
double
areaOf(const TriangleMesh& mesh);

/** \brief Center of the volume of a closed mesh. */
Eigen::Vector3d
centroidOf(const TriangleMesh& mesh);

} // namespace pcl_cid
