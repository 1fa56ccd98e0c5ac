/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Small files after public reports, in `cases` of the shared folder: what becomes of
 * each.
 */

#include "tool_process.h"

#include "base/random.h"
#include "cloud_files.h"
#include "hulls.h"

#include <pcl_cid/io/mesh_import.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

struct ReportedFile {
  const char* name;
  /** What the tool must say; empty for nothing. */
  const char* says;
  int exit_code = 0;
  std::vector<std::string> arguments = {};
};

void
PrintTo(const ReportedFile& file, std::ostream* stream)
{
  *stream << file.name;
}

const ReportedFile reported_files[] = {
    {"ouster_count_0.pcd", ""},
    {"openmvs_vertex_lists.ply", "the list 'view_indices' of its vertices is passed"},
    // PCL aborts in the middle of writing it.
    {"pcl_padded.ply", "is truncated", 1},
    {"extra_columns.ply",
     "row 1 of element 'vertex' has 6 values; the header says 3",
     1},
    {"count_too_small.ply", "is left after the last of the 1000 rows", 1},
    {"undeclared_field.pcd", "has 12000 bytes after its last point", 1},
    {"cr_lines.ply", ""},
    {"cr_lines.pcd", ""},
    {"leading_blank_line.pcd", ""},
    {"byte_order_mark.pcd", ""},
    {"utm_and_one_zero.pcd", ""},
    {"utm_in_float.pcd", "its coordinates come in steps of 0.5 m"},
    {"sentinel_1e30.pcd", "the x of point 7 is 3.40282e+38", 1},
    {"object_minus_1.pcd",
     "field 'object' is -1 or NaN for 2000 points; taken as label 0",
     0,
     {"--labels-from", "object"}},
    {"class_nan.ply",
     "field 'scalar_Classification' is -1 or NaN for 2000 points; taken as label 0",
     0,
     {"--labels-from", "scalar_Classification"}},
    {"integer_xyz.pcd", "its coordinates come in steps of 1 m"},
    {"bool_field.pcd", ""},
    {"underflow_1e-46.pcd", ""},
    {"label_3.0.pcd", ""},
    {"colour_floats.ply", "", 0, {"--color", "0.001"}},
    {"no_returns_at_zero.pcd", "points lie exactly at (0, 0, 0)"},
    {"millimetres.pcd", "if it is in millimetres, give --scale 0.001"}};

std::string
reported(const std::string& name)
{
  return PCL_CID_SHARED_DIR "/cases/" + name;
}

bool
areThere()
{
  return std::filesystem::exists(reported("README.md"));
}

class ReportedFiles : public ToolTest,
                      public testing::WithParamInterface<ReportedFile> {};

INSTANTIATE_TEST_SUITE_P(Shared,
                         ReportedFiles,
                         testing::ValuesIn(reported_files),
                         [](const auto& info) {
                           std::string name = info.param.name;
                           for (char& c : name)
                             c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
                           return name;
                         });

TEST_P(ReportedFiles, GetWhatIsRightForThem)
{
  if (!areThere())
    GTEST_SKIP() << "needs ../shared/cases";
  const ReportedFile& reported_file = GetParam();
  const std::string input = reported(reported_file.name);
  const std::string output = file("out" + input.substr(input.size() - 4));
  std::vector<std::string> arguments{input, output, "--seeds", "10", "--threads", "1"};
  arguments.insert(
      arguments.end(), reported_file.arguments.begin(), reported_file.arguments.end());
  const ToolRun done = run("pcl_cid_segment", arguments);
  EXPECT_EQ(done.exit_code, reported_file.exit_code) << done.err;
  EXPECT_NE(done.err.find(reported_file.says), std::string::npos) << done.err;
  EXPECT_EQ(done.err.empty(), std::string(reported_file.says).empty()) << done.err;
  EXPECT_EQ(std::filesystem::exists(output), done.exit_code == 0);
  if (done.exit_code != 0)
    return;
  // All other fields keep their bytes.
  const LabelledCloud before = readCloud(input);
  const LabelledCloud after = readCloud(output);
  for (const pcl::PCLPointField& field : before.fields.fields)
    if (field.name != "label") {
      EXPECT_EQ(bytesOf(after.fields, field.name), bytesOf(before.fields, field.name))
          << field.name;
    }
}

class ReportedSeedTables : public ToolTest {
protected:
  /** The scan with the labels that a table gives. */
  std::string
  labelledBy(const std::string& table) const
  {
    const ToolRun done =
        run("pcl_cid_segment",
            {reported("seeds_scan.pcd"), file("labelled.pcd"), "--labels", table});
    EXPECT_EQ(done.exit_code, 0) << table << done.err;
    return readText(file("labelled.pcd"));
  }
};

