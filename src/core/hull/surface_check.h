/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Whether triangles make up one closed surface, the first guarantee of a hull.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>

#include <optional>
#include <string>

namespace pcl_cid {

/** \brief What is wrong with the surface of a mesh, as a sentence.
 *
 *  A sound one has finite vertices, all of them used; each edge once in either
 *  direction; V - E + F = 2; no triangle lower than 1e-7 of the diagonal; normals
 *  outward. */
std::optional<std::string>
findBrokenSurface(const TriangleMesh& mesh);

} // namespace pcl_cid
