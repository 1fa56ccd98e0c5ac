/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Several scans in one call: what is refused before any of them is done.
 */

#include "many_scans_tool.h"

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;

TEST_F(ManyScansTest, WithOneNameAreRefused)
{
  fs::copy_file(file("scans/a.pcd"), file("a.pcd"));
  Arguments arguments = allScans({});
  arguments.push_back(file("a.pcd"));
  expectRefused(run("pcl_cid_segment", arguments),
                2,
                {file("scans/a.pcd") + " and " + file("a.pcd"), "same name, 'a'"});
}

TEST_F(ManyScansTest, AreNeverWrittenOver)
{
  const std::string bytes = readText(file("scans/c.pcd"));
  const auto into = [&](const std::string& folder) {
    return run("pcl_cid_segment",
               {scan_, file("scans/c.pcd"), "--output-dir", file(folder)});
  };
  expectRefused(into("scans"), 1, {"c.pcd: is the input", "never written over"});
  fs::create_hard_link(file("scans/c.pcd"), file("many/scan.pcd")); // another scan's
  const ToolRun linked = into("many");
  EXPECT_EQ(linked.exit_code, 1);
  EXPECT_NE(linked.err.find("scan.pcd: is the input " + file("scans/c.pcd")),
            std::string::npos)
      << linked.err;
  EXPECT_EQ(readText(file("scans/c.pcd")), bytes);
  EXPECT_FALSE(fs::exists(file("scans/scan.pcd")));
}

TEST_F(ManyScansTest, DoNotWriteOneFileTwice)
{
  fs::copy_file(file("scans/a.pcd"), file("scans/ax.pcd"));
  const ToolRun done = run("pcl_cid_segment",
                           {file("scans/a.pcd"),
                            file("scans/ax.pcd"),
                            "--output-dir",
                            file("many"),
                            "--report",
                            file("many/{}x.json"),
                            "--superpoints",
                            file("many/{}.json")});
  expectRefused(done,
                1,
                {"many/ax.json: would be written for " + file("scans/a.pcd") +
                 " and for " + file("scans/ax.pcd")});
  expectRefused(
      runAll("pcl_cid_segment",
             {"--summary", file("many/b.json"), "--report", file("many/{}.json")}),
      1,
      {"b.json: would be written for --summary and for"});
}

TEST_F(ManyScansTest, NeedAFolderForTheirOutputs)
{
  const auto into = [&](const std::string& folder) {
    return run("pcl_cid_abstract", {scan_, "--output-dir", file(folder)});
  };
  expectRefused(into("scans/a.pcd"), 1, {"a.pcd: exists and is not a folder"});
  expectRefused(into("no/new"), 1, {"no does not exist; create it first"});
  EXPECT_EQ(into("new").exit_code, 0);
  EXPECT_TRUE(fs::exists(file("new/scan.obj")));
}

TEST_F(ManyScansTest, NeedNamesOfTheirOwnForAllFiles)
{
  const auto refused = [&](const std::string& tool, const Arguments& options) {
    expectRefused(runAll(tool, options), 2, {options[0], "must hold {}"});
  };
  for (const char* const option : {"--propose", "--report", "--session", "--labels"})
    expectRefused(run("pcl_cid_segment",
                      {scan_, "--output-dir", file("many"), option, file("x.csv")}),
                  2,
                  {option, file("x.csv"), "must hold {}"});
  refused("pcl_cid_segment", {"--superpoints", file("x.json")});
  refused("pcl_cid_abstract", {"--labels", file("x.pcd")});
  refused("pcl_cid_abstract", {"--urdf", file("x.urdf")});
  refused("pcl_cid_abstract", {"--parts-dir", file("x")});
  refused("pcl_cid_abstract", {"--tree", file("x.json")});
  expectRefused(runAll("pcl_cid_abstract", {"--mesh-format", "dae"}), 2, {"obj, ply"});
  expectRefused(
      runAll("pcl_cid_segment", {"--summary", "x.txt"}), 2, {".csv or .json"});
  expectRefused(
      run("pcl_cid_segment", {"--output-dir", file("many")}), 2, {"given: 0"});
  expectRefused(run("pcl_cid_segment", {scan_, file("o.pcd"), "--summary", "x.csv"}),
                2,
                {"--summary has no effect without --output-dir"});
  expectRefused(
      runAll("pcl_cid_abstract", {"--urdf", file("many/{}.urdf"), "--name", "all"}),
      2,
      {"--name", "--output-dir"});
  expectRefused(run("pcl_cid_segment", {"-", scan_, "--output-dir", file("many")}),
                2,
                {"SCAN is '-'"});
  expectRefused(run("pcl_cid_segment", {scan_, scan_, scan_}),
                2,
                {"several scans need --output-dir"});
}

} // namespace
} // namespace pcl_cid::test
