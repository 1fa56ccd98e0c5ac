/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What writers of datasets wrote, read by Python and numpy.
 */

#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {

/** \brief What read_exports.py makes of files; null when it fails, with what it says as
 *  a failure of the test.
 *  \param[in] arguments names without quotes */
nlohmann::json
readByPython(const std::vector<std::string>& arguments);

} // namespace pcl_cid::test
