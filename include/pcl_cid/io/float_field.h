/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A float field of a cloud, such as CID from a point.
 */

#pragma once

#include <pcl_cid/io/labelled_cloud.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <string>
#include <vector>

namespace pcl_cid {

/** \brief Give the cloud a field of type float: in the place of the one of this name,
 *  or after all other fields when there is none.
 *  \param[in] values one for each point; they need not be finite
 *  \param[in] name of the field; not x, y or z
 *  \param[in,out] cloud unchanged when an exception is thrown
 *  \throws CIDException when there is not one value for each point, or the name is x, y
 *  or z */
PCL_CID_IO_EXPORT void
setFloats(const std::vector<float>& values,
          const std::string& name,
          LabelledCloud& cloud);

} // namespace pcl_cid
