/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What files and folders are called.
 */

#pragma once

#include <filesystem>
#include <string>

namespace pcl_cid {

/** \brief The last name in a path; "room/" and, in the room, "." mean the room. */
inline std::filesystem::path
lastName(const std::string& path)
{
  const auto whole = std::filesystem::absolute(path).lexically_normal();
  return whole.has_filename() ? whole.filename() : whole.parent_path().filename();
}

} // namespace pcl_cid
