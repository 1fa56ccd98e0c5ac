/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_segment: labels from a table, from a field, and of every type.
 */

#include "segment_tool.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>

namespace pcl_cid::test {
namespace {

using Labels = std::vector<std::uint32_t>;

TEST_F(SegmentTool, ProposesSeedsAndReadsTheirLabelsBack)
{
  segment({scan_,
           file("groups.pcd"),
           "--propose",
           file("seeds.csv"),
           "--paper",
           "--start-index",
           "100"});
  const std::string table = readText(file("seeds.csv"));
  EXPECT_EQ(table.rfind("index,x,y,z,label\n100,", 0), 0u) << table;
  EXPECT_EQ(linesOf(table), 13u);

  // The annotator: label 1000 + row for all seeds but the last, which stays unasked.
  std::istringstream lines(table);
  std::string filled, line;
  std::getline(lines, filled);
  filled += '\n';
  for (int row = 0; std::getline(lines, line); ++row)
    filled += line + (row < 11 ? std::to_string(1000 + row) : "") + "\n";
  writeText(file("seeds.csv"), filled);
  segment({scan_, file("labelled.pcd"), "--paper", "--labels", file("seeds.csv")});

  const Labels groups = labelsIn(file("groups.pcd"));
  const Labels labels = labelsIn(file("labelled.pcd"));
  const std::set<std::uint32_t> used(labels.begin(), labels.end());
  EXPECT_EQ(used.size(), 12u); // 11 labels, and 0
  for (std::size_t i = 0; i < labels.size(); ++i) {
    // With one seed fewer, all other points keep theirs.
    if (groups[i] == 0) {
      EXPECT_EQ(labels[i], 0u);
    }
    else if (groups[i] != 12) {
      EXPECT_EQ(labels[i], 999 + groups[i]);
    }
  }
}

TEST_F(SegmentTool, TakesLabelZeroAsAnAnswer)
{
  const Labels truth = deskLabels();
  std::string table = "index,label\n";
  for (const std::uint32_t surface : {1u, 2u, 3u}) {
    std::size_t seed = 0;
    while (truth[seed] != surface)
      ++seed;
    table += std::to_string(seed) + (surface == 2 ? ",0\n" : ",9\n");
  }
  writeText(file("seeds.csv"), table);
  segment({scan_, file("out.pcd"), "--labels", file("seeds.csv")});
  const Labels labels = labelsIn(file("out.pcd"));
  const std::set<std::uint32_t> used(labels.begin(), labels.end());
  EXPECT_EQ(used, (std::set<std::uint32_t>{0, 9}));
  const auto zeros = std::count(labels.begin(), labels.end(), 0u);
  EXPECT_GT(zeros, std::count(truth.begin(), truth.end(), 0u));
}

template <typename Value>
class LabelledInput : public SegmentTool {
};

using TypesOfLabels =
    testing::Types<std::uint8_t, std::uint16_t, std::uint32_t, std::int32_t, float>;
TYPED_TEST_SUITE(LabelledInput, TypesOfLabels);

TYPED_TEST(LabelledInput, PlaysTheAnnotatorWhateverItsType)
{
  LabelledCloud scan = deskScan();
  std::vector<TypeParam> field;
  for (const std::uint32_t label :
       deskLabels()) // NaN at invalid points, where it can be
    field.push_back(label == 0 ? std::numeric_limits<TypeParam>::quiet_NaN()
                               : static_cast<TypeParam>(label));
  appendField("label", field, scan.fields);
  scan.fields.width = 40;
  const std::string input = this->file("labelled.pcd");
  saveCloud(input, scan, pcd_binary);
  const ToolRun done = this->segment({input,
                                      this->file("out.pcd"),
                                      "--labels-from",
                                      "label",
                                      "--report",
                                      this->file("report.json")});

  const Labels truth = deskLabels();
  const Labels labels = this->labelsIn(this->file("out.pcd"));
  std::size_t right = 0;
  std::size_t finite = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_LE(labels[i], 3u);
    finite += truth[i] != 0 ? 1 : 0;
    right += truth[i] != 0 && labels[i] == truth[i] ? 1 : 0;
  }
  const double share = static_cast<double>(right) / static_cast<double>(finite);
  EXPECT_GT(share, 0.8);
  char percent[32];
  std::snprintf(percent, sizeof(percent), "%.2f %%", 100 * share);
  EXPECT_NE(done.out.find(percent), std::string::npos) << done.out;
  const nlohmann::json score = this->report()["score"];
  EXPECT_EQ(score["field"], "label");
  EXPECT_EQ(score["points"], finite);
  EXPECT_EQ(score["right"], right);
  EXPECT_EQ(score["labelled_points"], finite);
  EXPECT_DOUBLE_EQ(score["share_right"], share);
  // The field was replaced, in its place.
  EXPECT_EQ(readCloud(this->file("out.pcd")).fields.fields.size(), 5u);
}

TEST_F(SegmentTool, PlaysTheAnnotatorOnARealScan)
{
  const std::string scan = PCL_CID_SHARED_DIR "/data/mosd_learn41.pcd";
  if (!std::filesystem::exists(scan))
    GTEST_SKIP() << scan << " is absent";
  segment({scan,
           file("out.pcd"),
           "--labels-from",
           "label",
           "--subsample",
           "1500",
           "--report",
           file("report.json")});
  const LoadedByPCL truth = loadWithPCL(scan);
  const LoadedByPCL result = loadWithPCL(file("out.pcd"));
  ASSERT_EQ(result.cloud.fields.size(), truth.cloud.fields.size());
  EXPECT_EQ(result.cloud.fields[0].name, "label"); // in its place
  EXPECT_EQ(bytesOf(result.cloud, "rgba"), bytesOf(truth.cloud, "rgba"));
  const auto z = valuesOf<float>(truth.cloud, "z");
  const auto expected = valuesOf<std::uint32_t>(truth.cloud, "label");
  const auto labels = valuesOf<std::uint32_t>(result.cloud, "label");
  std::size_t right = 0;
  std::size_t finite = 0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (!std::isfinite(z[i])) {
      EXPECT_EQ(labels[i], 0u);
      continue;
    }
    ++finite;
    right += labels[i] == expected[i] ? 1 : 0;
  }
  const double share = static_cast<double>(right) / static_cast<double>(finite);
  EXPECT_GT(share, 0.8);
  EXPECT_DOUBLE_EQ(report()["score"]["share_right"], share);
}

