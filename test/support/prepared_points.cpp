/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points as a prepared scan.
 */

#include "prepared_points.h"

#include <memory>
#include <numeric>
#include <utility>

namespace pcl_cid::test {

RawScan
rawScan(const Points& points)
{
  pcl::Indices all(points.size());
  std::iota(all.begin(), all.end(), 0);
  RawScan scan;
  scan.points = PointSet(points, std::move(all));
  scan.cloud_size = points.size();
  return scan;
}

PreparationSettings
plainSettings()
{
  PreparationSettings settings;
  settings.setPaperSettings();
  settings.blind_spot = setting::blind_spot.initial; // it needs a sensor
  settings.start_index = 0;
  return settings;
}

PreparedScan::ConstPtr
prepared(const Points& points, const PreparationSettings& settings)
{
  return std::make_shared<const PreparedScan>(rawScan(points), settings);
}

ExecutionOptions
onThreads(unsigned int threads)
{
  ExecutionOptions execution;
  execution.threads = threads;
  return execution;
}

} // namespace pcl_cid::test
