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

#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/report.h>

#include <exception>
#include <functional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

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

  /** \brief The end of the run: write the report, unless its path is empty, and put all
   *  outputs in place. */
  void
  finish(const std::string& report_path);

  Console console;
  Report report;
  OutputFiles outputs;
};

/** \brief What to tell the user about an error, and what to do about it. */
std::string
messageOf(const std::exception& error);

/** \brief Run a tool: exceptions become messages and exit codes.
 *  \param[in] work returns when all is done
 *  \return 0; 1 when the work failed; 2 when the command line is wrong; 128 + the
 *  signal when one ended the run */
int
runTool(const std::string& tool, const std::function<void()>& work);

} // namespace pcl_cid::tools