TEST_F(SegmentTool, CleansUpWhenAsked)
{
  segment({scan_, file("plain.pcd"), "--report", file("report.json")});
  EXPECT_EQ(report()["parameters"]["clean_up"], "off");
  segment({scan_, file("off.pcd"), "--clean-up", "off"});
  EXPECT_EQ(labelsIn(file("off.pcd")), labelsIn(file("plain.pcd")));
  segment({scan_, file("on.pcd"), "--clean-up", "on", "--report", file("report.json")});
  EXPECT_EQ(report()["parameters"]["clean_up"], "on");
  EXPECT_NE(labelsIn(file("on.pcd")), labelsIn(file("plain.pcd")));
}

TEST_F(SegmentTool, WritesTheLabelTypeThatIsAskedFor)
{
  segment({scan_, file("u.pcd")});
  const Labels labels = labelsIn(file("u.pcd"));
  segment({scan_, file("f.pcd"), "--label-type", "F4"});
  const LabelledCloud as_float = readCloud(file("f.pcd"));
  EXPECT_EQ(as_float.fields.fields.back().datatype, pcl::PCLPointField::FLOAT32);
  EXPECT_EQ(labelsOf(as_float, "label", pointsOf(as_float)), labels);
  segment({scan_, file("i.pcd"), "--label-type", "I4"});
  const LabelledCloud as_int = readCloud(file("i.pcd"));
  EXPECT_EQ(as_int.fields.fields.back().datatype, pcl::PCLPointField::INT32);
  EXPECT_EQ(labelsOf(as_int, "label", pointsOf(as_int)), labels);
}

} // namespace
} // namespace pcl_cid::test
