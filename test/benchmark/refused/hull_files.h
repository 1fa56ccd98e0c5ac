/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls from the mesh files of any program.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/frame.h>

#include <string>
#include <vector>

namespace pcl_cid::benchmarks {

/** \brief Hulls thinner than this are made as thick, metres. */
constexpr double least_thickness = 1e-4;

/** \brief The connected pieces of a mesh: the number of the piece of each vertex, from
 *  0 in the order of the vertices; -1 for vertices of no triangle. */
std::vector<int>
piecesOf(const TriangleMesh& mesh);

/** \brief The convex hulls of the parts in a file.
 *
 *  A part is a mesh of the file (in an OBJ, see readOBJParts()); where parts are not
 *  kept apart or have no names, a connected piece. It need not be convex itself: its
 *  hull is taken. What has no vertex is passed over.
 *  \param[in] path of a format in the table of meshes (meshFormatOf())
 *  \param[in] frame of the scan that the hulls belong to
 *  \param[in] threads 0 for each processor
 *  \return hulls in the coordinates of the file, at least one; `indices` of each are
 *  those of its vertices among the vertices of all parts
 *  \throws CIDException when the file cannot be read, a coordinate is beyond 1e15, or
 *  there is no part */
std::vector<ConvexPart>
readHulls(const std::string& path, const Frame& frame, unsigned threads);

} // namespace pcl_cid::benchmarks
