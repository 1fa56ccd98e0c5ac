/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scans of ScanNet: what is read from them, told and refused.
 */

#include "cloud_files.h"
#include "dataset_folders.h"

#include <pcl_cid/io/scannet.h>

#include <filesystem>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;
using Labels = std::vector<std::uint32_t>;

constexpr const char* id = "scene0011_01";

/** A scan of six vertices in four segments, in files that a test may write again. */
class ScannetScan : public testing::Test {
protected:
  ScannetScan()
  {
    fs::create_directories(scan_);
    writeText(mesh_,
              "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\n"
              "property float y\nproperty float z\nproperty uchar red\n"
              "property uchar green\nproperty uchar blue\nproperty uchar alpha\n"
              "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
              "0 0 0 1 2 3 255\n1 0 0 1 2 3 255\n2 0 0 1 2 3 255\n"
              "3 0 0 1 2 3 255\n4 0 0 1 2 3 255\n5 0 0 1 2 3 255\n3 0 1 2\n");
    writeText(segments_, R"({"sceneId": "x", "segIndices": [7, 7, 2, 9, 0, 9]})");
    writeText(aggregation_,
              R"({"segGroups": [
                   {"id": 0, "objectId": 0, "segments": [9], "label": "office chair"},
                   {"id": 1, "objectId": 4, "segments": [2, 7], "label": "wall"}]})");
    writeText(table_, header_ + "1\twall\twall\t1\n5\toffice chair\tchair\t5\n");
  }

  LabelledCloud
  read(const std::string& class_table = "")
  {
    remarks_.clear();
    return readScannetScan(scan_, class_table, [this](const std::string& remark) {
      remarks_.push_back(remark);
    });
  }

  /** The message that refuses the scan. */
  std::string
  complaint(const std::string& class_table = "")
  {
    try {
      read(class_table);
    }
    catch (const CIDException& error) {
      return error.what();
    }
    return "none";
  }

  static Labels
  labels(const LabelledCloud& cloud, const std::string& field)
  {
    return valuesOf<std::uint32_t>(cloud.fields, field);
  }

  TemporaryFolder folder_;
  std::string scan_ = folder_.file(std::string("scans/") + id);
  std::string mesh_ = scan_ + "/" + id + "_vh_clean_2.ply";
  std::string segments_ = scan_ + "/" + id + "_vh_clean_2.0.010000.segs.json";
  std::string aggregation_ = scan_ + "/" + id + ".aggregation.json";
  std::string table_ = folder_.file("scannetv2-labels.combined.tsv");
  std::string header_ = "id\traw_category\tcategory\tnyu40id\n";
  Strings remarks_;
};

