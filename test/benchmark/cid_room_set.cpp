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
#include "scan_cloud.h"
#include "scan_positions.h"
#include "tool_run.h"

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

enum class RoomScan : std::size_t { sensor, even };

struct RoomSetSettings {
  std::string folder;
  unsigned rooms = 20;
  std::size_t points = 200000;
  std::uint64_t random_seed = 0;
  std::size_t scan = 0; ///< as in RoomScan
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
  line.number("rooms",
              "N",
              {1u, 1000u, "a whole number, 1 to 1000"},
              settings.rooms,
              "number of rooms");
  line.number(
      "points",
      "P",
      {std::size_t{1}, std::size_t{100000000}, "a whole number, 1 to 100000000"},
      settings.points,
      "points of each room");
  line.number("random-seed",
              "S",
              {0, UINT64_MAX, "a whole number, 0 to 18446744073709551615"},
              settings.random_seed,
              "of every random draw");
  line.choice(
      "scan",
      "HOW",
      {"sensor", "even"},
      settings.scan,
      "seen by a depth sensor with noise, or points drawn evenly by area: sensor "
      "or even");
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
  return static_cast<RoomScan>(settings.scan) == RoomScan::sensor
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
