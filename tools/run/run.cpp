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

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <ostream>

#include <unistd.h>

namespace pcl_cid::tools {
namespace {

/** The last ones that the tool has, as long as it has any. */
ToolOutputs* outputs_of_tool = nullptr;

/** What follows the want of memory must not ask for any: hence no strings here. */
int
fail(const char* tool, const char* message)
{
  std::fflush(stdout);
  std::fprintf(stderr, "%s: %s\n", tool, message);
  return EXIT_FAILURE;
}

int
failInterrupted(const char* tool, const Interrupted& left)
{
  fail(tool, ("interrupted; " + std::string(left.what())).c_str());
  return 128 + caughtSignal();
}

int
failUsage(const char* tool, const UsageError& error)
{
  std::fprintf(stderr, "%s: %s; see %s --help\n", tool, error.what(), tool);
  return 2;
}

[[noreturn]] void
endWithoutMemory()
{
  _exit(fail(program_invocation_short_name, "there is not enough memory to go on"));
}

/** Destructors and other people's code cannot pass the want of memory on. Everything
 *  else that ends here is a mistake in the program. */
[[noreturn]] void
endAtOnce()
{
  if (outputs_of_tool != nullptr)
    outputs_of_tool->discardAll();
  try {
    if (std::current_exception())
      throw;
  }
  catch (const std::bad_alloc&) {
  }
  catch (...) {
    std::abort();
  }
  endWithoutMemory();
}

/** qhull leaves by exit() where PCL calls it without a way back. */
void
endedByOthers()
{
  if (outputs_of_tool == nullptr)
    return;
  outputs_of_tool->discardAll();
  endWithoutMemory();
}

} // namespace

ToolOutputs::ToolOutputs(const std::vector<std::string>& inputs)
: OutputFiles(inputs, outputs_of_tool), before_(outputs_of_tool)
{
  outputs_of_tool = this;
}

ToolOutputs::~ToolOutputs()
{
  ToolOutputs** place = &outputs_of_tool;
  while (*place != this)
    place = &(*place)->before_;
  *place = before_;
}

void
ToolOutputs::discardAll() noexcept
{
  for (ToolOutputs* outputs = this; outputs != nullptr; outputs = outputs->before_)
    outputs->discard();
}

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

RemarkCallback
Run::remark()
{
  return [this](const std::string& sentence) {
    console.remark(sentence);
    report.remarks.push_back(sentence);
  };
}

void
Run::finish(const std::string& report_path)
{
  if (!report_path.empty())
    outputs.write(report_path, [&](std::ostream& stream) { stream << toJson(report); });
  outputs.commit();
}

const char*
messageOf(const std::exception& error)
{
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
    return "there is not enough memory for so many points; give it fewer";
  return error.what();
}

int
runTool(const char* tool, const std::function<void()>& work)
{
  std::set_terminate(endAtOnce);
  std::atexit(endedByOthers);
  occupyClosedStreams();
  catchSignals();
  try {
    work();
    requirePrinted();
    return EXIT_SUCCESS;
  }
  catch (const UsageError& error) {
    return failUsage(tool, error);
  }
  catch (const Interrupted& left) {
    return failInterrupted(tool, left);
  }
  catch (const CIDCancelled&) {
    return failInterrupted(tool, Interrupted());
  }
  catch (const std::exception& error) {
    return fail(tool, messageOf(error));
  }
}

} // namespace pcl_cid::tools
