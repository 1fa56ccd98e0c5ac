/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Not installed: writes a set of generated rooms with their truth, for the experiments.
 */

#include "colored_room.h"
#include "even_sampler.h"
#include "room_set.h"
#include "run/command_line.h"
#include "run/run.h"
#include "scan_cloud.h"
#include "scan_kinds.h"
#include "scan_paint.h"
#include "scan_positions.h"

#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/output_files.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace {

using namespace pcl_cid;
using namespace pcl_cid::test;
using namespace pcl_cid::tools;

constexpr const char* tool = "cid_room_set";

enum class RoomSet { plain, colored };

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

constexpr ChoiceSetting<RoomSet, 2> set_setting{
    "Options",
    "set",
    "WHICH",
    RoomSet::plain,
    {{{"plain", RoomSet::plain}, {"colored", RoomSet::colored}}},
    "rooms without colors, or smaller ones with colors and with posters, rugs, books, "
    "curtains, people and doors in the plane of the wall: plain or colored"};

constexpr ChoiceSetting<ScanKind, 6> scan_setting{
    "Options",
    "scan",
    "HOW",
    ScanKind::sensor,
    {{{"sensor", ScanKind::sensor},
      {"even", ScanKind::even},
      {"merged", ScanKind::merged},
      {"mesh_vertices", ScanKind::mesh_vertices},
      {"single_view", ScanKind::single_view},
      {"lidar", ScanKind::lidar}}},
    "seen by a depth sensor with noise from some places; points drawn evenly by area; "
    "scans of different density and exposure, not quite aligned; spaced as the "
    "vertices "
    "of a simplified mesh; one image; a scanner on a tripod: sensor, even, merged, "
    "mesh_vertices, single_view or lidar"};

struct RoomSetSettings {
  std::string folder;
  unsigned rooms = rooms_setting.initial;
  std::size_t points = points_setting.initial;
  std::uint64_t random_seed = setting::random_seed.initial;
  RoomSet set = set_setting.initial;
  ScanKind scan = scan_setting.initial;
};

bool
readCommandLine(int argc, const char* const* argv, RoomSetSettings& settings)
{
  CommandLine line(
      tool,
      "cid_room_set FOLDER [options]",
      "Write generated rooms, each another one, as FOLDER/room_00.pcd and so on, with\n"
      "the fields x y z, label (the true instance) and semantic (its class: the 13 of\n"
      "S3DIS, from 1 for ceiling to 13 for clutter), and rgb in a colored set;\n"
      "FOLDER/room_00_truth.json says where the sensor stood and, in a colored set,\n"
      "what each instance is. The same bytes for the same options on every machine; a\n"
      "smaller set is the beginning of a larger one.");
  line.group("Options");
  line.setting(rooms_setting, settings.rooms);
  line.setting(points_setting, settings.points);
  line.setting(setting::random_seed, settings.random_seed);
  line.choice(set_setting, settings.set);
  line.choice(scan_setting, settings.scan);
  line.helpOptions();
  return line.parse(argc, argv, {FileArgument{"FOLDER", {}}}, {&settings.folder});
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

/** Points and truth of a room. */
struct ScannedRoom {
  LabelledScan scan;
  std::vector<std::string> names; ///< of the instances; none in a plain set
};

ScannedRoom
scanPlainRoom(const RoomSetSettings& settings, std::uint64_t seed)
{
  const RoomScene scene = makeVariousRoom(seed);
  if (settings.scan == ScanKind::sensor)
    return {scanVariousRoom(scene, settings.points, seed), {}};
  if (settings.scan == ScanKind::even)
    return {sampleRoomEvenly(scene, settings.points, seed), {}};
  LabelledScan scan = choosePoints(scene, settings.scan, settings.points, seed);
  disturb(scan, usualErrors(settings.scan), seed);
  return {scan, {}};
}

ScannedRoom
scanColoredRoom(const RoomSetSettings& settings, std::uint64_t seed)
{
  const ColoredRoom room = makeColoredRoom(seed);
  LabelledScan scan = choosePoints(room.scene, settings.scan, settings.points, seed);
  paintScan(room, scan);
  disturb(scan, usualErrors(settings.scan), seed);
  return {scan, room.names};
}

ScannedRoom
scanRoomOf(const RoomSetSettings& settings, unsigned room)
{
  const std::uint64_t seed = seedOfRoom(settings.random_seed, room);
  return settings.set == RoomSet::plain ? scanPlainRoom(settings, seed)
                                        : scanColoredRoom(settings, seed);
}

nlohmann::ordered_json
truthOf(const ScannedRoom& room)
{
  nlohmann::ordered_json truth{{"sensor_positions", positionsOf(room.scan)}};
  for (std::size_t label = 1; label < room.names.size(); ++label)
    truth["instances"].push_back({{"label", label}, {"name", room.names[label]}});
  return truth;
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
    const ScannedRoom scanned = scanRoomOf(settings, room);
    LabelledCloud cloud;
    cloud.fields = cloudOf(scanned.scan);
    outputs.write(cloud_file, [&](std::ostream& stream) {
      writeCloud(stream, cloud, cloud.layout);
    });
    outputs.write(truth_file, [&](std::ostream& stream) {
      stream << truthOf(scanned).dump(2) << '\n';
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
