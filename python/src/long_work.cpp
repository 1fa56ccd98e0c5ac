/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Long work: without the GIL, with progress, and open to Ctrl-C.
 */

#include "long_work.h"

namespace pcl_cid::python {

LongWork::LongWork(const py::object& progress, unsigned int threads)
: progress_(progress), bar_(py::none()), threads_(threads)
{
  if (progress.is(py::bool_(false)))
    progress_ = py::none();
  else if (progress.is(py::bool_(true))) {
    bar_ = py::module_::import("pcl_cid._progress").attr("open_bar")();
    progress_ = bar_;
  }
  else if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
    throw py::type_error("progress is " + shown(progress) +
                         "; it must be True, None or a callable of the fraction done");
}

LongWork::~LongWork()
{
  if (bar_.is_none())
    return;
  const py::error_scope kept; // of the work, if it failed
  try {
    bar_.attr("close")();
  }
  catch (py::error_already_set& error) {
    error.discard_as_unraisable("closing the bar of progress");
  }
}

bool
LongWork::goesOn(double fraction) const
{
  if (mustLeave())
    return false;
  const py::gil_scoped_acquire acquired;
  if (PyErr_CheckSignals() != 0)
    throw py::error_already_set();
  if (progress_.is_none())
    return true;
  return !progress_(fraction).is(py::bool_(false));
}

} // namespace pcl_cid::python
