/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The interpreter's lock, let go of and taken again.
 */

#pragma once

#include <pybind11/pybind11.h>

namespace pcl_cid::python {

/** \brief No lock for a scope, so that other threads of Python run.
 *
 *  A daemon thread may be within such a scope when the process ends, and Python takes
 *  the interpreter down under its feet. So the end waits until every such scope is left
 *  (see letTheEndWait()), and a thread that leaves one stays there until the process is
 *  gone.
 */
class GilReleased {
public:
  GilReleased();
  ~GilReleased();
  GilReleased(const GilReleased&) = delete;
  GilReleased&
  operator=(const GilReleased&) = delete;

private:
  PyThreadState* state_;
};

/** \brief True in a thread that has to leave its work, as the process ends. */
bool
mustLeave();

/** \brief Have the end of the interpreter wait for threads that are at work without the
 *  lock. They hear of it through mustLeave().
 */
void
letTheEndWait();

} // namespace pcl_cid::python
