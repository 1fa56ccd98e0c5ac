/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Fewer vertices, around the same points.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>

#include <cstddef>
#include <functional>

namespace pcl_cid {

/** \brief A convex body around a hull, of few vertices.
 *
 *  An outer approximation by half-spaces: from the principal box (below 8 vertices,
 *  from a tetrahedron around it), face planes of the hull cut away what is farthest
 *  outside, as long as the vertices are not too many. All of it lies within that box or
 *  tetrahedron; a hull that has few enough vertices stays as it is.
 *  \param[in] hull closed and convex
 *  \param[in] max_vertices 0 for any number, or at least 4
 *  \return no triangles when qhull fails
 *  \note Cost: O(max_vertices (F max_vertices)), F the triangles of \a hull. */
TriangleMesh
reduceOutward(const TriangleMesh& hull, std::size_t max_vertices);

/** \brief The first of the bodies on that way, from the principal box on, that may take
 *  the place of the hull, without the planes that it can do without.
 *  \param[in] hull closed and convex
 *  \param[in] may_replace asked about bodies of fewer vertices than the hull
 *  \return the hull itself when none may */
TriangleMesh
simplifyOutward(const TriangleMesh& hull,
                const std::function<bool(const TriangleMesh& body)>& may_replace);

} // namespace pcl_cid
