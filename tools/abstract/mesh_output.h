/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * All hulls in one mesh file, in the format that its extension says.
 */

#pragma once

#include "run/loaded_scan.h"

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/io/output_files.h>

#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief Refuse a format that rounds to float for a scan with finer coordinates, so
 *  far from the origin that hulls of the least thickness would lose their shape in it.
 *  \throws CIDException */
void
requireRoomForFloat(const std::string& path,
                    const LoadedScan& scan,
                    double min_thickness);

/** \brief Write a mesh, and the file of colors beside it where its format has one.
 *  \param[in] path was announced, with its file of colors (see materialsBeside())
 *  \param[in] parts in the frame of the file, metres
 *  \param[in] metres_per_unit of what is written
 *  \param[in] name before the names of the parts, see partName(); may be empty
 *  \throws CIDException when the format would round a hull out of its shape */
void
saveMesh(const std::string& path,
         std::vector<ConvexPart> parts,
         double metres_per_unit,
         const std::string& name,
         OutputFiles& outputs);

} // namespace pcl_cid::tools
