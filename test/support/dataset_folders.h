/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A generated room in the published layouts of S3DIS and ScanNet.
 */

#pragma once

#include "labelled_scan.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_cid::test {

/** \brief A room with several pieces of some classes, seen evenly. */
LabelledScan
smallRoomScan(std::size_t points);

/** \brief Write a scan as a room of S3DIS: `Area_1/office_1/office_1.txt` and
 *  `Annotations/<class>_<k>.txt`, millimetres and whole colors. The file of the room
 *  has the order of the scan, which the annotations do not have.
 *  \param[in] folder an existing one, where Area_1 is made
 *  \return the folder of the room */
std::string
writeS3DISRoom(const std::string& folder, const LabelledScan& scan);

/** \brief Write a scan as one of ScanNet: `scans/scene0000_00/` with mesh, segments and
 *  aggregation, and the table of classes beside `scans`. Each instance is cut into
 *  segments, numbered by their first vertices as ScanNet's are.
 *  \param[in] folder an existing one, where `scans` is made
 *  \param[in] bare_instance one that no group names, as some things in ScanNet
 *  \return the folder of the scan */
std::string
writeScannetScan(const std::string& folder,
                 const LabelledScan& scan,
                 std::uint32_t bare_instance);

/** \brief The class (nyu40id) that the table of writeScannetScan() gives to a class of
 *  the room. */
std::uint32_t
nyu40Of(const std::string& room_class);

} // namespace pcl_cid::test
