/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds from meshes: points spread evenly over their surface.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/labelled_cloud.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <string>
#include <vector>

namespace pcl_cid {

/** \brief Read the triangles of a mesh, as any program writes it: OBJ, STL (ascii or
 *  binary), OFF or PLY, packed by gzip or not. Faces with more corners are divided
 *  into triangles about their first one. Normals, colors, textures and groups are
 *  passed over; which side of a face is the outer one has no meaning here.
 *  \param[in] path "-" is the standard input
 *  \param[in] extension of the format that the file has, with the dot, whatever its
 *  name says; empty: its name says it
 *  \return coordinates as they stand in the file; corners of an STL are not joined
 *  \throws CIDException when the extension is none of these, when the file cannot be
 *  opened, is truncated or damaged, when a vertex is not finite, or there is no face */
PCL_CID_IO_EXPORT TriangleMesh
readSurface(const std::string& path, const std::string& extension = "");

/** \brief Whether a file is, by its name, a mesh and no cloud: an OBJ, STL or OFF. */
PCL_CID_IO_EXPORT bool
isSurfaceFile(const std::string& path);

/** \brief Names of the meshes that readSurface() reads: "OBJ", "STL", "OFF", "PLY". */
PCL_CID_IO_EXPORT std::vector<std::string>
surfaceNames();

/** \brief How names of meshes end: ".obj", ".stl", ".off", ".ply". */
PCL_CID_IO_EXPORT std::vector<std::string>
surfaceExtensions();

/** \brief The spacing with which a mesh gets about 200,000 points: as few as half of
 *  that where all edges are alike and fit the spacing badly.
 *  \throws CIDException when its surface has no area */
PCL_CID_IO_EXPORT double
usualSpacing(const TriangleMesh& mesh);

/** \brief Points on the surface of a mesh: no two are nearer to each other than the
 *  spacing, and all of the surface is within 1.5 times the spacing of one.
 *
 *  Candidates are laid over the triangles in rows, 8 for a square of the spacing; one
 *  after the other is taken unless a point that was taken is too near. Deterministic.
 *  About 0.7 points for a square of the spacing remain, and these cost about a
 *  microsecond each.
 *  \param[in] spacing in the unit of the mesh, setting::mesh_spacing
 *  \throws CIDException when the spacing is out of range, or so small that there would
 *  be more points than a cloud may have, or when the surface has no area */
PCL_CID_IO_EXPORT std::vector<Eigen::Vector3d>
sampleSurface(const TriangleMesh& mesh, double spacing);

/** \brief Read a mesh as a cloud with the fields x, y and z.
 *  \param[in] extension see readSurface()
 *  \param[in] spacing see sampleSurface(); 0: usualSpacing()
 *  \return with a remark that says the spacing and the number of triangles */
PCL_CID_IO_EXPORT LabelledCloud
readSurfaceAsCloud(const std::string& path,
                   double spacing,
                   const std::string& extension = "");

} // namespace pcl_cid
