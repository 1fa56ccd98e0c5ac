/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The options for raw scans: what they change, what the report says, what is refused.
 */

#include "lidar_scan.h"
#include "tool_process.h"

#include "scan/local_spacing.h"

#include <pcl_cid/cid_label_propagation.h>

#include <array>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {
namespace {

class RawScanOptions : public ToolTest {
protected:
  /** \brief The report of pcl_cid_segment. */
  nlohmann::json
  reportOf(std::vector<std::string> arguments) const
  {
    std::vector<std::string> all{scan_, file("out.pcd"), "--report", file("r.json")};
    all.insert(all.end(), arguments.begin(), arguments.end());
    segment(all);
    return nlohmann::json::parse(readText(file("r.json")));
  }

  void
  expectRefused(const std::string& tool,
                std::vector<std::string> arguments,
                int exit_code,
                const std::string& what) const
  {
    const bool abstracts = tool == "pcl_cid_abstract";
    arguments.insert(arguments.begin(), {scan_, file(abstracts ? "o.obj" : "o.pcd")});
    const ToolRun refused = run(tool, arguments);
    EXPECT_EQ(refused.exit_code, exit_code) << refused.err;
    EXPECT_NE(refused.err.find(what), std::string::npos) << refused.err;
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"scan.pcd"});
  }
};

TEST_F(RawScanOptions, AreDecidedAndReported)
{
  const nlohmann::json by_default = reportOf({});
  const nlohmann::json& parameters = by_default["parameters"];
  EXPECT_EQ(parameters["density"], "auto");
  EXPECT_EQ(parameters["density_power"], 1.0);
  EXPECT_EQ(parameters["isolated_neighbors"], 4);
  EXPECT_EQ(parameters["seeding"], "farthest");
  EXPECT_EQ(parameters["color"], 0.0);
  EXPECT_EQ(parameters["normals"], 0.03);
  EXPECT_EQ(parameters["connected"], "on");
  const double spread = by_default["density"]["spread"];
  EXPECT_EQ(by_default["density"]["weighted"], spread >= uneven_spread);
  EXPECT_GE(by_default["density"]["isolated_points"], 0);

  EXPECT_EQ(reportOf({"--density", "on"})["density"]["weighted"], true);
  const nlohmann::json off = reportOf({"--paper"})["density"];
  EXPECT_EQ(off["weighted"], false);
  EXPECT_TRUE(off["spread"].is_null()) << "nothing needs it";
  EXPECT_EQ(off["isolated_points"], 0);
}

/** What is given counts, wherever it stands. */
TEST_F(RawScanOptions, AreThoseOfThePaperButForWhatIsGiven)
{
  const nlohmann::json paper = reportOf({"--paper"})["parameters"];
  std::size_t found = 0;
  forEachSetting([&](const auto& row) {
    if (!paper.contains(row.name) || !row.in_paper)
      return;
    ++found;
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(row.initial)>> &&
                  !std::is_same_v<std::decay_t<decltype(row.initial)>, bool>)
      EXPECT_EQ(paper[row.name], row.paper()) << row.name;
    else
      EXPECT_EQ(paper[row.name], row.wordOf(row.paper())) << row.name;
  });
  EXPECT_GE(found, 3u);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--paper", "--density", "on"},
        std::vector<std::string>{"--density", "on", "--paper"}}) {
    const nlohmann::json given = reportOf(arguments)["parameters"];
    EXPECT_EQ(given["density"], "on");
    EXPECT_EQ(given["isolated_neighbors"], 0);
  }
}

TEST_F(RawScanOptions, OfThePaperDoNothingToAHeatMap)
{
  expectRefused("pcl_cid_segment", {"--cid-from", "0", "--paper"}, 2, "--paper");
}

TEST_F(RawScanOptions, DoWhatTheClassDoes)
{
  segment({scan_,
           file("out.pcd"),
           "--density",
           "on",
           "--density-power",
           "0.5",
           "--isolated-neighbors",
           "2",
           "--seeding",
           "soft",
           "--color",
           "0.002"});
  const LabelledCloud scan = deskScan();
  CIDLabelPropagation<pcl::PointXYZ> propagation;
  propagation.setInputCloud(pointsOf(scan).points);
  propagation.setNumberOfSeeds(12);
  propagation.setDensityWeight(DensityWeight::on);
  propagation.setDensityPower(0.5f);
  propagation.setIsolatedNeighbors(2);
  propagation.setSeedingRule(SeedingRule::soft);
  propagation.setColorWeight(0.002f);
  propagation.setColors(std::make_shared<const std::vector<ColorRGB>>(colorsOf(scan)));
  std::vector<std::uint32_t> expected;
  propagation.segment(expected);
  EXPECT_EQ(valuesOf<std::uint32_t>(readCloud(file("out.pcd")).fields, "label"),
            expected);
}

