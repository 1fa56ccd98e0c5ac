/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Command lines: help, version, and everything that is wrong with them.
 */

#include "tool_process.h"

#include <pcl_cid/version.h>

namespace pcl_cid::test {
namespace {

using Arguments = std::vector<std::string>;

const Arguments tools{"pcl_cid_segment", "pcl_cid_abstract"};

TEST_F(ToolTest, PrintHelpWhereverItIsAskedFor)
{
  for (const std::string& tool : tools)
    for (const Arguments& arguments : {Arguments{"--help"},
                                       Arguments{"-h"},
                                       Arguments{scan_, file("out.ply"), "-h"},
                                       Arguments{"--nonsense", "--help", "--seeds"}}) {
      const ToolRun done = run(tool, arguments);
      EXPECT_EQ(done.exit_code, 0);
      EXPECT_EQ(done.err, "");
      EXPECT_NE(done.out.find("Usage: " + tool + " INPUT OUTPUT"), std::string::npos);
      for (const char* const option : {"seeds",
                                       "coverage",
                                       "samples",
                                       "subsample",
                                       "random-seed",
                                       "threads",
                                       "report",
                                       "quiet"})
        EXPECT_NE(done.out.find(std::string("--") + option), std::string::npos);
    }
  EXPECT_EQ(folder_.names(), Arguments{"scan.pcd"});
}

TEST_F(ToolTest, PrintTheirVersion)
{
  for (const std::string& tool : tools) {
    const ToolRun done = run(tool, {"--version"});
    EXPECT_EQ(done.exit_code, 0);
    EXPECT_EQ(done.out, tool + " " PCL_CID_VERSION "\n");
    EXPECT_EQ(done.err, "");
  }
}

TEST_F(ToolTest, PrintWhatManAndBashWantOfThem)
{
  for (const std::string& tool : tools) {
    const ToolRun page = run(tool, {scan_, "--man-page"});
    EXPECT_EQ(page.exit_code, 0);
    EXPECT_EQ(page.out.rfind(".TH ", 0), 0u);
    EXPECT_NE(page.out.find("\\fB\\-\\-seeds\\fR \\fIK\\fR\n"), std::string::npos);
    const ToolRun completion = run(tool, {"--nonsense", "--completion"});
    EXPECT_EQ(completion.exit_code, 0);
    EXPECT_NE(completion.out.find("complete -F _" + tool + " " + tool),
              std::string::npos);
    EXPECT_EQ(page.err + completion.err, "");
  }
}

struct WrongLine {
  Arguments options;
  Arguments complaints; ///< what the message must contain
};

class WrongCommandLine : public ToolTest {
protected:
  void
  expectRefused(const std::string& tool,
                const Arguments& arguments,
                const Arguments& complaints)
  {
    const ToolRun done = run(tool, arguments);
    EXPECT_EQ(done.exit_code, 2) << done.err;
    EXPECT_EQ(done.out, "");
    EXPECT_EQ(linesOf(done.err), 1u) << done.err;
    EXPECT_EQ(done.err.rfind(tool + ": ", 0), 0u) << done.err;
    for (const std::string& complaint : complaints)
      EXPECT_NE(done.err.find(complaint), std::string::npos) << done.err;
    EXPECT_EQ(folder_.names(), Arguments{"scan.pcd"});
  }

