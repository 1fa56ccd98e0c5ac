/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The meshes of parts, read back from the files that mesh_export.h writes.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <string>
#include <vector>

namespace pcl_cid {

/** \brief The meshes of an OBJ, one for each object, in the order of the file.
 *
 *  Strict, as all readers here: a file is taken as mesh_export.h writes it, so that
 * what is checked afterwards is what is in the file, and nothing in it was passed over.
 * Of the statements of OBJ it knows `o`, `v`, `f`, `usemtl`, `mtllib` and comments;
 *  faces are triangles of vertices of their own object.
 *  \throws CIDException with file and line when the file cannot be opened or has
 *  anything else in it */
PCL_CID_IO_EXPORT std::vector<TriangleMesh>
readOBJ(const std::string& path);

/** \brief The meshes of a PLY, one for each part number of the faces.
 *  \throws CIDException with file and offset when the file cannot be opened, is not
 * laid out as writePLY() does it, is truncated or too long, when the part numbers do
 * not ascend from 0 without a gap, or a vertex does not belong to exactly one part */
PCL_CID_IO_EXPORT std::vector<TriangleMesh>
readPLY(const std::string& path);

/** \brief The one mesh of a binary STL. Corners with equal coordinates become one
 *  vertex; normals are passed over.
 *  \throws CIDException with file and offset when the file cannot be opened, or its
 * size is not that of the triangles it announces, or a coordinate is not finite */
PCL_CID_IO_EXPORT TriangleMesh
readSTL(const std::string& path);

} // namespace pcl_cid
