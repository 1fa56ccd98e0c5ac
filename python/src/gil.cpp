/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The interpreter's lock, let go of and taken again.
 */

#include "gil.h"

#include <atomic>
#include <chrono>
#include <thread>

#include <unistd.h>

namespace pcl_cid::python {
namespace {

namespace py = pybind11;

std::atomic<int> at_work{0}; ///< scopes without the lock
std::atomic<std::thread::id>
    ending{}; ///< the thread that ends the process, once it does

[[noreturn]] void
stayUntilTheEnd()
{
  for (;;)
    pause();
}

void
waitForWork()
{
  ending = std::this_thread::get_id();
  const py::gil_scoped_release released;
  while (at_work > 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

} // namespace

bool
mustLeave()
{
  const auto thread = ending.load();
  return thread != std::thread::id() && thread != std::this_thread::get_id();
}

void
letTheEndWait()
{
  py::module_::import("atexit").attr("register")(py::cpp_function(waitForWork));
  // Of all threads a forked child has only the one that forked, which holds the lock.
  py::module_::import("os").attr("register_at_fork")(
      py::arg("after_in_child") = py::cpp_function([] { at_work = 0; }));
}

// The count goes up before mustLeave() is asked, and the end asks for the count after
// mustLeave() has turned true: one of them sees the other.
GilReleased::GilReleased()
{
  ++at_work;
  state_ = PyEval_SaveThread();
  if (mustLeave()) {
    --at_work;
    stayUntilTheEnd();
  }
}

GilReleased::~GilReleased()
{
  if (mustLeave()) {
    --at_work;
    stayUntilTheEnd();
  }
  PyEval_RestoreThread(state_); // the end, which lets go of the lock, waits for this
  --at_work;
}

} // namespace pcl_cid::python
