/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Other work of the machine, as on a robot.
 */

#pragma once

#include <cstddef>
#include <vector>

#include <sys/types.h>

namespace pcl_cid::benchmarks {

/** \brief Processes that never wait, for as long as this lives. */
class BusyProcesses {
public:
  /** \pre the process has one thread
   *  \throws std::runtime_error when one cannot be started */
  explicit BusyProcesses(std::size_t number);

  ~BusyProcesses();

  BusyProcesses(const BusyProcesses&) = delete;
  BusyProcesses&
  operator=(const BusyProcesses&) = delete;

private:
  void
  start();

  void
  stopAll();

  std::vector<pid_t> ids_;
};

} // namespace pcl_cid::benchmarks
