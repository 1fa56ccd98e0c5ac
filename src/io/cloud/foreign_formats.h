/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Files of points that are not read, and how to convert them.
 */

#pragma once

#include <iosfwd>
#include <string>

namespace pcl_cid {

/** \brief Say of a file in a known format that is not read what it is, and which
 *  command converts it.
 *  \param[in] stream at the beginning of the file; it may be left anywhere
 *  \throws CIDException when it is of such a format */
void
refuseForeignFormat(std::istream& stream, const std::string& path);

} // namespace pcl_cid
