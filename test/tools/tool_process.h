/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The tools as processes.
 */

#pragma once

#include "cloud_files.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <sys/types.h>

namespace pcl_cid::test {

/** \brief How a process ended and what it printed. */
struct ToolRun {
  /** Exit code; 128 + the signal when one killed it. */
  int exit_code = -1;
  std::string out;
  std::string err;
};

/** \brief A process that may still run. */
class ToolProcess {
public:
  /** \param[in] tool name of a program of the build, or path of any
   *  \param[in] folder for what it prints
   *  \param[in] with_terminal whether its standard error is a terminal */
  ToolProcess(const std::string& tool,
              const std::vector<std::string>& arguments,
              const TemporaryFolder& folder,
              bool with_terminal = false);

  /** \brief Send a signal. */
  void
  signal(int number) const;

  /** \brief What it has printed to the standard output so far. */
  std::string
  printedSoFar() const;

  /** \brief Wait for its end. */
  ToolRun
  wait();

private:
  std::string out_;
  std::string err_;
  pid_t process_ = -1;
  int terminal_ = -1;
};

/** \brief A folder with the desk scan as scan.pcd, and short ways to run the tools. */
class ToolTest : public testing::Test {
protected:
  ToolTest();

  /** \brief Run a tool to its end. */
  ToolRun
  run(const std::string& tool, const std::vector<std::string>& arguments) const;

  /** \brief The same, from a small process. The peak of the memory of a process
   * includes that of the one which started it, and this one may be large. */
  ToolRun
  runFromSmallProcess(const std::string& tool,
                      const std::vector<std::string>& arguments) const;

  /** \brief Run pcl_cid_segment with a few seeds; it must succeed. */
  ToolRun
  segment(std::vector<std::string> arguments) const;

  /** \brief Run pcl_cid_abstract with a few seeds; it must succeed. */
  ToolRun
  abstract(std::vector<std::string> arguments) const;

  std::string
  file(const std::string& name) const
  {
    return folder_.file(name);
  }

  TemporaryFolder folder_;
  /** What the tools print, apart from what they write. */
  TemporaryFolder printed_;
  std::string scan_ = folder_.file("scan.pcd");
};

/** \brief Number of lines. */
std::size_t
linesOf(const std::string& text);

} // namespace pcl_cid::test
