/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CID from one point of a scan to all of them, as a field of its cloud.
 */

#include "heat_map.h"

#include <pcl_cid/core/cid_from.h>
#include <pcl_cid/io/float_field.h>
#include <pcl_cid/io/output_files.h>

#include <algorithm>
#include <climits>
#include <limits>
#include <ostream>

namespace pcl_cid::tools {
namespace {

constexpr const char* option_name = "cid-from";

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
        Console& console,
        Report& report)
{
  console.begin("Preparing");
  const PointSet finite = finitePoints(*cloud.points);
  DistanceField::Options options;
  options.execution = {settings.threads, console.progress()};
  const DistanceField field(finite.points, options);
  console.end(std::to_string(finite.size()) + " finite points", "prepare", report);
  console.begin("Measuring");
  const Eigen::Vector3f p = finite.frame.toLocal(from.cast<double>()).cast<float>();
  const std::vector<float> cids = cidFrom(field,
                                          p,
                                          finite.points,
                                          settings.samples,
                                          {settings.threads, console.progress()});
  std::vector<float> values(cloud.points->size(),
                            std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < finite.size(); ++i)
    values[static_cast<std::size_t>(finite.source[i])] = cids[i];
  console.end(shortNumber(*std::max_element(cids.begin(), cids.end())) +
                  " metres at most",
              "measure",
              report);
  return values;
}

void
describe(const CloudPoints& points, const Settings& settings, int from, Report& report)
{
  report.points_in = points.points->size();
  report.points_finite = points.finite;
  report.parameters = {{"cid_from", std::int64_t{from}},
                       {"samples", std::int64_t{settings.samples}},
                       {"threads", std::int64_t{settings.threads}}};
}

} // namespace

void
declareHeatMapOption(std::optional<int>& cid_from, CommandLine& line)
{
  line.optionalNumber(option_name,
                      "INDEX",
                      {0, INT_MAX, "the index of a point, 0 or more"},
                      cid_from,
                      "no labels: write the float field `cid`, CID from this point of "
                      "INPUT to each, metres; NaN for points that are not finite");
  line.exclude(option_name,
               {"labels",
                "labels-from",
                "propose",
                "superpoints",
                "scannet-submission",
                "seeds",
                "coverage",
                "subsample",
                "random-seed",
                "start-index",
                "label-type"});
  line.exclude(option_name, rawScanOptionNames());
}

void
writeHeatMap(const std::string& tool, const Settings& settings, int cid_from)
{
  Console console(settings.quiet);
  Report report;
  report.tool = tool;
  OutputFiles outputs(inputFiles(settings));
  outputs.announce(settings.output);
  if (!settings.report.empty())
    outputs.announce(settings.report);

  CloudPoints points;
  LabelledCloud cloud = loadCloud(settings, console, report, points);
  const Eigen::Vector3f from = requirePoint(points, cid_from);
  const std::vector<float> cids = heatMap(points, from, settings, console, report);
  describe(points, settings, cid_from, report);

  console.begin("Saving " + settings.output);
  setFloats(cids, "cid", cloud);
  outputs.write(settings.output, [&](std::ostream& stream) {
    writeCloud(stream, cloud, layoutFor(settings.output, cloud.layout));
  });
  console.end(std::to_string(cloud.size()) + " points", "save", report);
  if (!settings.report.empty())
    outputs.write(settings.report, [&](std::ostream& s) { s << toJson(report); });
  outputs.commit();
}

} // namespace pcl_cid::tools
