/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Input that a tool must refuse: one sentence, exit 1, nothing written.
 */

#include "tool_process.h"

#include <cmath>
#include <csignal>
#include <filesystem>

#include <sys/stat.h>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

class BadInput : public ToolTest {
protected:
  /** A run must fail with one line that says so, and leave all files as they are. */
  void
  expectRefused(const std::string& tool,
                const Arguments& arguments,
                const Arguments& complaints)
  {
    const Arguments before = folder_.names();
    const ToolRun done = run(tool, arguments);
    EXPECT_EQ(done.exit_code, 1) << done.out << done.err;
    EXPECT_EQ(linesOf(done.err), 1u) << done.err;
    EXPECT_EQ(done.err.rfind(tool + ": ", 0), 0u) << done.err;
    for (const std::string& complaint : complaints)
      EXPECT_NE(done.err.find(complaint), std::string::npos) << done.err;
    EXPECT_EQ(folder_.names(), before);
  }

  void
  expectBothRefuse(const std::string& input, const Arguments& complaints)
  {
    expectRefused("pcl_cid_segment", {input, file("out.pcd")}, complaints);
    expectRefused("pcl_cid_abstract", {input, file("out.obj")}, complaints);
  }

  void
  expectSegmentRefuses(const Arguments& options, const Arguments& complaints)
  {
    Arguments arguments{scan_, file("out.pcd"), "--seeds", "5"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expectRefused("pcl_cid_segment", arguments, complaints);
  }

  /** A seeds.csv with these rows. */
  void
  expectTableRefused(const std::string& rows, const Arguments& complaints)
  {
    writeText(file("seeds.csv"), "index,x,y,z,label\n" + rows);
    Arguments all{"seeds.csv"};
    all.insert(all.end(), complaints.begin(), complaints.end());
    expectRefused("pcl_cid_segment",
                  {scan_, file("out.pcd"), "--labels", file("seeds.csv")},
                  all);
  }
};

TEST_F(BadInput, ThatIsMissingOrEmptyIsRefused)
{
  expectBothRefuse(file("missing.pcd"), {"missing.pcd", "no such file"});
  writeText(file("empty.pcd"), "");
  expectBothRefuse(file("empty.pcd"), {"empty.pcd", "is empty"});
  writeText(file("text.ply"), "hello\n");
  expectBothRefuse(file("text.ply"), {"text.ply", "neither a PCD, a PLY"});
}

TEST_F(BadInput, ThatIsTruncatedIsRefused)
{
  for (const auto& [name, format] : {std::pair("a.pcd", pcd_ascii),
                                     std::pair("b.pcd", pcd_binary),
                                     std::pair("c.pcd", pcd_compressed),
                                     std::pair("d.ply", ply_ascii),
                                     std::pair("e.ply", ply_binary)}) {
    saveCloud(file(name), deskScan(), format);
    const std::string whole = readText(file(name));
    for (const std::size_t size :
         {std::size_t{50}, whole.size() / 2, whole.size() - 9}) {
      writeText(file(name), whole.substr(0, size));
      expectBothRefuse(file(name), {name});
    }
  }
}

TEST_F(BadInput, WithoutCoordinatesIsRefused)
{
  writeText(file("flat.pcd"), "FIELDS x y\nPOINTS 2\nDATA ascii\n1 2\n3 4\n");
  expectBothRefuse(file("flat.pcd"), {"flat.pcd", "no field 'z'", "x, y"});
}

TEST_F(BadInput, WithoutFinitePointsIsRefused)
{
  writeText(file("void.pcd"), "FIELDS x y z\nPOINTS 2\nDATA ascii\nnan 0 0\n0 inf 0\n");
  expectBothRefuse(file("void.pcd"), {"void.pcd", "none of its 2 points is finite"});
}

TEST_F(BadInput, WithAnUnreadableLabelFieldIsRefused)
{
  expectSegmentRefuses({"--labels-from", "label"}, {"'label'", "x, y, z, rgb"});
  expectSegmentRefuses({"--labels-from", "x"}, {"field 'x'", "whole number"});
}

TEST_F(BadInput, InTheSeedTableIsRefused)
{
  expectTableRefused("1200,,,,1\n", {"line 2", "'1200'", "0 to 1199"});
  expectTableRefused("-3,,,,1\n", {"line 2", "'-3'"});
  expectTableRefused("5,,,,1\n6,,,,1\n5,,,,2\n", {"line 4", "label 2", "label 1"});
  expectTableRefused("5,,,,1.5\n", {"line 2", "'1.5'"});
  expectTableRefused("five,,,,1\n", {"line 2", "'five'"});
  expectTableRefused("5,,,,-1\n", {"line 2", "'-1'"});
  expectTableRefused("7,,,,1\n", {"line 2", "7", "not finite"});
  expectTableRefused("5,100,0,0,1\n", {"line 2", "100", "this cloud"});
  expectTableRefused("5,,,,\n", {"no label is filled in"});
  expectTableRefused("", {"no label is filled in"});
  expectRefused("pcl_cid_segment",
                {scan_, file("out.pcd"), "--labels", file("none.csv")},
                {"none.csv"});
}

TEST_F(BadInput, ThatWouldBeWrittenOverIsRefused)
{
  const std::string before = readText(scan_);
  fs::create_symlink("scan.pcd", file("link.pcd"));
  fs::create_hard_link(scan_, file("hard.pcd"));
  for (const char* const output : {"scan.pcd", "./scan.pcd", "link.pcd", "hard.pcd"})
    expectRefused("pcl_cid_segment", {scan_, file(output)}, {"never written over"});
  expectRefused("pcl_cid_segment", {file("link.pcd"), scan_}, {"never written over"});
  expectRefused("pcl_cid_segment",
                {scan_, file("out.pcd"), "--report", scan_},
                {"never written over"});
  expectRefused("pcl_cid_abstract",
                {scan_, file("out.obj"), "--labels", scan_},
                {"never written over"});
  writeText(file("seeds.csv"), "index,label\n5,1\n");
  expectRefused("pcl_cid_segment",
                {scan_,
                 file("out.pcd"),
                 "--labels",
                 file("seeds.csv"),
                 "--report",
                 file("seeds.csv")},
                {"never written over"});
  EXPECT_EQ(readText(scan_), before);
}

TEST_F(BadInput, NamesOfOutputsAreChecked)
{
  expectRefused(
      "pcl_cid_segment", {scan_, file("no/out.pcd")}, {"no", "does not exist"});
  expectRefused("pcl_cid_abstract", {scan_, file("no/out.obj")}, {"does not exist"});
  expectSegmentRefuses({"--report", file("no/report.json")}, {"does not exist"});
  expectSegmentRefuses({"--propose", file("no/seeds.csv")}, {"does not exist"});
  expectSegmentRefuses({"--report", file("out.pcd")}, {"written twice"});
  fs::create_directory(file("folder.pcd"));
  expectRefused("pcl_cid_segment", {scan_, file("folder.pcd")}, {"not a regular file"});
}

TEST_F(BadInput, LabelsAnAnnotatorFilledInAreNotLost)
{
  writeText(file("seeds.csv"), "index,x,y,z,label\n5,,,,3\n");
  expectSegmentRefuses({"--propose", file("seeds.csv")}, {"seeds.csv", "holds labels"});
}

TEST_F(BadInput, StartIndexMustBeAFinitePoint)
{
  expectSegmentRefuses({"--start-index", "7"}, {"7", "finite"});
  expectSegmentRefuses({"--start-index", "1200"}, {"1200"});
}

TEST_F(BadInput, AFullDiskLeavesNothing)
{
  const ToolRun done = run("/bin/sh",
                           {"-c",
                            "ulimit -f 4; exec \"$@\" 2>&1 | cat",
                            "sh",
                            PCL_CID_TOOL_DIR "/pcl_cid_segment",
                            scan_,
                            file("out.ply"),
                            "--seeds",
                            "5"});
  EXPECT_NE(done.out.find("could not be written in full"), std::string::npos)
      << done.out;
  EXPECT_EQ(folder_.names(), Arguments{"scan.pcd"});
}

TEST_F(BadInput, AnInterruptLeavesNothing)
{
  for (const int signal : {SIGINT, SIGTERM}) {
    ToolProcess process(
        "pcl_cid_segment",
        {PCL_CID_DATA_DIR "/room.pcd", file("out.pcd"), "--seeds", "5000"},
        printed_);
    for (int wait = 0; wait < 1000 && process.printedSoFar().empty(); ++wait)
      usleep(10000); // until "Loading ... done"
    process.signal(signal);
    const ToolRun done = process.wait();
    EXPECT_EQ(done.exit_code, 128 + signal);
    EXPECT_NE(done.err.find("interrupted"), std::string::npos) << done.err;
    EXPECT_EQ(folder_.names(), Arguments{"scan.pcd"});
  }
}

TEST_F(BadInput, MoreSeedsThanDistinctPointsIsAWarning)
{
  writeText(file("few.pcd"),
            "FIELDS x y z\nPOINTS 4\nDATA ascii\n0 0 0\n1 0 0\n0 0 0\n0 1 0\n");
  const ToolRun done = run("pcl_cid_segment", {file("few.pcd"), file("out.pcd")});
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_NE(done.err.find("3 seeds instead of 100"), std::string::npos) << done.err;
  const LabelledCloud labelled = readCloud(file("out.pcd"));
  const auto labels = valuesOf<std::uint32_t>(labelled.fields, "label");
  EXPECT_EQ(labels[0], labels[2]);
  const ToolRun quiet =
      run("pcl_cid_segment", {file("few.pcd"), file("out.pcd"), "--quiet"});
  EXPECT_EQ(quiet.out + quiet.err, "");
}

} // namespace
} // namespace pcl_cid::test
