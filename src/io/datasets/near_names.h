/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Names that somebody may have meant.
 */

#pragma once

#include <string>
#include <vector>

namespace pcl_cid {

/** \brief The names that are most like another one: those that contain it or are
 *  contained in it, and those with few letters changed, whatever the case.
 *  \return at most three, the nearest first; none when there is no such name */
std::vector<std::string>
nearNames(const std::string& name, const std::vector<std::string>& names);

} // namespace pcl_cid
