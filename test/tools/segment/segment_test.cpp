/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_segment: every point and field stays, groups are those of the class.
 */

#include "segment_tool.h"

#include <pcl_cid/cid_label_propagation.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {
namespace {

using Labels = std::vector<std::uint32_t>;

using Labels = std::vector<std::uint32_t>;

TEST_F(SegmentTool, KeepsEveryPointFieldShapeAndPose)
{
  const std::string bytes = readText(scan_);
  const auto modified = std::filesystem::last_write_time(scan_);
  segment({scan_, file("out.pcd")});
  EXPECT_EQ(readText(scan_), bytes);
  EXPECT_EQ(std::filesystem::last_write_time(scan_), modified);
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"out.pcd", "scan.pcd"}));

  const LoadedByPCL before = loadWithPCL(scan_);
  const LoadedByPCL after = loadWithPCL(file("out.pcd"));
  EXPECT_EQ(after.cloud.width, 40u);
  EXPECT_EQ(after.cloud.height, 30u);
  EXPECT_EQ(after.origin, before.origin);
  EXPECT_EQ(after.orientation.coeffs(), before.orientation.coeffs());
  ASSERT_EQ(after.cloud.fields.size(), before.cloud.fields.size() + 1);
  for (std::size_t i = 0; i < before.cloud.fields.size(); ++i) {
    const std::string& name = before.cloud.fields[i].name;
    EXPECT_EQ(after.cloud.fields[i].name, name);
    EXPECT_EQ(bytesOf(after.cloud, name), bytesOf(before.cloud, name)) << name;
  }
  EXPECT_EQ(after.cloud.fields.back().name, "label");
  EXPECT_EQ(after.cloud.fields.back().datatype, pcl::PCLPointField::UINT32);
}

TEST_F(SegmentTool, KeepsAnOrganisedScanOfACamera)
{
  const std::string scan = PCL_CID_SHARED_DIR "/data/office1.pcd";
  if (!std::filesystem::exists(scan))
    GTEST_SKIP() << scan << " is absent";
  segment({scan, file("out.pcd"), "--subsample", "1000"});
  const LoadedByPCL before = loadWithPCL(scan);
  const LoadedByPCL after = loadWithPCL(file("out.pcd"));
  EXPECT_EQ(after.cloud.width, 640u);
  EXPECT_EQ(after.cloud.height, 480u);
  EXPECT_EQ(after.orientation.coeffs(), before.orientation.coeffs());
  for (const char* const name : {"x", "y", "z", "rgb"})
    EXPECT_EQ(bytesOf(after.cloud, name), bytesOf(before.cloud, name)) << name;
}

TEST_F(SegmentTool, LabelsByGroupAsTheClassDoes)
{
  segment({scan_, file("out.pcd")});
  const CloudPoints points = pointsOf(deskScan());
  CIDLabelPropagation<pcl::PointXYZ> propagation;
  propagation.setInputCloud(points.points);
  propagation.setNumberOfSeeds(12);
  Labels expected;
  propagation.segment(expected);
  const Labels labels = labelsIn(file("out.pcd"));
  EXPECT_EQ(labels, expected);
  const std::set<std::uint32_t> used(labels.begin(), labels.end());
  EXPECT_EQ(used.size(), 13u); // 12 groups, and 0
  EXPECT_EQ(*used.rbegin(), 12u);
  for (std::size_t i = 0; i < labels.size(); ++i)
    EXPECT_EQ(labels[i] == 0, deskLabels()[i] == 0) << i;
}

TEST_F(SegmentTool, GivesTheSameBytesForEveryNumberOfThreads)
{
  segment({scan_, file("1.pcd"), "--threads", "1", "--subsample", "800"});
  for (const char* const threads : {"2", "3", "8"}) {
    const std::string out = file(std::string(threads) + ".pcd");
    segment({scan_, out, "--threads", threads, "--subsample", "800"});
    EXPECT_EQ(readText(out), readText(file("1.pcd"))) << threads << " threads";
  }
}