TEST_F(ScannetScan, HasTheInstanceAndClassOfEachVertex)
{
  const LabelledCloud cloud = read();
  EXPECT_EQ(remarks_, Strings{});
  EXPECT_EQ(valuesOf<float>(cloud.fields, "x"), (std::vector<float>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(labels(cloud, "rgba"), Labels(6, 0xFF010203));
  // Segment 0 is in no group; instances are objectId + 1.
  EXPECT_EQ(labels(cloud, "label"), (Labels{5, 5, 5, 1, 0, 1}));
  EXPECT_EQ(labels(cloud, "semantic"), (Labels{1, 1, 1, 5, 0, 5}));
}

TEST_F(ScannetScan, GivesBackWhatWasWritten)
{
  const LabelledScan scan = smallRoomScan(2000);
  constexpr std::uint32_t bare = 5;
  scan_ = writeScannetScan(folder_.file("."), scan, bare);
  const LabelledCloud cloud = read();
  EXPECT_EQ(remarks_, Strings{});
  ASSERT_EQ(cloud.size(), scan.points.size());
  const CloudPoints points = pointsOf(cloud);
  const Labels found = labels(cloud, "label");
  const Labels classes = labels(cloud, "semantic");
  std::size_t bare_points = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const bool is_bare = scan.instance[i] == bare;
    bare_points += is_bare ? 1 : 0;
    EXPECT_EQ((*points.points)[i].getVector3fMap(), scan.points[i]);
    EXPECT_EQ(found[i], is_bare ? 0 : scan.instance[i]);
    EXPECT_EQ(classes[i], is_bare ? 0 : nyu40Of(scan.class_names[scan.semantic[i]]));
  }
  EXPECT_GT(bare_points, 0u);
}

TEST_F(ScannetScan, FindsItsClassTableAboveOrWhereItIsTold)
{
  EXPECT_EQ(findScannetFiles(scan_).class_table, table_);
  const std::string elsewhere = folder_.file("my table");
  writeText(elsewhere, header_ + "1\twall\twall\t3\n5\toffice chair\tchair\t4\n");
  EXPECT_EQ(labels(read(elsewhere), "semantic"), (Labels{3, 3, 3, 4, 0, 4}));
  const std::string nearer = scan_ + "/scannetv2-labels.combined.tsv";
  fs::rename(elsewhere, nearer);
  EXPECT_EQ(labels(read(), "semantic"), (Labels{3, 3, 3, 4, 0, 4}));
  EXPECT_EQ(findScannetFiles(scan_).all(),
            (Strings{mesh_, segments_, aggregation_, nearer}));
  fs::remove(nearer);
  fs::remove(table_);
  const std::string message = complaint();
  EXPECT_EQ(message.rfind(scan_ +
                              ": there is no scannetv2-labels.combined.tsv; it was "
                              "looked for in " +
                              scan_ + ", " + folder_.file("scans") + ", ",
                          0),
            0u)
      << message;
  EXPECT_EQ(message.substr(message.size() - 3), ", /");
  EXPECT_NE(complaint(elsewhere).find("cannot be opened"), std::string::npos);
}

TEST_F(ScannetScan, OfTheHiddenTestSetHasNoLabels)
{
  fs::remove(segments_);
  fs::remove(aggregation_);
  fs::remove(table_);
  const LabelledCloud cloud = read();
  EXPECT_EQ(cloud.size(), 6u);
  EXPECT_EQ(labels(cloud, "label"), Labels{});
  ASSERT_EQ(remarks_.size(), 1u);
  EXPECT_EQ(remarks_[0].rfind(scan_ + ": has no annotation (", 0), 0u) << remarks_[0];
}

TEST_F(ScannetScan, NeedsBothFilesOfAnAnnotation)
{
  const std::string needs = std::string("; an annotated scan needs ") + id +
                            "_vh_clean_2.0.010000.segs.json and " + id +
                            ".aggregation.json";
  const std::string text = readText(aggregation_);
  fs::remove(aggregation_);
  EXPECT_EQ(complaint(), scan_ + ": has no " + id + ".aggregation.json" + needs);
  writeText(aggregation_, text);
  fs::remove(segments_);
  EXPECT_EQ(complaint(),
            scan_ + ": has no " + id + "_vh_clean_2.0.010000.segs.json" + needs);
  fs::create_directory(segments_);
  EXPECT_EQ(complaint().rfind(segments_ + ": cannot be read", 0), 0u) << complaint();
}

TEST_F(ScannetScan, NeedsASegmentForEachVertex)
{
  writeText(segments_, R"({"segIndices": [1, 2, 3, 4, 5]})");
  EXPECT_EQ(complaint(),
            segments_ + ": segIndices has 5 values, but " + mesh_ +
                " has 6 vertices; there must be one for each");
}

TEST_F(ScannetScan, NamesEveryLabelThatTheTableDoesNotHave)
{
  writeText(aggregation_,
            R"({"segGroups": [
                 {"objectId": 0, "segments": [9], "label": "throne"},
                 {"objectId": 1, "segments": [2], "label": "wall"},
                 {"objectId": 2, "segments": [7], "label": "altar"},
                 {"objectId": 3, "segments": [0], "label": "throne"}]})");
  EXPECT_EQ(complaint(),
            table_ + ": has no row for 'altar', 'throne', which stand in " +
                aggregation_ + "; every label must be a raw_category");
}