TEST_F(ReportedSeedTables, GiveTheLabelsOfAPlainTable)
{
  if (!areThere())
    GTEST_SKIP() << "needs ../shared/cases";
  std::string plain = readText(reported("seeds_tab.csv"));
  std::replace(plain.begin(), plain.end(), '\t', ',');
  writeText(file("plain.csv"), plain);
  const std::string expected = labelledBy(file("plain.csv"));
  for (const char* const name : {"float", "semicolon", "sep", "tab", "utf16"})
    EXPECT_TRUE(labelledBy(reported("seeds_" + std::string(name) + ".csv")) == expected)
        << name;
}

TEST_F(ReportedSeedTables, MayNameAClass)
{
  if (!areThere())
    GTEST_SKIP() << "needs ../shared/cases";
  const std::string named = readText(reported("seeds_names.csv"));
  writeText(file("numbers.csv"), std::regex_replace(named, std::regex("chair"), "1"));
  EXPECT_TRUE(labelledBy(reported("seeds_names.csv")) ==
              labelledBy(file("numbers.csv")));
}

class HullsOfReportedFiles : public ToolTest {
protected:
  /** How far a place is outside of all hulls. */
  double
  outside(const Eigen::Vector3d& place) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const TriangleMesh& hull : readOBJ(file("hulls.obj")))
      least = std::min(least, excess(hull, place));
    return least;
  }
};

/// Before, one hull of 5.8 cubic metres around the sensor contained the scene.
TEST_F(HullsOfReportedFiles, HaveNothingAroundWhatDidNotReturn)
{
  if (!areThere())
    GTEST_SKIP() << "needs ../shared/cases";
  const std::string input = reported("no_returns_at_zero.pcd");
  ASSERT_EQ(run("pcl_cid_abstract", {input, file("hulls.obj"), "--verify"}).exit_code,
            0);
  EXPECT_GT(outside(Eigen::Vector3d::Zero()), 0.1);
  ASSERT_EQ(
      run("pcl_cid_abstract", {input, file("hulls.obj"), "--keep-zeros"}).exit_code, 0);
  EXPECT_LE(outside(Eigen::Vector3d::Zero()), 1e-7);
}

/// A box of points at UTM coordinates, and points astray that float does not hold
/// there.
TEST_F(HullsOfReportedFiles, ContainThePointsOfTheFileThatLieAstray)
{
  RandomGenerator generator(3);
  std::vector<Eigen::Vector3d> points;
  const auto draw = [&] {
    return 1e-6 * static_cast<double>(drawBelow(generator, 2000000));
  };
  for (int i = 0; i < 400; ++i) {
    const double x = draw();
    const double y = draw();
    points.emplace_back(691234.5 + x, 5334001.25 + y, 512.0 + (i % 2 == 0 ? 0.0 : 2.0));
  }
  points[100] = {0.0123456, 0.0, 0.0};
  points[200] = {-1234567.8912345, 5334001.3, 512.1};
  LabelledCloud cloud;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Eigen::Vector3d& p : points)
      values.push_back(p[axis]);
    appendField(std::string(1, "xyz"[axis]), values, cloud.fields);
  }
  saveCloud(file("utm.pcd"), cloud, pcd_binary);
  const ToolRun done = run("pcl_cid_abstract",
                           {file("utm.pcd"),
                            file("hulls.obj"),
                            "--seeds",
                            "10",
                            "--verify",
                            "--parts",
                            "4"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  for (const Eigen::Vector3d& p : points)
    EXPECT_LE(outside(p), 1e-4) << p.transpose();
}

/// A hull of the least thickness falls flat in an STL so far out: known before the
/// work.
TEST_F(HullsOfReportedFiles, AreRefusedBeforeTheWorkWhereAnSTLCannotHoldThem)
{
  const LabelledCloud cloud = deskScan();
  std::vector<double> x;
  for (const float value : valuesOf<float>(cloud.fields, "x"))
    x.push_back(value + 1e6);
  LabelledCloud far;
  appendField("x", x, far.fields);
  appendField("y", valuesOf<float>(cloud.fields, "y"), far.fields);
  appendField("z", valuesOf<float>(cloud.fields, "z"), far.fields);
  saveCloud(file("far.pcd"), far, pcd_binary);
  const ToolRun done = run("pcl_cid_abstract", {file("far.pcd"), file("hulls.stl")});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("a hull 0.005 m thick would lose its shape"),
            std::string::npos)
      << done.err;
  EXPECT_EQ(done.out.find("Decomposing"), std::string::npos) << done.out;
}

class LabelTypes : public ToolTest {};

TEST_F(LabelTypes, ThatCannotHoldTheSeedsAreRefusedBeforeTheWork)
{
  writeText(file("seeds.csv"), "index,label\n600,4000000000\n");
  for (const char* const type : {"I4", "F4"}) {
    const ToolRun done = run(
        "pcl_cid_segment",
        {scan_, file("out.pcd"), "--labels", file("seeds.csv"), "--label-type", type});
    EXPECT_EQ(done.exit_code, 1);
    EXPECT_NE(done.err.find("label 4000000000 does not fit"), std::string::npos);
    EXPECT_EQ(done.out.find("Segmenting"), std::string::npos) << done.out;
  }
}

} // namespace
} // namespace pcl_cid::test
