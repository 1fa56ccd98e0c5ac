/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How good the labels are: floors for a set of generated rooms, and a plainer method.
 */

#include "tool_process.h"

#include "room_set.h"
#include "scan_cloud.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {
namespace {

constexpr unsigned rooms = 3;
constexpr std::size_t points_of_room = 30000;
constexpr std::size_t seeds = 100; // as in the paper

/** Measured on these rooms with ten random starts (--random-seed 0 to 9): AP50 0.875 to
 *  0.933, purity 0.909 to 0.930; with the settings of the paper (--density off
 *  --isolated-neighbors 0) 0.651 to 0.771 and 0.848 to 0.861. The floors are the worst
 *  of the ten, less 0.05 and less 0.02 for what another start may do. The best of ten
 *  starts of the plainer method was at 0.481 and 0.762. */
constexpr double least_ap50 = 0.875 - 0.05;
constexpr double least_purity = 0.909 - 0.02;

/** The plainer method: farthest-first seeds, and the nearest seed for each point, both
 *  by the straight distance. Ties go to the lower index and the earlier seed. */
std::vector<std::uint32_t>
labelsByDistance(const LabelledScan& scan, std::size_t first)
{
  std::vector<float> distance(scan.points.size(),
                              std::numeric_limits<float>::infinity());
  std::vector<std::uint32_t> labels(scan.points.size());
  std::size_t seed = first;
  for (std::size_t k = 0; k < seeds; ++k) {
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const float to_seed = (scan.points[i] - scan.points[seed]).squaredNorm();
      if (to_seed >= distance[i])
        continue;
      distance[i] = to_seed;
      labels[i] = scan.instance[seed];
    }
    seed = static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) -
                                    distance.begin());
  }
  return labels;
}

class QualityOfRooms : public ToolTest {
protected:
  QualityOfRooms()
  {
    for (const char* const name : {"truth", "cid", "distance"})
      std::filesystem::create_directory(file(name));
    for (unsigned room = 0; room < rooms; ++room)
      labelRoom(room);
  }

  nlohmann::json
  scoreOf(const std::string& prediction) const
  {
    const ToolRun scored =
        run("pcl_cid_evaluate",
            {file(prediction), file("truth"), "--report", file(prediction + ".json")});
    EXPECT_EQ(scored.exit_code, 0) << scored.err;
    return nlohmann::json::parse(readText(file(prediction + ".json")));
  }

private:
  void
  labelRoom(unsigned room)
  {
    const std::uint64_t seed = seedOfRoom(0, room);
    const LabelledScan scan =
        scanVariousRoom(makeVariousRoom(seed), points_of_room, seed);
    const std::string name = "/room_" + std::to_string(room) + ".pcd";
    LabelledCloud cloud;
    cloud.fields = cloudOf(scan);
    saveCloud(file("truth") + name, cloud, pcd_binary);
    const std::size_t start = points_of_room / 2;
    const ToolRun segmented = run("pcl_cid_segment",
                                  {file("truth") + name,
                                   file("cid") + name,
                                   "--labels-from",
                                   "label",
                                   "--seeds",
                                   std::to_string(seeds),
                                   "--start-index",
                                   std::to_string(start)});
    ASSERT_EQ(segmented.exit_code, 0) << segmented.err;
    setLabels(labelsByDistance(scan, start), LabelType::U4, cloud);
    saveCloud(file("distance") + name, cloud, pcd_binary);
  }
};

TEST_F(QualityOfRooms, IsAboveItsFloorsAndThatOfThePlainDistance)
{
  const nlohmann::json cid = scoreOf("cid");
  const double ap50 = cid["mean"]["ap50"];
  const double purity = cid["purity"];
  EXPECT_GE(ap50, least_ap50);
  EXPECT_GE(purity, least_purity);

  const nlohmann::json distance = scoreOf("distance");
  EXPECT_GT(ap50, distance["mean"]["ap50"]);
  EXPECT_GT(purity, distance["purity"]);
}

} // namespace
} // namespace pcl_cid::test
