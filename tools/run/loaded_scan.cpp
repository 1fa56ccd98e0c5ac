/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The input of a run: its cloud, and the coordinates that are worked on.
 */

#include "loaded_scan.h"

#include "common_settings.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/scan_source.h>

#include <ostream>

namespace pcl_cid::tools {
std::vector<std::string>
inputFiles(const Settings& settings)
{
  return scanFiles(settings.input, settings.class_table);
}

LoadedScan
loadScan(const Settings& settings, Run& run)
{
  run.begin("Loading " + settings.input);
  LoadedScan scan;
  scan.cloud = readScan(settings.input, {settings.class_table, run.remark()});
  scan.points = pointsOf(scan.cloud, {settings.keep_zeros, run.remark()});
  const std::string size = std::to_string(scan.cloud.size());
  if (scan.points.finite == 0)
    throw CIDException(settings.input + ": none of its " + size +
                       " points is finite; at least 1 must be");
  run.end(size + " points, " + std::to_string(scan.points.finite) + " finite", "load");
  run.report.input = settings.input;
  return scan;
}

void
requireOutputHolds(const std::string& path, const LoadedScan& scan, Run& run)
{
  const auto remark = run.remark();
  requireWritable(scan.cloud, path, [&](const std::string& sentence) {
    remark(path + ": " + sentence);
  });
}

void
writeScan(const std::string& path, const LabelledCloud& cloud, OutputFiles& outputs)
{
  outputs.write(path, [&](std::ostream& stream) {
    writeCloud(stream, cloud, layoutFor(path, cloud.layout));
  });
}

} // namespace pcl_cid::tools