TEST_F(SegmentTool, DrawsBySeed)
{
  segment({scan_, file("a.pcd"), "--random-seed", "1", "--subsample", "300"});
  segment({scan_, file("b.pcd"), "--random-seed", "1", "--subsample", "300"});
  segment({scan_, file("c.pcd"), "--random-seed", "2", "--subsample", "300"});
  EXPECT_EQ(labelsIn(file("a.pcd")), labelsIn(file("b.pcd")));
  EXPECT_NE(labelsIn(file("a.pcd")), labelsIn(file("c.pcd")));
}

TEST_F(SegmentTool, ReadsAndWritesEveryFormat)
{
  segment({scan_, file("out.pcd")});
  const Labels labels = labelsIn(file("out.pcd"));
  for (const auto& [name, format] : {std::pair("a.pcd", pcd_ascii),
                                     std::pair("b.pcd", pcd_binary),
                                     std::pair("c.ply", ply_ascii),
                                     std::pair("d.ply", ply_binary)}) {
    saveCloud(file(name), deskScan(), format);
    for (const char* const output : {"out.ply", "out.pcd"}) {
      segment({file(name), file(output)});
      const LabelledCloud result = readCloud(file(output));
      EXPECT_EQ(result.layout, layoutFor(output, format));
      EXPECT_EQ(valuesOf<std::uint32_t>(result.fields, "label"), labels) << name;
      EXPECT_EQ(bytesOf(result.fields, "rgb"), bytesOf(deskScan().fields, "rgb"));
      EXPECT_EQ(result.fields.width, 40u);
      EXPECT_EQ(result.fields.height, 30u);
    }
  }
}

/** The desk scan on a grid of 2^-10 m about the origin, scaled and shifted. */
template <typename Value>
LabelledCloud
movedScan(double scale, const Eigen::Vector3d& shift)
{
  const CloudPoints points = pointsOf(deskScan());
  std::vector<Value> coordinates[3];
  for (const pcl::PointXYZ& point : *points.points) {
    const Eigen::Vector3d p = point.getVector3fMap().cast<double>();
    const Eigen::Vector3d centered = p - Eigen::Vector3d(0.0, 0.0, 1.5);
    for (int axis = 0; axis < 3; ++axis)
      coordinates[axis].push_back(static_cast<Value>(
          scale * std::round(1024.0 * centered[axis]) / 1024.0 + shift[axis]));
  }
  LabelledCloud moved;
  appendField("x", coordinates[0], moved.fields);
  appendField("y", coordinates[1], moved.fields);
  appendField("z", coordinates[2], moved.fields);
  return moved;
}

TEST_F(SegmentTool, GivesTheSameLabelsInOtherUnitsAndFrames)
{
  const Eigen::Vector3d zero(0, 0, 0);
  const Eigen::Vector3d utm(524288, 4194304, 0);
  saveCloud(file("m.pcd"), movedScan<float>(1, zero), pcd_binary);
  saveCloud(file("mm.pcd"), movedScan<float>(1024, zero), pcd_binary);
  saveCloud(file("utm.pcd"), movedScan<double>(1, utm), pcd_binary);
  saveCloud(file("utm.ply"), movedScan<double>(1, utm), ply_ascii);
  // The normal weight is a length, in the unit of the coordinates.
  const std::string weight = std::to_string(setting::normals.initial);
  const std::string of_mm = std::to_string(1024 * setting::normals.initial);
  segment({file("m.pcd"),
           file("out.pcd"),
           "--propose",
           file("m.csv"),
           "--normals",
           weight});
  const Labels labels = labelsIn(file("out.pcd"));
  for (const char* const moved : {"mm.pcd", "utm.pcd", "utm.ply"}) {
    segment({file(moved),
             file("out.pcd"),
             "--propose",
             file("moved.csv"),
             "--normals",
             std::string(moved) == "mm.pcd" ? of_mm : weight});
    EXPECT_EQ(labelsIn(file("out.pcd")), labels) << moved;
    const LabelledCloud kept = readCloud(file("out.pcd"));
    const LabelledCloud before = readCloud(file(moved));
    for (const char* const axis : {"x", "y", "z"})
      EXPECT_EQ(bytesOf(kept.fields, axis), bytesOf(before.fields, axis)) << moved;
  }
  const std::string table = readText(file("moved.csv"));
  EXPECT_NE(table.find(",4194304"), std::string::npos) << table;
}

