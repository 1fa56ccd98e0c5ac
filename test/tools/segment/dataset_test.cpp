/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The tools on folders of S3DIS and ScanNet, and what they write for ScanNet's tools.
 */

#include "dataset_folders.h"
#include "tool_process.h"

#include <pcl_cid/io/class_names.h>
#include <pcl_cid/io/scan_source.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;
using Labels = std::vector<std::uint32_t>;

Labels
valuesIn(const LabelledCloud& cloud, const std::string& field)
{
  return valuesOf<std::uint32_t>(cloud.fields, field);
}

Labels
maskIn(const std::string& path)
{
  std::istringstream stream(readText(path));
  return {std::istream_iterator<std::uint32_t>(stream), {}};
}

class DatasetFolders : public ToolTest {
protected:
  /** All files with their bytes. */
  static std::map<std::string, std::string>
  contentOf(const std::string& folder)
  {
    std::map<std::string, std::string> content;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      content[entry.path()] =
          entry.is_regular_file() ? readText(entry.path()) : "folder";
    return content;
  }

  void
  expectRefused(const Arguments& arguments, int code, const std::string& complaint)
  {
    const auto before = contentOf(file("."));
    const ToolRun done = run("pcl_cid_segment", arguments);
    EXPECT_EQ(done.exit_code, code);
    EXPECT_NE(done.err.find(complaint), std::string::npos) << done.err;
    EXPECT_EQ(contentOf(file(".")), before);
  }

  std::string
  scannetScan() const
  {
    return writeScannetScan(file("."), room_, 2);
  }

  LabelledScan room_ = smallRoomScan(1500);
};

TEST_F(DatasetFolders, OfS3DISAreSegmentedByTheirOwnLabels)
{
  const std::string room = writeS3DISRoom(file("."), room_);
  writeText(room + "/Annotations/stairs_1.txt",
            "1 1 1 103.0\x10"
            "0000 1 1\n");
  const auto before = contentOf(room);
  const ToolRun done = segment({room + "/",
                                file("out.pcd"),
                                "--labels-from",
                                "label",
                                "--report",
                                file("report.json")});
  EXPECT_EQ(contentOf(room), before);
  EXPECT_EQ(linesOf(done.err), 3u) << done.err; // class, repaired line, one point more
  EXPECT_NE(done.err.find("'stairs' is no class"), std::string::npos) << done.err;
  const nlohmann::json report = nlohmann::json::parse(readText(file("report.json")));
  EXPECT_EQ(report["remarks"].size(), 3u);
  EXPECT_EQ(report["input"], room + "/");

  const LabelledCloud truth = readScan(room);
  const LabelledCloud result = readCloud(file("out.pcd"));
  const Labels labels = valuesIn(result, "label");
  const Labels expected = valuesIn(truth, "label");
  ASSERT_EQ(labels.size(), room_.points.size() + 1);
  for (const char* const field : {"x", "y", "z", "rgb", "semantic"})
    EXPECT_EQ(bytesOf(result.fields, field), bytesOf(truth.fields, field)) << field;
  std::size_t right = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
    right += labels[i] == expected[i] ? 1 : 0;
  EXPECT_EQ(report["score"]["right"], right);
  EXPECT_GT(right, 0u);
}

TEST_F(DatasetFolders, StaySilentWhenAskedTo)
{
  const std::string room = writeS3DISRoom(file("."), room_);
  fs::remove(room + "/office_1.txt");
  const ToolRun done =
      segment({room, file("out.pcd"), "--quiet", "--report", file("report.json")});
  EXPECT_EQ(done.out + done.err, "");
  EXPECT_EQ(nlohmann::json::parse(readText(file("report.json")))["remarks"].size(), 1u);
}

TEST_F(DatasetFolders, AreTakenByTheOtherTool)
{
  abstract({scannetScan(), file("hulls.obj"), "--labels", file("parts.pcd")});
  EXPECT_EQ(readCloud(file("parts.pcd")).size(), room_.points.size());
}

TEST_F(DatasetFolders, AreNeverWrittenOver)
{
  const std::string room = writeS3DISRoom(file("."), room_);
  const std::string scan = scannetScan();
  const std::string segments = scan + "/scene0000_00_vh_clean_2.0.010000.segs.json";
  expectRefused({scan, file("out.pcd"), "--superpoints", segments}, 1, "is the input");
  expectRefused({scan, scan + "/scene0000_00_vh_clean_2.ply"}, 1, "is the input");
  expectRefused(
      {room, file("out.pcd"), "--report", room + "/office_1.txt"}, 1, "is the input");
  expectRefused({room, file("out.pcd"), "--propose", room + "/Annotations/wall_1.txt"},
                1,
                "is the input");
  const std::string table = file("scannetv2-labels.combined.tsv");
  expectRefused({scan, file("out.pcd"), "--report", table}, 1, "is the input");
  expectRefused(
      {scan, file("out.pcd"), "--class-table", table, "--report", table}, 1, "input");
}

TEST_F(DatasetFolders, OfNoScanAreRefused)
{
  fs::create_directory(file("Area_1"));
  expectRefused({file("Area_1"), file("out.pcd")}, 1, "neither a room of S3DIS");
  expectRefused({scan_, file("out.pcd"), "--class-table", "t.tsv"}, 1, "no scan of");
}

