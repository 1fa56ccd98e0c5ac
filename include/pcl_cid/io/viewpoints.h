/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Where the sensors of a scan stood, from a file.
 */

#pragma once

#include <pcl_cid/exceptions.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <string>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief Read where the sensors of a scan stood.
 *
 *  JSON: an array of positions, or an object that has it under `sensor_positions` or,
 *  else, `viewpoints`; other members are passed over. A position is `[x, y, z]`,
 *  `{"x": x, "y": y, "z": z}`, or an object that has one of these under `position`.
 *
 *  Anything else is a table of text, separated by commas, semicolons or tabs: three
 *  numbers a row, or a header that names the columns `x`, `y` and `z`, in any order and
 *  among others, which are passed over. Spreadsheets may have made it: see
 *  readSeedTable() for what is fine.
 *  \param[in] path of the file, whose content says which of the two it is
 *  \return at least 1 position in the order of the file, each coordinate -1e15 to 1e15
 *  as it stands there: in the frame and the unit of the scan's file
 *  \throws CIDException with the file and the place in it when it cannot be read, is no
 *  valid JSON or one nested more than 64 levels deep, when a position does not have
 *  three values, or a coordinate is no number, not finite or beyond 1e15; and when
 *  there is no position at all
 *  \note Cost: linear in the size of the file. Thread safety: any thread may call
 *  this. */
PCL_CID_IO_EXPORT std::vector<Eigen::Vector3d>
readViewpoints(const std::string& path);

} // namespace pcl_cid