TEST_F(SegmentTool, StopsAtTheCoverage)
{
  segment({scan_, file("out.pcd"), "--report", file("report.json")});
  const double twelve = report()["seeds"].back()["coverage"];
  const ToolRun done = run(
      "pcl_cid_segment",
      {scan_, file("out.pcd"), "--coverage", "0.02", "--report", file("report.json")});
  EXPECT_EQ(done.exit_code, 0);
  const nlohmann::json seeds = report()["seeds"];
  EXPECT_LE(seeds.back()["coverage"], 0.02);
  EXPECT_GT(seeds[seeds.size() - 2]["coverage"], 0.02);
  ASSERT_GT(twelve, 0.02);
  EXPECT_GT(seeds.size(), 12u);
  segment({scan_,
           file("out.pcd"),
           "--coverage",
           "0.02",
           "--report",
           file("report.json")}); // and 12 seeds: whichever comes first
  EXPECT_EQ(report()["seeds"].size(), 12u);
}

TEST_F(SegmentTool, ReportsWhatItDid)
{
  segment(
      {scan_, file("out.pcd"), "--report", file("report.json"), "--random-seed", "5"});
  const nlohmann::json json = report();
  EXPECT_EQ(json["tool"], "pcl_cid_segment");
  EXPECT_EQ(json["input"], scan_);
  EXPECT_EQ(json["parameters"]["seeds"], 12);
  EXPECT_EQ(json["parameters"]["random_seed"], 5);
  EXPECT_EQ(json["points"]["in"], 1200);
  EXPECT_EQ(json["points"]["finite"], json["points"]["grouped"]);
  std::size_t points = 0;
  double coverage = std::numeric_limits<double>::infinity();
  for (const nlohmann::json& seed : json["seeds"]) {
    points += seed["points"].get<std::size_t>();
    EXPECT_LE(seed["coverage"], coverage);
    coverage = seed["coverage"];
  }
  EXPECT_EQ(json["points"]["grouped"], points);
  for (const char* const step : {"load", "segment", "save"})
    EXPECT_GE(json["seconds"][step], 0.0);
  EXPECT_GT(json["peak_memory_bytes"], 0);
}

TEST_F(SegmentTool, PrintsPlainTextToFilesAndABarToTerminals)
{
  const std::vector<std::string> arguments{scan_, file("out.pcd"), "--seeds", "12"};
  const ToolRun plain = run("pcl_cid_segment", arguments);
  EXPECT_EQ(plain.err, "");
  EXPECT_EQ(plain.out.find('\033'), std::string::npos);
  EXPECT_EQ(plain.out.find('\r'), std::string::npos);
  EXPECT_NE(plain.out.find("Loading " + scan_ + " [done, "), std::string::npos);
  const ToolRun shown =
      ToolProcess("pcl_cid_segment", arguments, printed_, true).wait();
  EXPECT_EQ(shown.exit_code, 0);
  EXPECT_NE(shown.err.find("\rSegmenting ["), std::string::npos) << shown.err;
  EXPECT_NE(shown.err.find(" %"), std::string::npos) << shown.err;
  const std::string erased = "\r\033[K";
  EXPECT_EQ(shown.err.find(erased), shown.err.size() - erased.size()) << shown.err;
  EXPECT_EQ(linesOf(shown.out), linesOf(plain.out));
  std::vector<std::string> quiet = arguments;
  quiet.push_back("--quiet");
  const ToolRun silent = ToolProcess("pcl_cid_segment", quiet, printed_, true).wait();
  EXPECT_EQ(silent.exit_code, 0);
  EXPECT_EQ(silent.out + silent.err, "");
}

} // namespace
} // namespace pcl_cid::test
