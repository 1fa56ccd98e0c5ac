/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Not installed: how much free space of a scan hulls refuse, whoever made them.
 */

#include "hull_files.h"
#include "refusal_table.h"
#include "refused_places.h"
#include "run/command_line.h"
#include "run/run.h"

#include <pcl_cid/core/settings.h>
#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/cloud_points.h>
#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/scan_source.h>
#include <pcl_cid/io/viewpoints.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include <boost/program_options.hpp>

namespace pcl_cid::benchmarks {
namespace {

namespace po = boost::program_options;
using tools::UsageError;

constexpr const char* about =
    "Usage: cid_refused SCAN HULLS [HULLS ...] [options]\n\n"
    "Measures how much free space of a scan hulls take away from a robot. SCAN is\n"
    "whatever pcl_cid_abstract takes; HULLS are meshes (OBJ, PLY, STL) in its\n"
    "coordinates, made by any program: the convex hull of each part counts, in an STL\n"
    "that of each connected piece. doc/hulls.md says what the figures mean.\n";

// Group, name, title, placeholder, unit, default, least, most, meaning.
// clang-format off

constexpr NumberSetting<double> radius_setting{
    "Options", "robot_radius", "robot radius", "R", "metres",
    PlaceOptions().robot_radius, setting::shortest, setting::longest,
    "how near to a point or a hull the robot cannot be"};

constexpr NumberSetting<std::uint64_t> places_setting{
    "Options", "places", "number of places", "N", "",
    PlaceOptions().places, 1, 100000000,
    "places that are drawn"};

constexpr NumberSetting<std::uint64_t> seed_setting{
    "Options", "seed", "seed", "S", "",
    PlaceOptions().random_seed, 0, std::numeric_limits<std::uint64_t>::max(),
    "of the draw"};

constexpr NumberSetting<double> voxel_setting{
    "Options", "voxel", "voxel", "V", "metres",
    SightOptions().voxel, setting::shortest, setting::longest,
    "edge of the voxels that are seen free or not"};

constexpr NumberSetting<double> elevation_setting{
    "Options", "max_elevation_sine", "largest sine of the elevation", "S", "",
    1.0, 0.0, 1.0,
    "sensors see up and down to this sine of the elevation"};

// clang-format on

struct RefusedSettings {
  std::string scan;
  std::vector<std::string> hulls;
  std::string viewpoints;
  bool has_viewpoint_of_cloud = false;
  std::string csv;
  PlaceOptions options;
};

/** An option for a row, with its range and its help. */
template <typename Value, typename Target>
void
addNumber(const NumberSetting<Value>& row,
          Target& target,
          po::options_description& described)
{
  std::string name = row.name;
  std::replace(name.begin(), name.end(), '_', '-');
  const auto take = [name, &row, &target](const Value& value) {
    if (!row.allows(value))
      throw UsageError("--" + name + " is out of its range; it must be " +
                       rangeOf(row));
    target = value;
  };
  std::ostringstream help;
  help << row.meaning << (*row.unit ? ", " : "") << row.unit;
  if (row.zero)
    help << "; 0 " << row.zero;
  help << "; default " << row.initial;
  described.add_options()(
      name.c_str(),
      po::value<Value>()->value_name(row.placeholder)->notifier(take),
      help.str().c_str());
}

po::options_description
describeOptions(RefusedSettings& settings)
{
  PlaceOptions& options = settings.options;
  po::options_description described("Options");
  auto add = described.add_options();
  add("viewpoints",
      po::value(&settings.viewpoints)->value_name("FILE"),
      "where sensors stood; without it, all of the scan's box counts as seen");
  add("viewpoint-of-cloud",
      po::bool_switch(&settings.has_viewpoint_of_cloud),
      "the sensor stood where SCAN says");
  addNumber(radius_setting, options.robot_radius, described);
  addNumber(places_setting, options.places, described);
  addNumber(seed_setting, options.random_seed, described);
  addNumber(voxel_setting, options.sight.voxel, described);
  addNumber(elevation_setting, options.sight.max_elevation_sine, described);
  addNumber(setting::threads, options.sight.threads, described);
  add("csv",
      po::value(&settings.csv)->value_name("FILE"),
      "write the table there, too");
  add("help,h", "print this and exit");
  return described;
}

void
requireFiles(const RefusedSettings& settings)
{
  if (settings.hulls.empty())
    throw UsageError("SCAN and HULLS are needed, at least 2 file names");
  if (!settings.viewpoints.empty() && settings.has_viewpoint_of_cloud)
    throw UsageError("--viewpoints and --viewpoint-of-cloud exclude each other; give "
                     "one of them");
}

/** \return whether there is work to do */
bool
readArguments(int argc, const char* const* argv, RefusedSettings& settings)
{
  const po::options_description described = describeOptions(settings);
  std::vector<std::string> files;
  po::options_description all;
  all.add(described).add_options()("file", po::value(&files));
  po::variables_map values;
  try {
    po::store(po::command_line_parser(argc, argv)
                  .options(all)
                  .positional(po::positional_options_description().add("file", -1))
                  .run(),
              values);
    po::notify(values);
  }
  catch (const po::error& error) {
    throw UsageError(error.what());
  }
  if (values.count("help") != 0) {
    std::cout << about << '\n' << described;
    return false;
  }
  if (!files.empty()) {
    settings.scan = files.front();
    settings.hulls.assign(files.begin() + 1, files.end());
  }
  requireFiles(settings);
  return true;
}

/** The finite points of a scan about a local origin. */
PointSet
pointsOfScan(const LabelledCloud& cloud)
{
  const CloudPoints points = pointsOf(cloud, {false, [](const std::string& sentence) {
                                                std::cerr << sentence << '\n';
                                              }});
  if (points.finite == 0)
    throw CIDException(cloud.name + ": has no finite point; at least 1 is needed");
  PointSet scan = finitePoints(*points.points);
  scan.frame.origin = points.frame.toFile(scan.frame.origin);
  return scan;
}

std::vector<Eigen::Vector3d>
viewpointsOf(const LabelledCloud& cloud, const RefusedSettings& settings)
{
  if (settings.has_viewpoint_of_cloud)
    return {cloud.sensor_origin.head<3>().cast<double>()};
  if (settings.viewpoints.empty())
    return {};
  return readViewpoints(settings.viewpoints);
}

MeasuredHulls
measureFile(const std::string& path,
            const PointSet& scan,
            const RefusedPlaces& places,
            unsigned threads)
{
  const auto begin = std::chrono::steady_clock::now();
  MeasuredHulls row;
  row.file = path;
  const std::vector<ConvexPart> hulls = readHulls(path, scan.frame, threads);
  for (const ConvexPart& hull : hulls)
    row.vertices += hull.indices.size();
  row.figures = places.measure(hulls);
  row.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return row;
}

/** What the table must never be written over. */
std::vector<std::string>
inputsOf(const RefusedSettings& settings)
{
  std::vector<std::string> inputs = scanFiles(settings.scan);
  inputs.insert(inputs.end(), settings.hulls.begin(), settings.hulls.end());
  if (!settings.viewpoints.empty())
    inputs.push_back(settings.viewpoints);
  return inputs;
}

void
measureAll(const RefusedSettings& settings)
{
  OutputFiles outputs(inputsOf(settings));
  if (!settings.csv.empty())
    outputs.announce(settings.csv);
  const LabelledCloud cloud = readScan(settings.scan);
  const PointSet scan = pointsOfScan(cloud);
  const std::vector<Eigen::Vector3d> viewpoints = viewpointsOf(cloud, settings);
  const RefusedPlaces places(scan, viewpoints, settings.options);
  std::cout << settings.scan << ": " << scan.size() << " points, " << viewpoints.size()
            << " viewpoints, " << places.space().freeVolume() << " m3 free, "
            << settings.options.places << " places for a robot of "
            << settings.options.robot_radius << " m\n\n";
  std::vector<MeasuredHulls> rows;
  for (const std::string& path : settings.hulls)
    rows.push_back(measureFile(path, scan, places, settings.options.sight.threads));
  std::cout << toText(rows);
  if (!settings.csv.empty())
    outputs.write(settings.csv, [&](std::ostream& stream) { stream << toCsv(rows); });
  outputs.commit();
}

} // namespace
} // namespace pcl_cid::benchmarks

int
main(int argc, char** argv)
{
  using namespace pcl_cid::benchmarks;
  return pcl_cid::tools::runTool("cid_refused", [&] {
    RefusedSettings settings;
    if (readArguments(argc, argv, settings))
      measureAll(settings);
  });
}
