/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How long work runs: threads, progress, cancellation.
 */

#pragma once

#include <functional>

namespace pcl_cid {

/** \brief Called during long work with the fraction done, 0 to 1, never falling;
 *  returns false to cancel. Always called from the thread that started the work, a few
 *  times to about twenty times a second. An exception it throws ends the work and
 *  reaches the caller. */
using ProgressCallback = std::function<bool(double fraction)>;

/** \brief How to run; never changes a result. */
struct ExecutionOptions {
  /** Number of threads; 0 means one for each processor that the process may run on.
   *  More than the setting allows (1024) count as that many. */
  unsigned int threads = 0;
  /** Progress and cancellation; empty means none. */
  ProgressCallback progress;
};

/** \brief How to run one step of a work: the callback of the whole hears fractions from
 *  \a begin to \a end. */
inline ExecutionOptions
partOf(const ExecutionOptions& execution, double begin, double end)
{
  ExecutionOptions part{execution.threads, {}};
  if (execution.progress)
    part.progress = [whole = execution.progress, begin, end](double fraction) {
      return whole(begin + (end - begin) * fraction);
    };
  return part;
}

} // namespace pcl_cid
