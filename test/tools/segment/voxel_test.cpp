/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scans of which one point of each voxel is worked on: the same as by hand.
 */

#include "clouds.h"
#include "segment_tool.h"
#include "voxel_choice.h"

#include <pcl_cid/io/seed_table.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <regex>

namespace pcl_cid::test {
namespace {

using Labels = std::vector<std::uint32_t>;

/** A cloud by hand: the points that are chosen, and whom each point follows, as brute
 *  force has it. */
class VoxelTool : public SegmentTool {
protected:
  /** The tool does in one call what can be done by hand. */
  void
  expectAsByHand(const std::string& scan,
                 double size,
                 const std::vector<std::string>& more = {},
                 std::size_t stride = 1)
  {
    SCOPED_TRACE(scan);
    source_ = chooseFrom(scan, size, chosen_);
    const auto run = [&](std::vector<std::string> arguments) {
      arguments.insert(arguments.end(), more.begin(), more.end());
      segment(arguments);
    };
    run({chosen_, file("by_hand.pcd")});
    run({scan, file("out.ply"), "--voxel", std::to_string(size)});
    run({scan, file("out.pcd"), "--voxel", std::to_string(size)});
    Labels expected = labelsIn(file("out.pcd"));
    findByBruteForce(scan, source_, labelsIn(file("by_hand.pcd")), stride, expected);
    EXPECT_EQ(labelsIn(file("out.pcd")), expected);
    EXPECT_EQ(labelsIn(file("out.ply")), expected);
    LabelledCloud whole = readCloud(scan);
    setLabels(expected, LabelType::U4, whole);
    saveCloud(file("expected.pcd"), whole, readCloud(file("out.pcd")).layout);
    EXPECT_EQ(readText(file("out.pcd")), readText(file("expected.pcd")));
    saveCloud(file("expected.ply"), whole, readCloud(file("out.ply")).layout);
    EXPECT_EQ(readText(file("out.ply")), readText(file("expected.ply")));
  }

  /** A scan of the shared folder as a binary file; empty when it is absent. */
  std::string
  binaryCopyOf(const std::string& name) const
  {
    const std::string scan = PCL_CID_SHARED_DIR "/data/" + name;
    if (!std::filesystem::exists(scan))
      return "";
    saveCloud(file("copy.pcd"), readCloud(scan), pcd_binary);
    return file("copy.pcd");
  }

  std::string
  complaintOf(const std::vector<std::string>& arguments, int exit_code) const
  {
    const ToolRun done = run("pcl_cid_segment", arguments);
    EXPECT_EQ(done.exit_code, exit_code) << done.err;
    return done.err;
  }

