/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the tools print reaches its reader, or the exit code says that it did not.
 */

#include "tool_process.h"

namespace pcl_cid::test {
namespace {

using Arguments = std::vector<std::string>;

class StandardOutput : public ToolTest {
protected:
  /** \param[in] redirection as a shell writes it */
  ToolRun
  runInto(const std::string& redirection,
          const std::string& tool,
          const Arguments& arguments) const
  {
    Arguments words{
        "-c", "exec \"$@\" " + redirection, "sh", PCL_CID_TOOL_DIR "/" + tool};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run("/bin/sh", words);
  }

  Arguments
  labelling(const std::string& output) const
  {
    return {scan_, file(output), "--seeds", "12"};
  }
};

void
expectLost(const ToolRun& run)
{
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("the standard output could not be written in full"),
            std::string::npos)
      << run.err;
  EXPECT_EQ(linesOf(run.err), 1u) << run.err;
}

TEST_F(StandardOutput, ThatIsLostIsAnError)
{
  for (const char* const tool :
       {"pcl_cid_segment", "pcl_cid_abstract", "pcl_cid_evaluate"})
    for (const char* const option : {"--help", "--version"})
      for (const char* const redirection : {"> /dev/full", ">&-"}) {
        SCOPED_TRACE(testing::Message() << tool << option << redirection);
        expectLost(runInto(redirection, tool, {option}));
      }
  segment({scan_, file("a.pcd")});
  expectLost(
      runInto("> /dev/full", "pcl_cid_evaluate", {file("a.pcd"), file("a.pcd")}));
}

TEST_F(StandardOutput, ThatIsLostTakesNoFileWithIt)
{
  segment({scan_, file("expected.pcd")});
  for (const char* const redirection : {"> /dev/full", ">&-", "<&- >&-"}) {
    SCOPED_TRACE(redirection);
    expectLost(runInto(redirection, "pcl_cid_segment", labelling("out.pcd")));
    EXPECT_TRUE(readText(file("out.pcd")) == readText(file("expected.pcd")));
  }
}

TEST_F(StandardOutput, IsNotMissedByAQuietRun)
{
  for (const char* const redirection : {"> /dev/full", ">&-", "<&- >&- 2>&-"}) {
    SCOPED_TRACE(redirection);
    Arguments arguments = labelling("out.pcd");
    arguments.emplace_back("--quiet");
    EXPECT_EQ(runInto(redirection, "pcl_cid_segment", arguments).exit_code, 0);
  }
}

} // namespace
} // namespace pcl_cid::test
