/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Tools that lack memory end with a sentence and leave nothing; tools that lack threads
 * go on without them.
 */

#include "tool_process.h"

#include <filesystem>
#include <map>
#include <set>

namespace pcl_cid::test {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;
using Files = std::map<std::string, std::string>;

class LackOfMemory : public ToolTest {
protected:
  /** \param[in] variables for failing_memory.cpp */
  ToolRun
  runWith(const Arguments& variables, const Arguments& command) const
  {
    Arguments words{"LD_PRELOAD=" PCL_CID_FAILING_MEMORY};
    words.insert(words.end(), variables.begin(), variables.end());
    words.push_back(PCL_CID_TOOL_DIR "/" + command.front());
    words.insert(words.end(), command.begin() + 1, command.end());
    return run("/usr/bin/env", words);
  }

  /** All files of the run, hidden ones too; of reports, which hold times, the name
   *  alone. */
  Files
  takeFiles() const
  {
    Files files;
    for (const auto& entry : fs::recursive_directory_iterator(file("")))
      if (entry.is_regular_file() && entry.path() != scan_)
        files[entry.path().filename()] =
            entry.path().extension() == ".json" ? "" : readText(entry.path().string());
    for (const auto& [name, text] : files)
      fs::remove(file(name));
    fs::remove_all(file("parts"));
    return files;
  }

  /** Requests of memory in a run that gets all, and what it writes. */
  long
  countRequests(const Arguments& command, Files& expected) const
  {
    const ToolRun done = runWith({"MEMORY_COUNT=" + printed_.file("count")}, command);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    expected = takeFiles();
    return std::stol(readText(printed_.file("count")));
  }

  /** Whatever is asked for in vain, a run gives what is expected or nothing. */
  void
  expectAllOrNothing(const std::string& variable,
                     const Arguments& command,
                     const std::set<long>& moments,
                     const Files& expected) const
  {
    for (const long moment : moments) {
      SCOPED_TRACE(variable + std::to_string(moment));
      const ToolRun done = runWith({variable + std::to_string(moment)}, command);
      const Files files = takeFiles();
      if (done.exit_code == 0) {
        EXPECT_TRUE(files == expected);
        continue;
      }
      EXPECT_EQ(done.exit_code, 1) << done.err;
      EXPECT_NE(done.err.find(command.front() + ": "), std::string::npos) << done.err;
      EXPECT_EQ(files, Files());
    }
  }

  /** Moments in the beginning and all along. */
  void
  expectAllOrNothing(const Arguments& command) const
  {
    Files expected;
    const long requests = countRequests(command, expected);
    std::set<long> moments;
    for (long moment = 1; moment < requests; moment += moment / 2 + 1)
      moments.insert(moment);
    expectAllOrNothing("MEMORY_FAILS_FROM=", command, moments, expected);
    moments.clear();
    for (long k = 1; k <= 20; ++k)
      moments.insert(requests * k / 21);
    expectAllOrNothing("MEMORY_FAILS_AT=", command, moments, expected);
    expectAllOrNothing("MEMORY_FAILS_FROM=", command, {requests - 50}, expected);
  }

  Arguments
  segmenting(const std::string& threads) const
  {
    return {"pcl_cid_segment",
            scan_,
            file("labels.ply"),
            "--seeds",
            "5",
            "--threads",
            threads,
            "--report",
            file("report.json")};
  }
};

TEST_F(LackOfMemory, LetsASegmentationEndWithASentence)
{
  expectAllOrNothing(segmenting("1"));
}

TEST_F(LackOfMemory, LetsAnAbstractionEndWithASentence)
{
  expectAllOrNothing({"pcl_cid_abstract",
                      scan_,
                      file("hulls.obj"),
                      "--seeds",
                      "5",
                      "--threads",
                      "1",
                      "--verify",
                      "--parts-dir",
                      file("parts"),
                      "--report",
                      file("report.json")});
}

TEST_F(LackOfMemory, OrOfThreadsChangesNothing)
{
  ASSERT_EQ(runWith({}, segmenting("1")).exit_code, 0);
  const Files expected = takeFiles();
  for (const char* const threads : {"THREADS=0", "THREADS=2"}) {
    const ToolRun done = runWith({threads}, segmenting("1024"));
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_TRUE(takeFiles() == expected);
  }
}

TEST_F(LackOfMemory, OfWhichThreadsWouldTakeAllLeavesEnoughForTheWork)
{
  ASSERT_EQ(runWith({}, segmenting("1")).exit_code, 0);
  const Files expected = takeFiles();
  for (const char* const kilobytes : {"1000000", "1500000", "2000000"}) {
    Arguments words{"-c",
                    std::string("ulimit -v ") + kilobytes + "; exec \"$@\"",
                    "sh",
                    PCL_CID_TOOL_DIR "/pcl_cid_segment"};
    const Arguments command = segmenting("1024");
    words.insert(words.end(), command.begin() + 1, command.end());
    const ToolRun done = run("/bin/sh", words);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_TRUE(takeFiles() == expected) << kilobytes;
  }
}

} // namespace
} // namespace pcl_cid::test
