/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The simplest meshes around some points: a box, or a tetrahedron.
 */

#pragma once

#include "principal_box.h"

#include <pcl_cid/core/convex_part.h>

#include <cstddef>

namespace pcl_cid {

/** \brief A box with its 8 corners, or a tetrahedron about it when those are too many.
 *  \param[in] box of extents above 0
 *  \param[in] max_vertices 0 for any number, or at least 4 */
TriangleMesh
boxMesh(const PrincipalBox& box, std::size_t max_vertices);

} // namespace pcl_cid