/** As in scene0217_00, where each group stands twice. */
TEST_F(ScannetScan, GivesSharedSegmentsToTheLaterGroup)
{
  writeText(aggregation_,
            R"({"segGroups": [
                 {"objectId": 0, "segments": [9, 2, 2], "label": "wall"},
                 {"objectId": 1, "segments": [9, 7], "label": "office chair"}]})");
  const LabelledCloud cloud = read();
  EXPECT_EQ(labels(cloud, "label"), (Labels{2, 2, 1, 2, 0, 2}));
  EXPECT_EQ(remarks_,
            Strings{aggregation_ + ": 1 segment of a group stood in an earlier one, "
                                   "too; the later one has them"});
}

TEST_F(ScannetScan, RefusesOneObjectIdForTwoGroups)
{
  const std::string first =
      R"({"segGroups": [{"objectId": 3, "segments": [9, 2], "label": "wall"},
                        {"objectId": 0, "segments": [0], "label": "wall"},)";
  for (const char* const other :
       {R"({"objectId": 3, "segments": [7], "label": "wall"}]})",
        R"({"objectId": 3, "segments": [9, 2], "label": "office chair"}]})"}) {
    writeText(aggregation_, first + other);
    EXPECT_EQ(complaint(),
              aggregation_ +
                  ": segGroups[2].objectId is 3, as that of segGroups[0], which has "
                  "another label or other segments; each group must have its own");
  }
  // The same group twice says nothing else.
  writeText(aggregation_,
            first + R"({"objectId": 3, "segments": [9, 2], "label": "wall"}]})");
  EXPECT_EQ(labels(read(), "label"), (Labels{0, 0, 4, 4, 1, 4}));
  EXPECT_EQ(remarks_,
            Strings{aggregation_ + ": 1 group stood there before, with the same "
                                   "objectId, label and segments, and counted once"});
}

TEST_F(ScannetScan, TellsOfSegmentsWithoutVertices)
{
  writeText(
      aggregation_,
      R"({"segGroups": [{"objectId": 0, "segments": [9, 99, 98], "label": "wall"}]})");
  EXPECT_EQ(labels(read(), "label"), (Labels{0, 0, 0, 1, 0, 1}));
  EXPECT_EQ(remarks_,
            Strings{aggregation_ + ": 2 segments of its groups have no vertex in " +
                    segments_});
}

TEST_F(ScannetScan, RefusesJSONOfAnotherShape)
{
  const auto expectRefused = [this](const std::string& path,
                                    const std::string& text,
                                    const std::string& reason) {
    const std::string before = readText(path);
    writeText(path, text);
    EXPECT_EQ(complaint(), path + ": " + reason);
    writeText(path, before);
  };
  const std::string whole = "; it must be a whole number, 0 to 4294967294";
  expectRefused(segments_, "", "offset 0: is no valid JSON");
  expectRefused(segments_, R"({"segIndices": [1,)", "offset 18: is no valid JSON");
  expectRefused(segments_, "[1, 2]", "has no member 'segIndices'");
  expectRefused(segments_, "{}", "has no member 'segIndices'");
  expectRefused(
      segments_, R"({"segIndices": 5})", "segIndices is 5; it must be an array");
  for (const std::string bad : {"-1", "1.5", "\"2\"", "null", "4294967295"})
    expectRefused(segments_,
                  R"({"segIndices": [0, )" + bad + ", 0, 0, 0, 0]}",
                  "segIndices[1] is " + bad + whole);

  expectRefused(aggregation_, "{}", "has no member 'segGroups'");
  expectRefused(aggregation_,
                R"({"segGroups": [{"objectId": 0, "segments": [1]}]})",
                "segGroups[0] has no member 'label'");
  expectRefused(aggregation_,
                R"({"segGroups": [{"objectId": 0, "segments": [1], "label": 3}]})",
                "segGroups[0].label is 3; it must be a text");
  expectRefused(aggregation_,
                R"({"segGroups": [{"segments": [1], "label": "wall"}]})",
                "segGroups[0] has no member 'objectId'");
  expectRefused(
      aggregation_,
      R"({"segGroups": [{"objectId": "a", "segments": [1], "label": "wall"}]})",
      R"(segGroups[0].objectId is "a")" + whole);
  expectRefused(aggregation_,
                R"({"segGroups": [{"objectId": 0, "segments": 1, "label": "wall"}]})",
                "segGroups[0].segments is 1; it must be an array");
  expectRefused(
      aggregation_,
      R"({"segGroups": [{"objectId": 0, "segments": [[1]], "label": "wall"}]})",
      "segGroups[0].segments[] is [1]" + whole);
}

