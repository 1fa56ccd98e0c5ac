/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The user, or the system, asks a run to end.
 */

#pragma once

#include <stdexcept>
#include <string>

namespace pcl_cid::tools {

/** \brief The run was asked to end; the message says what is left of it. */
class Interrupted : public std::runtime_error {
public:
  explicit Interrupted(const std::string& left = "nothing was written")
  : std::runtime_error(left)
  {
  }
};

/** \brief Let the first signal end the run in order, so that nothing is left behind; a
 *  second one kills it. A broken pipe or a full disk is a failed write, not the end of
 *  the process. */
void
catchSignals();

/** \brief The signal that asked the run to end; 0 when none did. */
int
caughtSignal();

} // namespace pcl_cid::tools
