/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Names of files and folders.
 */

#pragma once

#include <string>
#include <vector>

namespace pcl_cid {

/** \brief The last name in a path. Of "room/", and of "." in the folder room, that is
 *  "room". */
std::string
lastName(const std::string& path);

/** \brief The extension in small letters, with the dot; empty when there is none. */
std::string
extensionOf(const std::string& path);

/** \brief "a, b or c". */
std::string
listed(const std::vector<std::string>& words, const std::string& conjunction = "or");

} // namespace pcl_cid
