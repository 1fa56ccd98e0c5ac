/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The browser of whoever sits before the screen.
 */

#include "browser.h"

#include <csignal>
#include <cstdlib>

#include <spawn.h>

extern char** environ;

namespace pcl_cid::studio {
namespace {

bool
isSet(const char* variable)
{
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

} // namespace

bool
openBrowser(const std::string& url)
{
  if (!isSet("DISPLAY") && !isSet("WAYLAND_DISPLAY"))
    return false;
  // It may run as long as the browser: nobody waits for it, so the system clears it
  // away.
  std::signal(SIGCHLD, SIG_IGN);
  std::string program = "xdg-open";
  std::string address = url;
  char* arguments[] = {program.data(), address.data(), nullptr};
  pid_t child = 0;
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  for (const int stream : {1, 2})
    posix_spawn_file_actions_addopen(&quiet, stream, "/dev/null", 1, 0);
  const int reason =
      posix_spawnp(&child, program.c_str(), &quiet, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&quiet);
  return reason == 0;
}

} // namespace pcl_cid::studio
