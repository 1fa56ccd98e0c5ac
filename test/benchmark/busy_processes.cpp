/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Other work of the machine, as on a robot.
 */

#include "busy_processes.h"

#include <cstdint>
#include <stdexcept>

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pcl_cid::benchmarks {

BusyProcesses::BusyProcesses(std::size_t number)
{
  ids_.reserve(number);
  while (ids_.size() < number)
    start();
}

BusyProcesses::~BusyProcesses()
{
  stopAll();
}

void
BusyProcesses::start()
{
  const pid_t id = fork();
  if (id < 0) {
    stopAll(); // no destructor runs after a constructor that throws
    throw std::runtime_error("cannot start a busy process");
  }
  if (id > 0) {
    ids_.push_back(id);
    return;
  }
  // Whoever stops the measurement stops these, too.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (volatile std::uint64_t turns = 0;;)
    turns = turns + 1;
}

void
BusyProcesses::stopAll()
{
  for (const pid_t id : ids_) {
    kill(id, SIGKILL);
    waitpid(id, nullptr, 0);
  }
}

} // namespace pcl_cid::benchmarks