  pcl::Indices source_;
  std::string chosen_ = file("chosen.pcd");
};

TEST_F(VoxelTool, DoesWhatIsDoneByHand)
{
  for (const CloudLayout& layout : {pcd_binary, pcd_ascii, ply_binary}) {
    const std::string scan =
        file(layout.format == "PCD" ? "scan_of_rows.pcd" : "scan_of_rows.ply");
    saveCloud(scan, deskScan(), layout);
    expectAsByHand(scan, 0.1);
    expectAsByHand(scan, 0.04, {"--color", "0.01", "--threads", "3"});
  }
}

TEST_F(VoxelTool, DoesWhatIsDoneByHandWithText)
{
  const LabelledCloud desk = deskScan();
  const FileCoordinates at(desk);
  std::string text = "x,y,z\n";
  for (std::size_t i = 0; i < desk.size(); ++i)
    text += std::to_string(at[i].x()) + "," + std::to_string(at[i].y()) + "," +
            std::to_string(at[i].z()) + "\n";
  writeText(file("desk.csv"), text);
  expectAsByHand(file("desk.csv"), 0.1);
}

TEST_F(VoxelTool, DoesWhatIsDoneByHandWithRealScans)
{
  const std::string organized = binaryCopyOf("office1.pcd");
  if (organized.empty())
    GTEST_SKIP() << "the shared scans are absent";
  expectAsByHand(organized, 0.4, {}, 101);
  EXPECT_EQ(readCloud(file("out.pcd")).fields.width, 640u);
  expectAsByHand(binaryCopyOf("terrain_csite3_utm.pcd"), 12.0, {}, 101);
  expectAsByHand(binaryCopyOf("room_scan1.pcd"), 0.5, {"--paper"}, 101);
}

TEST_F(VoxelTool, WorksOnOnePointOfAll)
{
  LabelledCloud cloud = deskScan(); // about 0, where eight voxels meet
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::uint8_t* const bytes =
          cloud.fields.data.data() + i * cloud.fields.point_step + axis * sizeof(float);
      float value = 0.0f;
      std::memcpy(&value, bytes, sizeof(value));
      value += 10.0f;
      std::memcpy(bytes, &value, sizeof(value));
    }
  saveCloud(file("rows.pcd"), cloud, pcd_binary);
  segment({file("rows.pcd"), file("out.pcd"), "--voxel", "1000"});
  const Labels truth = deskLabels();
  const Labels labels = labelsIn(file("out.pcd"));
  for (std::size_t i = 0; i < truth.size(); ++i)
    EXPECT_EQ(labels[i], truth[i] == 0 ? 0u : 1u);
}

TEST_F(VoxelTool, IndicesAreThoseOfTheFile)
{
  const std::string scan = file("rows.pcd");
  saveCloud(scan, deskScan(), pcd_binary);
  source_ = chooseFrom(scan, 0.1, chosen_);
  const std::string seeds = file("seeds.csv");
  const std::string start = std::to_string(source_[5]);
  segment({scan,
           file("out.pcd"),
           "--voxel",
           "0.1",
           "--propose",
           seeds,
           "--start-index",
           start,
           "--report",
           file("report.json")});
  const FileCoordinates at(readCloud(scan));
  const auto json = report();
  EXPECT_EQ(json["points"]["in"], 1200);
  EXPECT_EQ(json["points"]["voxels"], source_.size());
  EXPECT_EQ(json["parameters"]["voxel"], 0.1);
  EXPECT_EQ(json["parameters"]["start_index"], source_[5]);
  EXPECT_EQ(json["seeds"][0]["index"], source_[5]);
  std::size_t grouped = 0;
  for (const auto& seed : json["seeds"]) {
    const auto index = seed["index"].get<pcl::index_t>();
    EXPECT_TRUE(std::binary_search(source_.begin(), source_.end(), index));
    grouped += seed["points"].get<std::size_t>();
  }
  EXPECT_EQ(grouped, json["points"]["finite"]);
  EXPECT_EQ(json["points"]["grouped"], json["points"]["finite"]);

  // The table names points of the file; their labels come back.
  std::string table = "index,label\n";
  const Labels truth = deskLabels();
  Labels given;
  for (const auto& seed : json["seeds"]) {
    const auto index = seed["index"].get<std::size_t>();
    table += std::to_string(index) + "," + std::to_string(truth[index]) + "\n";
  }
  writeText(file("labels.csv"), table);
  segment(
      {scan, file("labelled.pcd"), "--voxel", "0.1", "--labels", file("labels.csv")});
  const Labels labels = labelsIn(file("labelled.pcd"));
  for (const auto& seed : json["seeds"]) {
    const auto index = seed["index"].get<std::size_t>();
    EXPECT_EQ(labels[index], truth[index]);
  }
}

TEST_F(VoxelTool, RefusesPointsThatNoVoxelKept)
{
  const std::string scan = file("rows.pcd");
  saveCloud(scan, deskScan(), pcd_binary);
  source_ = chooseFrom(scan, 0.1, chosen_);
  pcl::index_t left = 0;
  while (std::binary_search(source_.begin(), source_.end(), left) ||
         deskLabels()[static_cast<std::size_t>(left)] == 0)
    ++left;
  const std::string index = std::to_string(left);
  EXPECT_NE(
      complaintOf({scan, file("o.pcd"), "--voxel", "0.1", "--start-index", index}, 1)
          .find("--start-index is " + index + ", which is no point"),
      std::string::npos);
  writeText(file("seeds.csv"), "index,label\n" + index + ",1\n");
  EXPECT_NE(
      complaintOf(
          {scan, file("o.pcd"), "--voxel", "0.1", "--labels", file("seeds.csv")}, 1)
          .find("seeds.csv: line 2: the index is " + index + ", which is no point"),
      std::string::npos);
  EXPECT_NE(
      complaintOf({scan, file("o.pcd"), "--voxel", "0.1", "--start-index", "1200"}, 1)
          .find("--start-index is 1200; INPUT has 1200 points"),
      std::string::npos);
  writeText(file("seeds.csv"), "index,label\n1200,1\n");
  EXPECT_NE(
      complaintOf(
          {scan, file("o.pcd"), "--voxel", "0.1", "--labels", file("seeds.csv")}, 1)
          .find("the index is '1200'; it must be a whole number, 0 to 1199"),
      std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(file("o.pcd")));
}

TEST_F(VoxelTool, ScoresAllPointsOfTheFile)
{
  LabelledCloud cloud = deskScan();
  const Labels truth = deskLabels();
  setLabels(truth, LabelType::U4, cloud);
  const std::string scan = file("rows.pcd");
  saveCloud(scan, cloud, pcd_binary);
  segment({scan,
           file("out.pcd"),
           "--voxel",
           "0.07",
           "--labels-from",
           "label",
           "--report",
           file("report.json")});
  const Labels labels = labelsIn(file("out.pcd"));
  std::size_t finite = 0;
  std::size_t right = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    finite += truth[i] > 0 ? 1 : 0;
    right += truth[i] > 0 && labels[i] == truth[i] ? 1 : 0;
  }
  const auto score = report()["score"];
  EXPECT_EQ(score["points"], finite);
  EXPECT_EQ(score["right"], right);
  EXPECT_EQ(score["labelled_points"], finite);
  EXPECT_GT(right, finite / 2);
}

