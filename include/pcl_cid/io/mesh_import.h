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
 *  Strict, like all readers here: only what mesh_export.h writes is read, so that a
 *  check of the meshes is a check of everything in the file. Of the statements of OBJ
 *  it knows `o`, `v`, `f`, `usemtl`, `mtllib` and comments; faces are triangles of
 *  vertices of their own object.
 *  \return coordinates as they stand in the file, to the last bit
 *  \throws CIDException with file and line when the file cannot be opened or has
 *  anything else in it */
PCL_CID_IO_EXPORT std::vector<TriangleMesh>
readOBJ(const std::string& path);

/** \brief The meshes of a PLY, one for each part number of the faces.
 *  \return coordinates as they stand in the file, to the last bit
 *  \throws CIDException with file and offset when the file cannot be opened, is not
 *  laid out as writePLY() does it, is truncated or too long, when the part numbers do
 *  not ascend from 0 without a gap, or when a vertex does not belong to exactly one
 *  part */
PCL_CID_IO_EXPORT std::vector<TriangleMesh>
readPLY(const std::string& path);

/** \brief The one mesh of a binary STL. Corners with equal coordinates become one
 *  vertex; normals, which follow from the corners, are passed over.
 *  \return coordinates that float holds
 *  \throws CIDException with file and offset when the file cannot be opened, when its
 *  size is not that of the triangles it announces, or when a coordinate is not
 *  finite */
PCL_CID_IO_EXPORT TriangleMesh
readSTL(const std::string& path);

} // namespace pcl_cid
