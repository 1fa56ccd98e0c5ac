/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Polygon files (.ply) as clouds.
 */

#pragma once

#include <pcl_cid/io/labelled_cloud.h>

#include <istream>
#include <ostream>

namespace pcl_cid {

/** \brief Read the vertices and the camera of a PLY; see readCloud().
 *  \param[in] stream at the beginning of the file
 *  \param[in] size of the file in bytes
 *  \param[in,out] cloud its name is there already */
void
readPLY(std::istream& stream, std::uint64_t size, LabelledCloud& cloud);

/** \brief Write a PLY; see writeCloud(). */
void
writePLY(std::ostream& stream, const LabelledCloud& cloud, CloudFormat format);

} // namespace pcl_cid