TEST_F(DatasetFolders, GiveSuperpoints)
{
  const std::string scan = scannetScan();
  segment({scan, file("groups.pcd"), "--superpoints", file("groups.segs.json")});
  const auto json = nlohmann::json::parse(readText(file("groups.segs.json")));
  EXPECT_EQ(json["sceneId"], "scene0000_00");
  Labels numbers = json["segIndices"].get<Labels>();
  for (std::uint32_t& number : numbers)
    ++number;
  EXPECT_EQ(numbers, valuesIn(readCloud(file("groups.pcd")), "label"));
  expectRefused({scan, file("out.pcd"), "--superpoints", file("groups.txt")},
                2,
                "must end in .json");
}

TEST_F(DatasetFolders, GiveASubmissionToTheBenchmark)
{
  const std::string scan = scannetScan();
  // What an earlier run left goes, what is of another scan stays.
  fs::create_directories(file("submission/pred_mask"));
  const std::string old_mask = file("submission/pred_mask/scene0000_00_999.txt");
  const std::string other_mask = file("submission/pred_mask/scene0001_00_000.txt");
  writeText(old_mask, "1\n");
  writeText(other_mask, "1\n");
  segment({scan,
           file("out.pcd"),
           "--labels-from",
           "label",
           "--scannet-submission",
           file("submission")});
  EXPECT_FALSE(fs::exists(old_mask));
  EXPECT_TRUE(fs::exists(other_mask));

  // Every mask is one label of the output, and its class that of the truth.
  const LabelledCloud result = readCloud(file("out.pcd"));
  const Labels labels = valuesIn(result, "label");
  std::map<std::uint32_t, std::uint32_t> class_of;
  for (std::size_t i = 0; i < room_.points.size(); ++i)
    class_of[room_.instance[i]] = nyu40Of(room_.class_names[room_.semantic[i]]);
  std::set<std::uint32_t> expected;
  for (const std::uint32_t label : labels)
    if (label != 0 && className(scannetBenchmarkClasses(), class_of[label]))
      expected.insert(label);
  std::istringstream list(readText(file("submission/scene0000_00.txt")));
  std::set<std::uint32_t> found;
  std::string mask_path;
  std::uint32_t semantic = 0;
  double confidence = 0.0;
  while (list >> mask_path >> semantic >> confidence) {
    const Labels mask = maskIn(file("submission/" + mask_path));
    ASSERT_EQ(mask.size(), labels.size());
    const auto first = std::find(mask.begin(), mask.end(), 1u) - mask.begin();
    const std::uint32_t label = labels.at(static_cast<std::size_t>(first));
    for (std::size_t i = 0; i < labels.size(); ++i)
      EXPECT_EQ(mask[i], labels[i] == label ? 1u : 0u);
    EXPECT_EQ(semantic, class_of[label]);
    EXPECT_EQ(confidence, 1.0);
    found.insert(label);
  }
  EXPECT_EQ(found, expected);
  EXPECT_GT(found.size(), 1u);
}

TEST_F(DatasetFolders, OfSeveralScansGiveOutputsByTheirNames)
{
  const std::string room = writeS3DISRoom(file("."), room_);
  const std::string scan = scannetScan();
  fs::copy(scan, file("copy"));
  const Arguments options{"--output-dir", file("out"), "--labels-from", "label"};
  Arguments both{room + "/", scan};
  both.insert(both.end(), options.begin(), options.end());
  const ToolRun done = segment(both);
  EXPECT_EQ(linesOf(done.out), 2u) << done.out;
  segment({scan, file("alone.pcd"), "--labels-from", "label"});
  EXPECT_EQ(readText(file("out/scene0000_00.pcd")), readText(file("alone.pcd")));
  EXPECT_TRUE(fs::exists(file("out/office_1.pcd")));

  Arguments submitting{scan};
  submitting.insert(submitting.end(), options.begin(), options.end());
  submitting.insert(submitting.end(), {"--scannet-submission", file("submission")});
  segment(submitting);
  EXPECT_TRUE(fs::exists(file("submission/scene0000_00.txt")));
  submitting.insert(submitting.begin(), room);
  expectRefused(submitting, 1, room + ": is no scan of ScanNet");
  Arguments twice{scan, file("copy")};
  twice.insert(twice.end(), options.begin(), options.end());
  expectRefused(twice, 2, "same name, 'scene0000_00'");
}

TEST_F(DatasetFolders, GiveNoSubmissionWithoutClasses)
{
  const std::string room = writeS3DISRoom(file("."), room_);
  const std::string folder = file("submission");
  expectRefused(
      {room, file("o.pcd"), "--labels-from", "label", "--scannet-submission", folder},
      1,
      "is no scan of ScanNet");
  const std::string scan = scannetScan();
  expectRefused({scan, file("out.pcd"), "--scannet-submission", folder},
                2,
                "--scannet-submission needs --labels-from");
  // A failure after the folders are made leaves none of them.
  expectRefused(
      {scan, file("o.pcd"), "--labels-from", "none", "--scannet-submission", folder},
      1,
      "has no field 'none'");
}

} // namespace
} // namespace pcl_cid::test
