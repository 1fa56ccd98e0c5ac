/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan with its truth, and what reports say about it.
 */

#pragma once

#include "run/loaded_scan.h"
#include "run/run.h"
#include "simulate_settings.h"

#include <pcl_cid/io/report.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief What reports say about a scan that was scored. */
struct ScoredScan {
  std::string name;
  std::string input;
  std::vector<std::string> remarks;
  std::vector<Report::Parameter> parameters;
  std::size_t points = 0;
  std::size_t finite = 0;
};

/** \brief The true instance of each point, 0 for none.
 *  \throws CIDException when the scan has no such field, or no point has an instance */
std::vector<std::uint32_t>
trueLabels(const SimulateSettings& settings, const LoadedScan& scan, Run& run);

/** \brief What there is to say about a scan, at the end of the work on it.
 *  \param[in,out] run its remarks are moved to the scan */
ScoredScan
scoredScan(const SimulateSettings& settings,
           const LoadedScan& scan,
           std::vector<Report::Parameter> parameters,
           Run& run);

} // namespace pcl_cid::tools
