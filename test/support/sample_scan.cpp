/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The sample scan that comes with the project: data/room.pcd and its truth.
 */

#include "sample_scan.h"

#include <fstream>
#include <sstream>

#include <pcl/PCLPointCloud2.h>
#include <pcl/io/pcd_io.h>

#include <nlohmann/json.hpp>

#include <pcl_cid/exceptions.h>

#include "depth_sensor.h"
#include "scan_cloud.h"
#include "scan_positions.h"

namespace pcl_cid::test {
namespace {

using Json = nlohmann::ordered_json;

RoomOptions
sampleRoomOptions()
{
  RoomOptions options;
  options.seed = 7;
  return options;
}

SensorOptions
sampleSensorOptions()
{
  SensorOptions options;
  options.seed = 7;
  options.points = 140000;
  options.positions = 4;
  return options;
}

Json
describe(const Range& range)
{
  return {range.low, range.high};
}

Json
describe(const RoomOptions& options)
{
  return {{"seed", options.seed},
          {"width", describe(options.width)},
          {"depth", describe(options.depth)},
          {"height", describe(options.height)},
          {"doors", options.doors},
          {"windows", options.windows},
          {"beams", options.beams},
          {"columns", options.columns},
          {"bookcases", options.bookcases},
          {"boards", options.boards},
          {"sofas", options.sofas},
          {"tables", options.tables},
          {"chairs", options.chairs},
          {"clutter", options.clutter}};
}

Json
describe(const SensorOptions& options)
{
  return {{"seed", options.seed},
          {"points", options.points},
          {"positions", options.positions},
          {"height", describe(options.height)},
          {"max_elevation_sine", options.max_elevation_sine},
          {"noise", options.noise},
          {"range", describe(options.range)},
          {"min_incidence_cosine", options.min_incidence_cosine}};
}

Json
describeInstances(const RoomScene& scene, const LabelledScan& scan)
{
  std::vector<std::size_t> sizes(scene.class_of_instance.size(), 0);
  for (const std::uint32_t instance : scan.instance)
    ++sizes[instance];
  Json instances = Json::array();
  for (std::size_t i = 1; i < sizes.size(); ++i) {
    const auto semantic = static_cast<std::size_t>(scene.class_of_instance[i]);
    instances.push_back({{"label", i},
                         {"semantic", semantic},
                         {"class", scan.class_names[semantic]},
                         {"points", sizes[i]}});
  }
  return instances;
}

Json
describe(const RoomScene& scene, const LabelledScan& scan)
{
  return {{"cloud", "room.pcd"},
          {"room_options", describe(sampleRoomOptions())},
          {"sensor_options", describe(sampleSensorOptions())},
          {"room_size", {scene.size.x(), scene.size.y(), scene.size.z()}},
          {"sensor_positions", positionsOf(scan)},
          {"class_names", scan.class_names},
          {"instances", describeInstances(scene, scan)}};
}

/// To a string first: PCL's writer to files pads them to the machine's page size.
std::string
compress(const pcl::PCLPointCloud2& cloud)
{
  std::ostringstream stream(std::ios::binary);
  if (pcl::PCDWriter().writeBinaryCompressed(stream, cloud) != 0)
    throw CIDException("PCL could not compress the sample scan; allowed are clouds "
                       "below 4 GB");
  return stream.str();
}

void
writeFile(const std::string& path, const std::string& bytes)
{
  std::ofstream file(path, std::ios::binary);
  file << bytes;
  file.close();
  if (!file)
    throw CIDException("cannot write " + path +
                       "; allowed is a file in an existing, writable folder");
}

} // namespace

void
writeSampleScan(const std::string& folder)
{
  const RoomScene scene = makeRoom(sampleRoomOptions());
  const LabelledScan scan = scanRoom(scene, sampleSensorOptions());
  writeFile(folder + "/room.pcd", compress(cloudOf(scan)));
  writeFile(folder + "/room_truth.json", describe(scene, scan).dump(2) + "\n");
}

} // namespace pcl_cid::test
