/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID from one point of a scan to all of them, as a field of its cloud.
 */

#pragma once

#include "run/common_settings.h"
#include "run/scan_summary.h"

#include <optional>
#include <string>

namespace pcl_cid::tools {

/** \brief Declare `--cid-from`, and refuse what has no effect beside it. */
void
declareHeatMapOption(std::optional<int>& cid_from, CommandLine& line);

/** \brief Write the scan with a float field `cid`: CID from one point of the input to
 *  each, metres, NaN for points that are not finite.
 *  \param[in] tool for the report
 *  \param[in] cid_from index of the point
 *  \throws CIDException when there is no such point or it is not finite */
ScanFigures
writeHeatMap(const std::string& tool, const Settings& settings, int cid_from);

} // namespace pcl_cid::tools
