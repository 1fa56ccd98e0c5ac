/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Rooms of the dataset S3DIS, with their instances and classes.
 */

#pragma once

#include <pcl_cid/io/labelled_cloud.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl_cid {

/** \brief Whether a path is a room of S3DIS: a folder with a folder `Annotations`. */
PCL_CID_IO_EXPORT bool
isS3DISRoom(const std::string& path);

/** \brief The files that readS3DISRoom() reads: the annotations in their order, then
 *  the file of the room when there is one.
 *  \throws CIDException when the folder cannot be read */
PCL_CID_IO_EXPORT std::vector<std::string>
s3disRoomFiles(const std::string& folder);

/** \brief Read a room: `Annotations/<class>_<k>.txt`, a file for each instance, a line
 *  `x y z red green blue` for each point.
 *
 *  The points are those of the annotations, one file after the other by name in natural
 *  order (chair_2 before chair_10). Fields of the cloud: x y z rgb, `label` (number of
 *  the file, from 1) and `semantic` (s3disClasses()). Coordinates are float, or double
 *  where one is 1024 or more, as in UTM. A class that S3DIS does not have, such as its
 *  own `stairs`, becomes clutter.
 *
 *  In the public files some characters have lost one bit (0x20), which turned digits
 *  and blanks into control bytes. Where restoring the bit makes the line a point again,
 *  the line is repaired; otherwise it is left out.
 *  \param[in] folder of the room
 *  \param[in] remark called with one sentence for each line that was repaired or left
 *  out and each file that was passed over, and when the file of the room holds another
 *  number of points; may be empty
 *  \throws CIDException with file and line when there is no annotation, one holds no
 *  point, or another line is not six numbers, the last three 0 to 255
 *  \note Cost: below a microsecond a line. */
PCL_CID_IO_EXPORT LabelledCloud
readS3DISRoom(const std::string& folder, const RemarkCallback& remark);

} // namespace pcl_cid