  void
  expectAllRefused(const std::string& tool,
                   const std::string& output,
                   const std::vector<WrongLine>& lines)
  {
    for (const WrongLine& line : lines) {
      Arguments arguments{scan_, file(output)};
      arguments.insert(arguments.end(), line.options.begin(), line.options.end());
      expectRefused(tool, arguments, line.complaints);
    }
  }
};

TEST_F(WrongCommandLine, OfBothToolsIsRefused)
{
  const std::vector<WrongLine> lines{
      {{"--seeds", "0"}, {"--seeds", "'0'", "at least 1"}},
      {{"--seeds", "-5"}, {"--seeds", "'-5'"}},
      {{"--seeds=-5"}, {"--seeds", "'-5'"}},
      {{"--seeds", "10x"}, {"--seeds", "'10x'"}},
      {{"--seeds", "1e3"}, {"--seeds", "'1e3'"}},
      {{"--seeds", "99999999999"}, {"--seeds", "'99999999999'"}},
      {{"--seeds", ""}, {"--seeds"}},
      {{"--seeds"}, {"--seeds"}},
      {{"--seeds", "5", "--seeds", "6"}, {"--seeds"}},
      {{"--seed", "5"}, {"--seed"}},
      {{"--coverage", "nan"}, {"--coverage", "'nan'", "metres above 0"}},
      {{"--coverage", "-0.1"}, {"--coverage", "'-0.1'"}},
      {{"--coverage", "0"}, {"--coverage", "'0'"}},
      {{"--coverage", "inf"}, {"--coverage", "'inf'"}},
      {{"--coverage", "5cm"}, {"--coverage", "'5cm'"}},
      {{"--samples", "1"}, {"--samples", "'1'", "2 to 1048576"}},
      {{"--samples", "2000000"}, {"--samples", "'2000000'"}},
      {{"--subsample", "-1"}, {"--subsample", "'-1'"}},
      {{"--random-seed", "-1"}, {"--random-seed", "'-1'"}},
      {{"--random-seed", "18446744073709551616"}, {"--random-seed"}},
      {{"--start-index", "-1"}, {"--start-index", "'-1'"}},
      {{"--threads", "-2"}, {"--threads", "'-2'"}},
      {{"--threads", "1000000"}, {"--threads", "'1000000'"}},
      {{"--label-type", "U2"}, {"--label-type", "'U2'", "U4, I4 or F4"}},
      {{"--report", ""}, {"--report"}},
      {{"--nonsense"}, {"--nonsense"}},
      {{"-q"}, {"-q"}},
      {{"third"}, {"INPUT and OUTPUT", "3"}}};
  expectAllRefused("pcl_cid_segment", "out.pcd", lines);
  expectAllRefused("pcl_cid_abstract", "out.obj", lines);
}

TEST_F(WrongCommandLine, OfSegmentIsRefused)
{
  expectAllRefused(
      "pcl_cid_segment",
      "out.pcd",
      {{{"--labels", "a.csv", "--labels-from", "label"}, {"--labels-from"}},
       {{"--labels", "a.csv", "--propose", "b.csv"}, {"--propose"}},
       {{"--labels", "a.csv", "--seeds", "7"}, {"--seeds"}},
       {{"--labels", "a.csv", "--coverage", "7"}, {"--coverage"}},
       {{"--labels", "a.csv", "--start-index", "7"}, {"--start-index"}},
       {{"--parts", "3"}, {"--parts"}}});
  expectAllRefused("pcl_cid_segment", "out.xyz", {{{}, {"OUTPUT", ".pcd or .ply"}}});
}

TEST_F(WrongCommandLine, OfAbstractIsRefused)
{
  expectAllRefused(
      "pcl_cid_abstract",
      "out.obj",
      {{{"--parts", "0"}, {"--parts", "'0'", "at least 1"}},
       {{"--threshold", "-0.5"}, {"--threshold", "'-0.5'"}},
       {{"--threshold", "nan"}, {"--threshold", "'nan'"}},
       {{"--merges", "-1"}, {"--merges", "'-1'"}},
       {{"--group-samples", "0"}, {"--group-samples", "'0'"}},
       {{"--groups", "planes"}, {"--groups", "planes"}},
       {{"--groups", "patches", "--coverage", "0.1"}, {"--coverage", "--groups"}},
       {{"--groups", "patches", "--start-index", "3"}, {"--start-index", "--groups"}},
       {{"--groups", "patches", "--seeding", "soft"}, {"--seeding", "--groups"}},
       {{"--groups", "patches", "--merging", "hull", "--parts", "3"},
        {"--groups", "--merging hull"}},
       {{"--groups", "patches", "--session", "s.jsonl"}, {"--session", "--groups"}},
       {{"--min-thickness", "0"}, {"--min-thickness", "'0'"}},
       {{"--parts", "3", "--threshold", "1"}, {"--parts", "--threshold"}},
       {{"--parts", "3", "--merges", "1"}, {"--parts", "--merges"}},
       {{"--threshold", "3", "--merges", "1"}, {"--threshold", "--merges"}},
       {{"--labels", "out.csv"}, {"--labels", ".pcd or .ply"}},
       {{"--propose", "a.csv"}, {"--propose"}}});
  expectAllRefused("pcl_cid_abstract", "out.dae", {{{}, {"OUTPUT", ".obj"}}});
}

TEST_F(WrongCommandLine, WithoutTwoFilesIsRefused)
{
  for (const std::string& tool : tools) {
    expectRefused(tool, {}, {"INPUT and OUTPUT", "0"});
    expectRefused(tool, {scan_}, {"INPUT and OUTPUT", "1"});
  }
}

} // namespace
} // namespace pcl_cid::test
