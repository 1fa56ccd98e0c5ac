/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A run of a tool: its console, its report and its outputs; how it ends.
 */

#pragma once

#include "console.h"

#include <pcl_cid/io/cloud_format.h>
#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/report.h>

#include <exception>
#include <functional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief The outputs of a tool: its only ones, or made and gone while older ones are
 *  there. They are discarded also when the program must end at once, as when a
 *  destructor lacks memory. */
class ToolOutputs : public OutputFiles {
public:
  /** \param[in] inputs files that must never be written over, beside those of the older
   *  ones */
  explicit ToolOutputs(const std::vector<std::string>& inputs);
  ~ToolOutputs();

  /** \brief Discard these and the older ones. */
  void
  discardAll() noexcept;

private:
  ToolOutputs* before_;
};

/** \brief What the steps of a run share. */
struct Run {
  /** \param[in] tool its name, for the report
   *  \param[in] inputs files that must never be written over */
  Run(const std::string& tool, bool quiet, const std::vector<std::string>& inputs);

  /** \brief Begin a step.
   *  \throws Interrupted */
  void
  begin(const std::string& step);

  /** \brief End it, and keep its seconds for the report.
   *  \param[in] result for the user: "3400 points"
   *  \param[in] name of the step in the report */
  void
  end(const std::string& result, const std::string& name);

  /** \brief What takes a remark on the input to the user and the report; to be used as
   *  long as this lives. */
  RemarkCallback
  remark();

  /** \brief The end of the run: write the report, unless its path is empty, and put all
   *  outputs in place. */
  void
  finish(const std::string& report_path);

  Console console;
  Report report;
  ToolOutputs outputs;
};

/** \brief What to tell the user about an error, and what to do about it; valid as long
 *  as the error. */
const char*
messageOf(const std::exception& error);

/** \brief Run a tool: exceptions become messages and exit codes.
 *  \param[in] work returns when all is done
 *  \return 0; 1 when the work failed or what it printed was lost; 2 when the command
 *  line is wrong; 128 + the signal when one ended the run */
int
runTool(const char* tool, const std::function<void()>& work);

} // namespace pcl_cid::tools
