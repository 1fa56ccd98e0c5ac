/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points with normals in a graph of neighbors, and its cuts.
 */

#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid::benchmarks {

/** \brief Points of a surface with unit normals to its outside. */
struct OrientedPoints {
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f> normals;

  std::size_t
  size() const
  {
    return points.size();
  }
};

/** \brief How a surface bends from one point to its neighbor. */
enum class Bend { convex, concave, unclear };

/** \brief Convex (or flat) when each point is not above the tangent plane of the other,
 *  concave when each is above it, unclear when they disagree. */
Bend
bendBetween(const OrientedPoints& surface, std::size_t first, std::size_t second);

/** \brief An edge of a graph, seen from one of its ends. */
struct Edge {
  int to;
  double weight;
};

/** \brief For each node its edges; symmetric. */
using Graph = std::vector<std::vector<Edge>>;

/** \brief The nearest \a neighbors points of each point, made symmetric; ascending. */
std::vector<std::vector<int>>
nearestNeighbors(const std::vector<Eigen::Vector3f>& points, int neighbors);

/** \brief The graph with the weight of each edge by how the surface bends there: close
 *  to 1 where it is convex, close to 0 where it is concave. Neighbors that look to
 *  opposite sides, as on the two faces of a board, are not joined. */
Graph
weighByBend(const OrientedPoints& surface,
            const std::vector<std::vector<int>>& neighbors);

/** \brief Cut a graph into connected patches by normalised cuts, the largest patch
 *  first.
 *
 *  Each is cut in two where the normalised cut along its second eigenvector is least:
 *  J. Shi, J. Malik, "Normalized Cuts and Image Segmentation", 2000, the recursive
 *  two-way cut. The eigenvector is that of a Krylov space of limited size (Lanczos).
 *  \param[in] graph symmetric, weights above 0
 *  \param[in] patches to reach; more come back when there are more connected pieces or
 *  a cut leaves several
 *  \return number of the patch of each node, from 0 without gaps */
std::vector<int>
cutIntoPatches(const Graph& graph, std::size_t patches);

} // namespace pcl_cid::benchmarks
