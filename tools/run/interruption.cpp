/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The user, or the system, asks a run to end.
 */

#include "interruption.h"

#include <csignal>
#include <initializer_list>

namespace pcl_cid::tools {
namespace {

volatile std::sig_atomic_t caught_signal = 0;

extern "C" void
catchSignal(int signal)
{
  caught_signal = signal;
}

} // namespace

void
catchSignals()
{
  struct sigaction action = {};
  action.sa_handler = catchSignal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    sigaction(signal, &action, nullptr);
  for (const int signal : {SIGPIPE, SIGXFSZ})
    std::signal(signal, SIG_IGN);
}

int
caughtSignal()
{
  return caught_signal;
}

} // namespace pcl_cid::tools
