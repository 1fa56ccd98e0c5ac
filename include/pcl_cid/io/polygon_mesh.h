/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Meshes of parts as PCL's own, for its viewer and writers.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <pcl/PolygonMesh.h>

namespace pcl_cid {

/** \brief A mesh as PCL knows it.
 *  \note Its coordinates are float: far from the origin, at UTM coordinates, hulls lose
 *  their shape. */
PCL_CID_IO_EXPORT pcl::PolygonMesh
toPolygonMesh(const TriangleMesh& mesh);

} // namespace pcl_cid
