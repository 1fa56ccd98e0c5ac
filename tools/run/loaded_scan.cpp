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

void
remarkOnUnit(const Settings& settings, const LoadedScan& scan, Run& run)
{
  constexpr double longest_building = 500.0;
  const Eigen::Vector3d& extent = scan.points.extent;
  if (settings.scale == setting::scale.initial && extent.allFinite() &&
      extent.maxCoeff() > longest_building)
    run.remark()(settings.input + ": most of it measures " + shortNumber(extent.x()) +
                 " x " + shortNumber(extent.y()) + " x " + shortNumber(extent.z()) +
                 " metres; if it is in millimetres, give --scale 0.001");
}

void
useOutputUnit(const Settings& settings, LoadedScan& scan)
{
  if (settings.output_unit == OutputUnit::metre)
    scan.points.metres_per_unit = 1.0;
}

LoadedScan
loadScan(const Settings& settings, Run& run)
{
  if (!settings.many.output_dir.empty() || settings.output == standard_output)
    run.console.beBriefOn(settings.input);
  run.begin("Loading " + settings.input);
  LoadedScan scan;
  scan.name = scanName(settings.input);
  scan.cloud =
      readScan(settings.input,
               {settings.class_table,
                run.remark(),
                settings.scale,
                settings.mesh_spacing,
                settings.input_format.empty() ? "" : "." + settings.input_format});
  scan.points = pointsOf(scan.cloud, {settings.keep_zeros, run.remark()});
  useOutputUnit(settings, scan);
  const std::string size = std::to_string(scan.cloud.size());
  if (scan.points.finite == 0)
    throw CIDException(settings.input + ": none of its " + size +
                       " points is finite; at least 1 must be");
  remarkOnUnit(settings, scan, run);
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
announceCloud(const std::string& path, OutputFiles& outputs)
{
  if (path == standard_output)
    outputs.announceStandardOutput();
  else
    outputs.announce(path);
}

void
writeScan(const std::string& path,
          const LabelledCloud& cloud,
          OutputUnit unit,
          OutputFiles& outputs)
{
  LabelledCloud in_metres;
  if (unit == OutputUnit::metre) {
    in_metres = cloud;
    convertToMetres(in_metres);
  }
  outputs.write(path, [&](std::ostream& stream) {
    writeCloud(stream,
               unit == OutputUnit::metre ? in_metres : cloud,
               layoutFor(path, cloud.layout));
  });
}

} // namespace pcl_cid::tools
