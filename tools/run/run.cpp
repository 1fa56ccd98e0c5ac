/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A run of a tool: its console, its report and its outputs; how it ends.
 */

#include "run.h"

#include "command_line.h"
#include "interruption.h"

#include <pcl_cid/exceptions.h>

#include <cstdio>
#include <cstdlib>
#include <new>
#include <ostream>

namespace pcl_cid::tools {
namespace {

int
fail(const std::string& tool, const std::string& message)
{
  std::fflush(stdout);
  std::fprintf(stderr, "%s: %s\n", tool.c_str(), message.c_str());
  return EXIT_FAILURE;
}

int
failInterrupted(const std::string& tool)
{
  fail(tool, "interrupted; nothing was written");
  return 128 + caughtSignal();
}

} // namespace

Run::Run(const std::string& tool, bool quiet, const std::vector<std::string>& inputs)
: console(quiet), outputs(inputs)
{
  report.tool = tool;
}

void
Run::begin(const std::string& step)
{
  console.begin(step);
}

void
Run::end(const std::string& result, const std::string& name)
{
  report.steps.push_back({name, console.end(result)});
}

void
Run::finish(const std::string& report_path)
{
  if (!report_path.empty())
    outputs.write(report_path, [&](std::ostream& stream) { stream << toJson(report); });
  outputs.commit();
}

std::string
messageOf(const std::exception& error)
{
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
    return "there is not enough memory for so many points; give it fewer";
  return error.what();
}

int
runTool(const std::string& tool, const std::function<void()>& work)
{
  catchSignals();
  try {
    work();
    return EXIT_SUCCESS;
  }
  catch (const UsageError& error) {
    fail(tool, std::string(error.what()) + "; see " + tool + " --help");
    return 2;
  }
  catch (const Interrupted&) {
    return failInterrupted(tool);
  }
  catch (const CIDCancelled&) {
    return failInterrupted(tool);
  }
  catch (const std::exception& error) {
    return fail(tool, messageOf(error));
  }
}

} // namespace pcl_cid::tools
