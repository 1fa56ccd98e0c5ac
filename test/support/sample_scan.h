/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The sample scan that comes with the project: data/room.pcd and its truth.
 */

#pragma once

#include <string>

namespace pcl_cid::test {

/** \brief Writes room.pcd (fields x y z label semantic, binary compressed) and
 *  room_truth.json (classes, instances, how the scan was made). The same bytes each
 *  time.
 *  \param[in] folder an existing folder; files of these names are replaced
 *  \throw CIDException when a file cannot be written */
void
writeSampleScan(const std::string& folder);

} // namespace pcl_cid::test
