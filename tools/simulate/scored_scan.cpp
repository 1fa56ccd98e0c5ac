/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan with its truth, and what reports say about it.
 */

#include "scored_scan.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/scan_source.h>

#include <algorithm>
#include <utility>

namespace pcl_cid::tools {

std::vector<std::uint32_t>
trueLabels(const SimulateSettings& settings, const LoadedScan& scan, Run& run)
{
  std::vector<std::uint32_t> truth =
      labelsOf(scan.cloud, settings.truth_field, scan.points, run.remark());
  if (std::all_of(truth.begin(), truth.end(), [](auto label) { return label == 0; }))
    throw CIDException(settings.input + ": field '" + settings.truth_field +
                       "' is 0, which means none, for all of its " +
                       std::to_string(scan.points.finite) +
                       " finite points; at least 1 must have another label");
  return truth;
}

ScoredScan
scoredScan(const SimulateSettings& settings,
           const LoadedScan& scan,
           std::vector<Report::Parameter> parameters,
           Run& run)
{
  return {scanName(settings.input),
          settings.input,
          std::exchange(run.report.remarks, {}),
          std::move(parameters),
          scan.cloud.size(),
          scan.points.finite};
}

} // namespace pcl_cid::tools
