/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labelled scans as rooms of S3DIS.
 */

#pragma once

#include <pcl_cid/io/labelled_cloud.h>
#include <pcl_cid/io/labelled_instances.h>
#include <pcl_cid/io/output_files.h>

#include <string>

namespace pcl_cid {

/** \brief A class as a part of the name of a file: small letters, digits and hyphens
 *  as they are, a blank as `+`, every other byte as `%` and two digits, as in
 *  `shower+curtain` and `caf%c3%a9` (café). So no two classes share a name, on file
 *  systems that ignore case neither, and it holds no `_`, which ends the class.
 *  Python's `urllib.parse.unquote_plus` is the way back.
 *  \return `%none` for the empty class
 *  \throws CIDException when the name would have more than 200 bytes */
PCL_CID_IO_EXPORT std::string
s3disFileClass(const std::string& class_name);

/** \brief Write a labelled scan as a room of S3DIS, which readS3DISRoom() reads.
 *
 *  `<folder>/<name of the folder>.txt` holds a line `x y z red green blue` for each
 *  point, in the order of the cloud, `Annotations/<class>_<n>.txt` the same lines for
 *  the points of one instance: n counts from 1 in each class, in the order of the
 *  labels. Coordinates are the shortest text that gives the same number of the cloud's
 *  type again. The format knows neither points that are not finite nor scans without
 *  color: the first are in no file, the second are black.
 *  \param[in] cloud has x, y and z
 *  \param[in] folder of the room; made when it is missing. Files `<class>_<n>.txt` that
 *  an earlier run left in its `Annotations` are removed
 *  \param[in,out] outputs announced and written; the caller commits them
 *  \param[in] remark called with one sentence for points that are left out, instances
 *  that have no other, a scan without color, and classes that S3DIS does not have; may
 *  be empty
 *  \throws CIDException when requireConsistent(), colorsOf() or \a outputs refuses, and
 *  for a class of too long a name
 *  \note Cost: O(n) for n points, about a microsecond each. */
PCL_CID_IO_EXPORT void
writeS3DISRoom(const LabelledCloud& cloud,
               const LabelledInstances& scan,
               const std::string& folder,
               OutputFiles& outputs,
               const RemarkCallback& remark = {});

} // namespace pcl_cid
