/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Not installed: writes a set of generated rooms with their truth, for the experiments.
 */

#include "even_sampler.h"
#include "room_set.h"
#include "run/command_line.h"
#include "run/run.h"
#include "scan_cloud.h"
#include "scan_positions.h"

#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/output_files.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <string>

namespace {

using namespace pcl_cid;
using namespace pcl_cid::test;
using namespace pcl_cid::tools;

constexpr const char* tool = "cid_room_set";

enum class RoomScan { sensor, even };

constexpr NumberSetting<unsigned> rooms_setting{
    "Options", "rooms", "number of rooms", "N", "", 20, 1, 1000, "number of rooms"};

constexpr NumberSetting<std::size_t> points_setting{"Options",
                                                    "points",
                                                    "number of points",
                                                    "P",
                                                    "",
                                                    200000,
                                                    1,
                                                    100000000,
                                                    "points of each room"};

constexpr ChoiceSetting<RoomScan, 2> scan_setting{
    "Options",
    "scan",
    "HOW",
    RoomScan::sensor,
    {{{"sensor", RoomScan::sensor}, {"even", RoomScan::even}}},
    "seen by a depth sensor with noise, or points drawn evenly by area: sensor or "
    "even"};

struct RoomSetSettings {
  std::string folder;
  unsigned rooms = rooms_setting.initial;
  std::size_t points = points_setting.initial;
  std::uint64_t random_seed = setting::random_seed.initial;
  RoomScan scan = scan_setting.initial;
};

bool
readCommandLine(int argc, const char* const* argv, RoomSetSettings& settings)
{
  CommandLine line(
      tool,
      "cid_room_set FOLDER [options]",
      "Write generated rooms, each another one, as FOLDER/room_00.pcd and so on, with\n"
      "the fields x y z, label (the true instance) and semantic (its class: the 13 of\n"
      "S3DIS, from 1 for ceiling to 13 for clutter); FOLDER/room_00_truth.json says\n"
      "where the sensor stood. The same bytes for the same options on every machine;\n"
      "a smaller set is the beginning of a larger one.");
  line.group("Options");
  line.setting(rooms_setting, settings.rooms);
  line.setting(points_setting, settings.points);
  line.setting(setting::random_seed, settings.random_seed);
  line.choice(scan_setting, settings.scan);
  line.helpOptions();
  return line.parse(argc, argv, {&settings.folder}, "FOLDER");
}

/** Without its extension. */
std::string
pathOf(const RoomSetSettings& settings, unsigned room)
{
  const std::string number = std::to_string(room);
  const std::size_t digits = std::max<std::size_t>(2, number.size());
  return settings.folder + "/room_" + std::string(digits - number.size(), '0') + number;
}

/** The scan, and what its fields do not say, beside it. */
std::array<std::string, 2>
filesOf(const RoomSetSettings& settings, unsigned room)
{
  const std::string path = pathOf(settings, room);
  return {path + ".pcd", path + "_truth.json"};
}

LabelledScan
scanOf(const RoomSetSettings& settings, unsigned room)
{
  const std::uint64_t seed = seedOfRoom(settings.random_seed, room);
  const RoomScene scene = makeVariousRoom(seed);
  return settings.scan == RoomScan::sensor
             ? scanVariousRoom(scene, settings.points, seed)
             : sampleRoomEvenly(scene, settings.points, seed);
}

void
writeRooms(const RoomSetSettings& settings)
{
  OutputFiles outputs({});
  outputs.announceFolder(settings.folder);
  for (unsigned room = 0; room < settings.rooms; ++room)
    for (const std::string& file : filesOf(settings, room))
      outputs.announce(file);
  for (unsigned room = 0; room < settings.rooms; ++room) {
    const auto [cloud_file, truth_file] = filesOf(settings, room);
    const LabelledScan scan = scanOf(settings, room);
    LabelledCloud cloud;
    cloud.fields = cloudOf(scan);
    outputs.write(cloud_file, [&](std::ostream& stream) {
      writeCloud(stream, cloud, cloud.layout);
    });
    outputs.write(truth_file, [&](std::ostream& stream) {
      stream << nlohmann::ordered_json{{"sensor_positions", positionsOf(scan)}}.dump(2)
             << '\n';
    });
  }
  outputs.commit();
}

} // namespace

int
main(int argc, char** argv)
{
  return runTool(tool, [&] {
    RoomSetSettings settings;
    if (readCommandLine(argc, argv, settings))
      writeRooms(settings);
  });
}
