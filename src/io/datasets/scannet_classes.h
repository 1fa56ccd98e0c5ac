/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * ScanNet's table of what its annotators call things.
 */

#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace pcl_cid {

/** \brief Read the columns `raw_category` and `nyu40id` of a table separated by tabs.
 *  \return the class of each category
 *  \throws CIDException with file and line when a column is missing or a class is not
 *  one of nyu40Classes() */
std::map<std::string, std::uint32_t>
readScannetClasses(const std::string& path);

} // namespace pcl_cid