TEST_F(VoxelTool, DoesSeveralScansInOneCall)
{
  saveCloud(file("a.pcd"), deskScan(), pcd_binary);
  saveCloud(file("b.ply"), deskScan(), ply_binary);
  saveCloud(file("packed.pcd"), deskScan(), pcd_compressed);
  std::filesystem::create_directory(file("out"));
  const ToolRun done = run("pcl_cid_segment",
                           {file("a.pcd"),
                            file("b.ply"),
                            file("packed.pcd"),
                            "--voxel",
                            "0.1",
                            "--seeds",
                            "9",
                            "--output-dir",
                            file("out")});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("packed.pcd: this PCD file cannot be read block by block"),
            std::string::npos)
      << done.err;
  EXPECT_FALSE(std::filesystem::exists(file("out/packed.pcd")));
  EXPECT_EQ(labelsIn(file("out/a.pcd")), labelsIn(file("out/b.ply")));
  const Labels labels = labelsIn(file("out/a.pcd"));
  EXPECT_EQ(*std::max_element(labels.begin(), labels.end()), 9u);
}

/** What is held depends on the voxels, however many points they have. */
TEST_F(VoxelTool, MemoryIsThatOfTheVoxels)
{
  const auto peak = [&](std::size_t points) {
    saveCloud(
        file("cube.pcd"), toLabelledCloud(*toCloud(randomCube(points, 3))), pcd_binary);
    const ToolRun done = runFromSmallProcess("pcl_cid_segment",
                                             {file("cube.pcd"),
                                              file("out.pcd"),
                                              "--voxel",
                                              "0.25",
                                              "--threads",
                                              "1",
                                              "--report",
                                              file("report.json")});
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_EQ(report()["points"]["voxels"], 64);
    return report()["peak_memory_bytes"].get<double>();
  };
  const double of_few = peak(100000);
  EXPECT_LT(peak(2000000), of_few + 8e6); // the file has 24 MB
}

/** Labels of points that did not return are no labels, and a point that is wrong is
 * told by its place in the file. */
