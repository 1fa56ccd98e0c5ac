/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan from the standard input, a labelled cloud to the standard output.
 */

#include "tool_process.h"

namespace pcl_cid::test {
namespace {

class StandardStreams : public ToolTest {
protected:
  /** Run pcl_cid_segment in a shell.
   *  \param[in] input a file for its standard input */
  ToolRun
  segmentFrom(const std::string& input, const std::string& arguments) const
  {
    return run("/bin/sh",
               {"-c",
                PCL_CID_TOOL_DIR "/pcl_cid_segment " + arguments +
                    " --seeds 7 --threads 2 < '" + input + "'"});
  }
};

TEST_F(StandardStreams, HoldWhatFilesDo)
{
  EXPECT_EQ(segmentFrom("/dev/null", scan_ + " " + file("by_name.pcd")).exit_code, 0);
  const ToolRun both = segmentFrom(scan_, "- -");
  EXPECT_EQ(both.exit_code, 0) << both.err;
  EXPECT_EQ(both.out, readText(file("by_name.pcd")));

  EXPECT_EQ(segmentFrom(scan_, "- " + file("from_input.pcd")).exit_code, 0);
  EXPECT_EQ(readText(file("from_input.pcd")), readText(file("by_name.pcd")));
  const ToolRun to_output = segmentFrom("/dev/null", scan_ + " -");
  EXPECT_EQ(to_output.out, readText(file("by_name.pcd")));
}

TEST_F(StandardStreams, TakeAFormatThatNothingElseTells)
{
  writeText(file("points"), "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const ToolRun unknown = segmentFrom(file("points"), "- -");
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_EQ(unknown.out, "");
  EXPECT_NE(unknown.err.find("--input-format"), std::string::npos) << unknown.err;

  const ToolRun text = segmentFrom(file("points"), "- - --input-format xyz");
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_EQ(text.out.rfind("# .PCD", 0), 0u);
  EXPECT_NE(text.out.find("POINTS 4"), std::string::npos);
  // What is no point cloud is said on the other stream.
  EXPECT_NE(text.err.find("by their order"), std::string::npos) << text.err;
}

TEST_F(StandardStreams, AreRefusedWhereTheyAreTorn)
{
  writeText(file("torn"), readText(scan_).substr(0, 900));
  const ToolRun torn = segmentFrom(file("torn"), "- -");
  EXPECT_EQ(torn.exit_code, 1);
  EXPECT_EQ(torn.out, "");
  EXPECT_EQ(segmentFrom("/dev/null", "- -").exit_code, 1);
  const ToolRun full = segmentFrom(scan_, "- - > /dev/full");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_NE(full.err.find("standard output"), std::string::npos) << full.err;
}

TEST_F(StandardStreams, AppearAfterAllOtherOutputs)
{
  const ToolRun refused =
      segmentFrom(scan_, "- - --report " + file("no/such/folder/report.json"));
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.out, "");
  EXPECT_EQ(run("pcl_cid_abstract", {scan_, "-"}).exit_code, 2);
}

} // namespace
} // namespace pcl_cid::test