TEST_F(RawScanOptions, AreTakenByBothTools)
{
  const ToolRun done = run("pcl_cid_abstract",
                           {scan_,
                            file("o.obj"),
                            "--seeds",
                            "12",
                            "--density",
                            "on",
                            "--color",
                            "0.001",
                            "--report",
                            file("r.json")});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NE(done.out.find("Density weight: on"), std::string::npos) << done.out;
  EXPECT_EQ(nlohmann::json::parse(readText(file("r.json")))["density"]["weighted"],
            true);
}

/// The viewpoint of a file says where the sensor was, in doubles far from the origin,
/// too: a scan at UTM coordinates has the same blind spot in its own frame.
TEST_F(RawScanOptions, FillTheBlindSpotUnderTheViewpointOfAFile)
{
  const Eigen::Vector3d utm(500000.0, 4000000.0, 100.0);
  std::array<std::vector<double>, 3> columns;
  for (const Eigen::Vector3f& p : lidarScan({}))
    for (int axis = 0; axis < 3; ++axis)
      columns[static_cast<std::size_t>(axis)].push_back(double{p[axis]} + utm[axis]);
  LabelledCloud scan;
  for (std::size_t axis = 0; axis < 3; ++axis)
    appendField<double>(std::string(1, "xyz"[axis]), columns[axis], scan.fields);
  scan.sensor_origin.head<3>() = utm.cast<float>();
  saveCloud(scan_, scan, pcd_binary);
  const nlohmann::json filled = reportOf({});
  EXPECT_EQ(filled["parameters"]["blind_spot"], "auto");
  const nlohmann::json& spot = filled["blind_spot"];
  EXPECT_NEAR(spot["centre"][0], utm.x(), 0.02);
  EXPECT_NEAR(spot["centre"][1], utm.y(), 0.02);
  EXPECT_NEAR(spot["centre"][2], utm.z() - 1.3, 0.02);
  EXPECT_NEAR(spot["radius"], 1.03, 0.05);
  EXPECT_GT(spot["points"], 100);

  const nlohmann::json unfilled = reportOf({"--blind-spot", "off"});
  EXPECT_EQ(unfilled["parameters"]["blind_spot"], "off");
  EXPECT_FALSE(unfilled.contains("blind_spot"));
  const ToolRun said = run("pcl_cid_abstract", {scan_, file("o.obj")});
  EXPECT_NE(said.out.find("Blind spot: floor within 1."), std::string::npos)
      << said.out << said.err;
}

TEST_F(RawScanOptions, NeedColors)
{
  LabelledCloud scan;
  appendField<float>("x", {0, 1, 2}, scan.fields);
  appendField<float>("y", {0, 1, 0}, scan.fields);
  appendField<float>("z", {0, 0, 1}, scan.fields);
  saveCloud(scan_, scan, pcd_binary);
  for (const char* const tool : {"pcl_cid_segment", "pcl_cid_abstract"})
    expectRefused(tool, {"--color", "0.001"}, 1, scan_ + ": has no colors");
}

TEST_F(RawScanOptions, AreRefusedOutOfTheirRange)
{
  for (const char* const tool : {"pcl_cid_segment", "pcl_cid_abstract"}) {
    expectRefused(tool, {"--density", "yes"}, 2, "auto, off or on");
    expectRefused(tool, {"--density-power", "5"}, 2, "0 to 4");
    expectRefused(tool, {"--isolated-neighbors", "9"}, 2, "0 to 8");
    expectRefused(tool, {"--seeding", "near"}, 2, "farthest or soft");
    expectRefused(tool, {"--color", "-1"}, 2, "0 or more");
    expectRefused(tool, {"--blind-spot", "on"}, 2, "auto or off");
  }
  expectRefused("pcl_cid_segment", {"--clean-up", "yes"}, 2, "off or on");
}

TEST_F(RawScanOptions, AreRefusedWhereTheyHaveNoEffect)
{
  expectRefused(
      "pcl_cid_segment", {"--cid-from", "0", "--density", "on"}, 2, "density");
  expectRefused(
      "pcl_cid_segment", {"--cid-from", "0", "--clean-up", "on"}, 2, "clean-up");
  expectRefused(
      "pcl_cid_segment", {"--labels", "s.csv", "--seeding", "soft"}, 2, "seeding");
}

} // namespace
} // namespace pcl_cid::test
