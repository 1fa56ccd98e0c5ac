/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * --verify: the guarantees of the hulls, checked on what is in the files.
 */

#pragma once

#include "abstracted_scan.h"
#include "error_verification.h"
#include "file_points.h"
#include "scene_outputs.h"

#include <pcl_cid/io/cloud_points.h>
#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/scene_export.h>

#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief What the files are checked against. */
struct Verification {
  const AbstractedScan& abstracted; ///< as it was written
  Frame frame;                      ///< that was worked in
  ShowParts show;                   ///< the points, as they stand in the file
  double metres_per_unit;           ///< of OUTPUT
  const ErrorVerification* error;   ///< null: no bound was asked for
};

/** \brief Read a mesh file with all parts again, before it is committed, and check each
 *  hull.
 *  \param[in] path of a format with a reader (see MeshFormat)
 *  \throws CIDException with file, part and guarantee when one does not hold */
void
verifyMesh(const std::string& path,
           const Verification& verification,
           OutputFiles& outputs);

/** \brief The same for the folder with a mesh for each part.
 *  \param[in] scene says where the meshes have their origin, and their format */
void
verifyParts(const std::string& folder,
            const SceneDescription& scene,
            const Verification& verification,
            OutputFiles& outputs);

/** \brief The same for the meshes that a scene holds itself; nothing for a format that
 *  holds none, or whose row does not say how to read them.
 *  \param[in] scene which parts must be there */
void
verifyMeshesOf(const SceneFile& file,
               const SceneDescription& scene,
               const Verification& verification,
               OutputFiles& outputs);

} // namespace pcl_cid::tools
