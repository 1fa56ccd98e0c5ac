/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The parts of an OBJ, whichever program wrote it.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>

#include <string>
#include <vector>

namespace pcl_cid::benchmarks {

/** \brief The meshes of a file. */
struct MeshParts {
  /** Each with the vertices that belong to it, and no others. */
  std::vector<TriangleMesh> meshes;
  /** Whether each is a part; else they are one mesh of all. */
  bool has_names = false;
};

/** \brief Read an OBJ of any program. (io/mesh/obj.cpp is as strict as a file of our
 * own should be.)
 *
 *  Each `o` begins a part; in a file with at most one `o`, the names after `g` are the
 *  parts. A vertex belongs to each part whose faces name it, and one that no face names
 *  to the named part in which it stands. Polygons, `v/vt/vn`, negative numbers,
 * vertices with weights or colors, and all that says how a mesh looks are understood;
 * curved surfaces are not. \throws CIDException with the file, and the line where one
 * is to blame */
MeshParts
readOBJParts(const std::string& path);

} // namespace pcl_cid::benchmarks
