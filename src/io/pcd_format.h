/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Point cloud files of the Point Cloud Library (.pcd), version 0.7 and older.
 */

#pragma once

#include <pcl_cid/io/labelled_cloud.h>

#include <istream>
#include <ostream>

namespace pcl_cid {

/** \brief Read a PCD; see readCloud().
 *  \param[in] stream at the beginning of the file
 *  \param[in] size of the file in bytes
 *  \param[in,out] cloud its name is there already */
void
readPCD(std::istream& stream, std::uint64_t size, LabelledCloud& cloud);

/** \brief Write a PCD; see writeCloud(). */
void
writePCD(std::ostream& stream, const LabelledCloud& cloud, CloudFormat format);

} // namespace pcl_cid
