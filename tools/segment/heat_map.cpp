/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID from one point of a scan to all of them, as a field of its cloud.
 */

#include "heat_map.h"

#include "picture/picture.h"
#include "run/loaded_scan.h"
#include "run/parameter.h"
#include "run/words.h"

#include <pcl_cid/core/cid_from.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/float_field.h>

#include <algorithm>
#include <limits>

namespace pcl_cid::tools {
namespace {

constexpr NumberSetting<int> cid_from_setting{
    "Labels",
    "cid_from",
    "index of the point",
    "INDEX",
    "",
    0,
    0,
    setting::any_number,
    "no labels: write the float field `cid`, CID in metres from this point of INPUT to "
    "each; NaN for points that are not finite"};

Eigen::Vector3f
requirePoint(const CloudPoints& points, int index)
{
  const auto size = static_cast<int>(points.points->size());
  const std::string given = "--cid-from is " + std::to_string(index);
  if (index >= size)
    throw CIDException(given + "; it must be 0 to " + std::to_string(size) +
                       " - 1 (the points of INPUT)");
  const Eigen::Vector3f p =
      (*points.points)[static_cast<std::size_t>(index)].getVector3fMap();
  if (!p.allFinite())
    throw CIDException(given + ", a point that is not finite; choose one that is");
  return p;
}

/** One value for each point of the cloud. */
std::vector<float>
heatMap(const CloudPoints& cloud,
        const Eigen::Vector3f& from,
        const Settings& settings,
        Run& run)
{
  run.begin("Preparing");
  const ExecutionOptions execution{settings.threads, run.console.progress()};
  const PointSet finite = finitePoints(*cloud.points);
  DistanceField::Options options;
  options.execution = execution;
  const DistanceField field(finite.points, options);
  run.end(std::to_string(finite.size()) + " finite points", "prepare");

  run.begin("Measuring");
  const Eigen::Vector3f p = finite.frame.toLocal(from.cast<double>()).cast<float>();
  const std::vector<float> cids =
      cidFrom(field, p, finite.points, settings.samples, execution);
  std::vector<float> values(cloud.points->size(),
                            std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < finite.size(); ++i)
    values[static_cast<std::size_t>(finite.source[i])] = cids[i];
  run.end(shortNumber(*std::max_element(cids.begin(), cids.end())) + " metres at most",
          "measure");
  return values;
}

void
describe(const CloudPoints& points, const Settings& settings, int from, Report& report)
{
  report.points_in = points.points->size();
  report.points_finite = points.finite;
  report.parameters = {parameter(cid_from_setting, from),
                       parameter(setting::samples, settings.samples),
                       parameter(setting::threads, settings.threads)};
}

} // namespace

void
declareHeatMapOption(std::optional<int>& cid_from, CommandLine& line)
{
  const std::string name = optionName(cid_from_setting);
  line.optional(cid_from_setting, cid_from);
  line.exclude(
      name, {"labels", "labels-from", "propose", "superpoints", "scannet-submission"});
  line.exclude(name,
               {optionName(setting::seeds),
                optionName(setting::coverage),
                optionName(setting::subsample),
                optionName(setting::random_seed),
                optionName(setting::start_index),
                optionName(setting::clean_up),
                optionName(label_type_setting)});
  line.exclude(name, rawScanOptionNames());
}

ScanFigures
writeHeatMap(const std::string& tool, const Settings& settings, int cid_from)
{
  Run run(tool, settings.quiet, inputFiles(settings));
  announceCloud(settings.output, run.outputs);
  announcePicture(settings.html, run.outputs);
  if (!settings.report.empty())
    run.outputs.announce(settings.report);

  LoadedScan scan = loadScan(settings, run);
  requireOutputHolds(settings.output, scan, run);
  requirePictureOf(settings.html, scan);
  const Eigen::Vector3f from = requirePoint(scan.points, cid_from);
  const std::vector<float> cids = heatMap(scan.points, from, settings, run);
  describe(scan.points, settings, cid_from, run.report);

  run.begin("Saving " + settings.output);
  setFloats(cids, "cid", scan.cloud);
  writeScan(settings.output, scan.cloud, settings.output_unit, run.outputs);
  run.end(std::to_string(scan.cloud.size()) + " points", "save");
  const std::string text = "CID from point " + std::to_string(cid_from);
  savePicture(settings.html, pictureOf(cids, text), scan, run);
  run.finish(settings.report);
  return figuresOf(run.report);
}

} // namespace pcl_cid::tools
