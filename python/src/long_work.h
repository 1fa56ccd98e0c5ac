/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Long work: without the GIL, with progress, and open to Ctrl-C.
 */

#pragma once

#include "errors.h"
#include "gil.h"

#include <pcl_cid/core/execution.h>

#include <utility>

namespace pcl_cid::python {

/** \brief One call from Python that may take long. It hears of Ctrl-C whether or not
 *  somebody asks for progress: where the main thread waits in C++, nobody else would
 *  run Python's signal handlers. */
class LongWork {
public:
  /** \param[in] progress as it was given: None, True, or a callable
   *  \throws TypeError for anything else */
  explicit LongWork(const py::object& progress, unsigned int threads = 0);
  ~LongWork();
  LongWork(const LongWork&) = delete;
  LongWork&
  operator=(const LongWork&) = delete;

  /** \brief Call \a work with ExecutionOptions and without the GIL. */
  template <typename Work>
  auto
  run(Work&& work)
  {
    const ExecutionOptions execution{
        threads_, [this](double fraction) { return goesOn(fraction); }};
    const GilReleased released;
    return std::forward<Work>(work)(execution);
  }

private:
  bool
  goesOn(double fraction) const;

  py::object progress_;
  py::object bar_; ///< to be closed; None where there is none of ours
  unsigned int threads_;
};

} // namespace pcl_cid::python
