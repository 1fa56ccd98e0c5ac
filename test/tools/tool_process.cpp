/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The tools as processes.
 */

#include "tool_process.h"

#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace pcl_cid::test {
namespace {

std::string
programOf(const std::string& tool)
{
  return tool.find('/') == std::string::npos ? PCL_CID_TOOL_DIR "/" + tool : tool;
}

int
openTerminal()
{
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0)
    throw std::runtime_error("cannot open a terminal");
  return terminal;
}

} // namespace

ToolProcess::ToolProcess(const std::string& tool,
                         const std::vector<std::string>& arguments,
                         const TemporaryFolder& folder,
                         bool with_terminal)
: out_(folder.file("out")), err_(folder.file("err"))
{
  std::vector<std::string> words{programOf(tool)};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);

  constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out_.c_str(), flags, 0600);
  if (with_terminal) {
    terminal_ = openTerminal();
    posix_spawn_file_actions_addopen(
        &actions, STDERR_FILENO, ptsname(terminal_), O_WRONLY | O_NOCTTY, 0);
  }
  else
    posix_spawn_file_actions_addopen(
        &actions, STDERR_FILENO, err_.c_str(), flags, 0600);
  const int error =
      posix_spawn(&process_, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    throw std::runtime_error("cannot start " + words[0]);
}

void
ToolProcess::signal(int number) const
{
  kill(process_, number);
}

std::string
ToolProcess::printedSoFar() const
{
  return readText(out_);
}

ToolRun
ToolProcess::wait()
{
  ToolRun run;
  if (terminal_ >= 0) {
    char buffer[4096]; // reading ends with an error once nobody can write
    for (ssize_t count; (count = read(terminal_, buffer, sizeof(buffer))) > 0;)
      run.err.append(buffer, static_cast<std::size_t>(count));
    close(terminal_);
  }
  int status = 0;
  waitpid(process_, &status, 0);
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = readText(out_);
  if (terminal_ < 0)
    run.err = readText(err_);
  return run;
}

ToolTest::ToolTest()
{
  saveCloud(scan_, deskScan(), pcd_compressed);
}

ToolRun
ToolTest::run(const std::string& tool, const std::vector<std::string>& arguments) const
{
  return ToolProcess(tool, arguments, printed_).wait();
}

ToolRun
ToolTest::runFromSmallProcess(const std::string& tool,
                              const std::vector<std::string>& arguments) const
{
  std::vector<std::string> of_shell{"-c", "\"$@\"; exit $?", "sh", programOf(tool)};
  of_shell.insert(of_shell.end(), arguments.begin(), arguments.end());
  return run("/bin/sh", of_shell);
}

ToolRun
ToolTest::segment(std::vector<std::string> arguments) const
{
  if (std::find(arguments.begin(), arguments.end(), "--labels") == arguments.end())
    arguments.insert(arguments.end(), {"--seeds", "12"});
  const ToolRun done = run("pcl_cid_segment", arguments);
  EXPECT_EQ(done.exit_code, 0) << done.err;
  return done;
}

ToolRun
ToolTest::abstract(std::vector<std::string> arguments) const
{
  if (std::find(arguments.begin(), arguments.end(), "hull") == arguments.end())
    arguments.insert(arguments.end(), {"--seeds", "12"});
  const ToolRun done = run("pcl_cid_abstract", arguments);
  EXPECT_EQ(done.exit_code, 0) << done.err;
  return done;
}

std::size_t
linesOf(const std::string& text)
{
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

} // namespace pcl_cid::test
