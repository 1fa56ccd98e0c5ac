/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How far a body reaches out of a hull that it holds.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>

namespace pcl_cid {

/** \brief Whether no place of a convex body is farther than \a most from a hull.
 *  \param[in] hull closed and convex
 *  \note Cost: O(V F), V the vertices of \a body, F the triangles of \a hull. */
bool
staysNear(const TriangleMesh& hull, const TriangleMesh& body, double most);

} // namespace pcl_cid
