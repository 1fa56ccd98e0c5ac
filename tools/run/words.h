/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Numbers and lists as the tools print them.
 */

#pragma once

#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief ".obj, .ply or .stl". */
std::string
alternatives(const std::vector<std::string>& words);

/** \brief The extension of a file, with its dot, in small letters. */
std::string
extensionOf(const std::string& path);

/** \brief ".pcd" -> "pcd". */
std::vector<std::string>
withoutDots(std::vector<std::string> extensions);

/** \brief A number for the user, with 4 digits. */
std::string
shortNumber(double value);

/** \brief "91.25 %". */
std::string
percent(double share);

} // namespace pcl_cid::tools
