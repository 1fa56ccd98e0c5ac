/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The rows of files of columns in the table of cloud formats. All are read only.
 */

#pragma once

#include <pcl_cid/io/cloud_format.h>

namespace pcl_cid {

/** \brief Text: `.xyz`, `.xyzn`, `.xyzrgb`, `.txt`, `.csv`, `.pts`, `.asc`. */
CloudFormat
textFormat();

/** \brief Arrays of NumPy: `.npy`. */
CloudFormat
npyFormat();

/** \brief Scans of KITTI and nuScenes: `.bin`. */
CloudFormat
lidarFormat();

} // namespace pcl_cid