TEST_F(VoxelTool, LooksAtTheLabelsOfPointsThatCount)
{
  Points points = randomCube(70000, 3);
  std::vector<float> labels(points.size(), 3.0F);
  for (std::size_t i = 0; i < 20; ++i) {
    points[i].setZero();
    labels[i] = 0.5F;
  }
  const auto save = [&] {
    LabelledCloud cloud = toLabelledCloud(*toCloud(points));
    appendField("label", labels, cloud.fields);
    saveCloud(file("cloud.pcd"), cloud, pcd_binary);
  };
  save();
  const std::vector<std::string> arguments{
      file("cloud.pcd"), file("out.pcd"), "--voxel", "0.1", "--labels-from", "label"};
  segment(arguments);
  labels[66000] = 0.5F;
  save();
  EXPECT_NE(complaintOf(arguments, 1).find("field 'label' of point 66000 is 0.5"),
            std::string::npos);
}

/** In metres, and in the unit of the file: voxels and labels are the same. */
TEST_F(VoxelTool, WritesTheUnitThatIsAskedFor)
{
  saveCloud(file("metres.pcd"), deskScan(), pcd_binary);
  LabelledCloud scan = readCloud(file("metres.pcd"));
  scan.scale = 1000.0;
  convertToMetres(scan); // what were metres are taken for kilometres
  saveCloud(file("millimetres.pcd"), scan, pcd_binary);
  for (const std::string unit : {"file", "metre"}) {
    segment({file("millimetres.pcd"),
             file(unit + ".pcd"),
             "--voxel",
             "0.07",
             "--scale",
             "0.001",
             "--output-unit",
             unit,
             "--propose",
             file(unit + ".csv")});
    const CloudPoints written = pointsOf(readCloud(file(unit + ".pcd")));
    std::string table = readText(file(unit + ".csv"));
    writeText(file(unit + ".csv"),
              std::regex_replace(table, std::regex(",\n"), ",7\n"));
    // A table is refused where its coordinates are not those of the cloud.
    EXPECT_FALSE(readSeedTable(file(unit + ".csv"), written).seeds.empty());
  }
  EXPECT_EQ(labelsIn(file("file.pcd")), labelsIn(file("metre.pcd")));
  const LabelledCloud in_file = readCloud(file("file.pcd"));
  const LabelledCloud in_metres = readCloud(file("metre.pcd"));
  EXPECT_TRUE(in_file.sensor_origin.head<3>().isApprox(
      1000.0F * in_metres.sensor_origin.head<3>()));
  for (std::size_t i = 0; i < scan.size(); ++i)
    if (FileCoordinates(scan)[i].allFinite()) {
      EXPECT_EQ(FileCoordinates(in_file)[i], FileCoordinates(scan)[i]);
      EXPECT_TRUE((1000.0 * FileCoordinates(in_metres)[i])
                      .isApprox(FileCoordinates(scan)[i], 1e-6));
    }
}

TEST_F(VoxelTool, RefusesWhatNeedsAllPoints)
{
  saveCloud(file("rows.pcd"), deskScan(), pcd_binary);
  const std::string out = file("o.pcd");
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{"--html", "p.html"},
                                             {"--session", "s.jsonl"},
                                             {"--cid-from", "3"},
                                             {"--superpoints", "s.json"},
                                             {"--mesh-spacing", "0.1"},
                                             {"--class-table", "t.tsv"}}) {
    std::vector<std::string> arguments{file("rows.pcd"), out, "--voxel", "0.1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_NE(complaintOf(arguments, 2).find("needs all points in memory"),
              std::string::npos)
        << more.front();
  }
  EXPECT_NE(complaintOf({"-", out, "--voxel", "0.1"}, 2).find("several times"),
            std::string::npos);
  EXPECT_NE(complaintOf({file("rows.pcd"), "-", "--voxel", "0.1"}, 2).find("block"),
            std::string::npos);
  for (const char* const size : {"0", "-1", "none", "nan"})
    complaintOf({file("rows.pcd"), out, "--voxel", size}, 2);
  EXPECT_NE(complaintOf({scan_, out, "--voxel", "0.1"}, 1)
                .find("cannot be read block by block"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(out));
}

} // namespace
} // namespace pcl_cid::test
