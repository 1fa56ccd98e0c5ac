/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The format of a file, and what is required of any cloud that was read.
 */

#pragma once

#include "text/opened_file.h"

#include <pcl_cid/io/labelled_cloud.h>

#include <cstddef>
#include <string>

namespace pcl_cid {

/** \brief "a PCD or PLY file is needed". */
std::string
neededFile();

/** \brief The format of a file that is read: by the content where a format can tell by
 *  that, else by the extension.
 *  \param[in] file its stream is at the beginning, then and afterwards
 *  \param[in] given an extension that decides; may be empty
 *  \throws CIDException when there is none */
const CloudFormat&
formatOf(const OpenedFile& file, const std::string& path, const std::string& given);

/** \brief Whatever a reader has left undone shows here, not when the cloud is used.
 *  \param[in] points that its data are there for
 *  \throws CIDException also when its fields are no coordinates, or not distinct */
void
requireWhole(const LabelledCloud& cloud, std::size_t points);

/** \brief A pose that is none, as some drivers write it, is as good as no pose. */
void
mendPose(LabelledCloud& cloud);

} // namespace pcl_cid
