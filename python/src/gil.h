/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The interpreter's lock, let go of and taken again.
 */

#pragma once

#include <optional>

#include <pybind11/pybind11.h>

namespace pcl_cid::python {

/** \brief No lock for a scope, so that other threads of Python run.
 *
 *  Where the interpreter has ended when a daemon thread wants the lock back, CPython up
 *  to 3.13 unwinds that thread, through code of ours that nothing may leave like that:
 *  the process would abort. Here the thread waits for the end of the process instead.
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

/** \brief The lock for a scope within one without; waits as that does. */
class GilAcquired {
public:
  GilAcquired();

private:
  std::optional<pybind11::gil_scoped_acquire> acquired_;
};

} // namespace pcl_cid::python
