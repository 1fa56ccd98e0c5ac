/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Calls that change files, disturbed.
 */

#include "disturbed_calls.h"

#include <cerrno>
#include <csignal>
#include <cstdio>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace pcl_cid::test {
namespace {

Disturbance planned = Disturbance::none;
int calls_left = 0;

/** Whether a call must fail; those that are to end the process do not return. */
bool
mustFail()
{
  if (planned == Disturbance::none || --calls_left >= 0)
    return false;
  errno = EIO;
  if (planned == Disturbance::fail_from_there)
    return true;
  if (calls_left < -1)
    return false;
  if (planned == Disturbance::kill)
    raise(SIGKILL);
  if (planned == Disturbance::stop)
    raise(SIGSTOP);
  return planned == Disturbance::fail;
}

} // namespace

void
disturb(Disturbance disturbance, int call)
{
  planned = disturbance;
  calls_left = call;
}

bool
wasDisturbed()
{
  return planned != Disturbance::none && calls_left < 0;
}

} // namespace pcl_cid::test

using pcl_cid::test::mustFail; // of this file alone

extern "C" [[gnu::visibility("default")]] int
rename(const char* from, const char* to) noexcept
{
  return mustFail() ? -1 : renameat(AT_FDCWD, from, AT_FDCWD, to);
}

extern "C" [[gnu::visibility("default")]] int
link(const char* from, const char* to) noexcept
{
  return mustFail() ? -1 : linkat(AT_FDCWD, from, AT_FDCWD, to, 0);
}

extern "C" [[gnu::visibility("default")]] int
unlink(const char* name) noexcept
{
  return mustFail() ? -1 : unlinkat(AT_FDCWD, name, 0);
}

extern "C" [[gnu::visibility("default")]] int
rmdir(const char* name) noexcept
{
  return mustFail() ? -1 : unlinkat(AT_FDCWD, name, AT_REMOVEDIR);
}

/** Nothing here outlives a power failure, and that would take most of the time. */
extern "C" [[gnu::visibility("default")]] int
fsync(int)
{
  return mustFail() ? -1 : 0;
}

extern "C" [[gnu::visibility("default")]] int
flock(int file, int operation) noexcept
{
  return mustFail() ? -1 : static_cast<int>(syscall(SYS_flock, file, operation));
}