/// What walks through it calls itself as deep: 150 kB of brackets overflowed the stack.
TEST_F(ScannetScan, RefusesJsonThatIsNestedDeeply)
{
  for (const std::string& path : {segments_, aggregation_})
    for (const std::string& opening : {std::string("["), std::string("{\"a\":")}) {
      const std::string whole = readText(path);
      std::string deep = "{\"segIndices\": ";
      for (int i = 0; i < 150000; ++i)
        deep += opening;
      writeText(path, deep);
      EXPECT_EQ(complaint(),
                path + ": is no JSON that can be read: it is nested more than "
                       "64 levels deep");
      writeText(path, whole);
    }
}

TEST_F(ScannetScan, ReadsTablesOfWindowsAndRefusesBrokenOnes)
{
  const std::string rows = "1\twall\twall\t1\n5\toffice chair\tchair\t5\n";
  writeText(table_,
            "nyu40id\textra\traw_category\r\n1\t\twall\r\n\r\n5\tx\toffice chair");
  EXPECT_EQ(labels(read(), "semantic"), (Labels{1, 1, 1, 5, 0, 5}));

  const std::string columns = "'; its columns, separated by tabs, must contain "
                              "raw_category and nyu40id";
  writeText(table_, "id\tcategory\tnyu40id\n" + rows);
  EXPECT_EQ(complaint(), table_ + ": has no column 'raw_category" + columns);
  writeText(table_, "id,raw_category,nyu40id\n" + rows);
  EXPECT_EQ(complaint(), table_ + ": has no column 'raw_category" + columns);
  writeText(table_, "raw_category\n");
  EXPECT_EQ(complaint(), table_ + ": has no column 'nyu40id" + columns);
  writeText(table_, header_ + "5\tlamp\tlamp\n");
  EXPECT_EQ(complaint(), table_ + ": line 2: has only 3 columns");
  for (const std::string bad : {"", "0", "41", "-1", "wall", "1.0"}) {
    writeText(table_, header_ + rows + "5\tlamp\tlamp\t" + bad + "\n");
    EXPECT_EQ(complaint(),
              table_ + ": line 4: nyu40id is '" + bad +
                  "'; it must be a whole number, 1 to 40");
  }
  for (const std::string& empty : {std::string(), header_}) {
    writeText(table_, empty);
    EXPECT_EQ(complaint(), table_ + ": holds no class; at least 1 is needed");
  }
}

TEST_F(ScannetScan, IsAFolderWithOneMesh)
{
  EXPECT_TRUE(isScannetScan(scan_));
  EXPECT_TRUE(isScannetScan(scan_ + "/"));
  EXPECT_FALSE(isScannetScan(mesh_));
  EXPECT_FALSE(isScannetScan(folder_.file("scans")));
  EXPECT_FALSE(isScannetScan(folder_.file("nowhere")));
  EXPECT_EQ(findScannetFiles(scan_ + "/").id, id);
  // Other meshes of ScanNet, and what some systems leave behind.
  for (const char* const name :
       {"_vh_clean.ply", "_vh_clean_2.labels.ply", "_vh_clean_2.ply.bak"})
    writeText(scan_ + "/" + id + name, "");
  writeText(scan_ + "/._" + id + "_vh_clean_2.ply", "");
  EXPECT_EQ(read().size(), 6u);
  writeText(scan_ + "/scene0012_00_vh_clean_2.ply", "");
  EXPECT_EQ(complaint(),
            scan_ + ": holds 2 files named <id>_vh_clean_2.ply; a scan must hold 1");
}

} // namespace
} // namespace pcl_cid::test
