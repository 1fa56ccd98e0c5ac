/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Loops over ranges on several threads; the only file that names OpenMP.
 */

#pragma once

#include "progress.h"

#include <omp.h>

#include <algorithm>
#include <cstddef>
#include <exception>

namespace pcl_cid {

/** \brief The number of threads that a setting stands for (0: all that OpenMP
 *  offers). */
inline int
threadCount(unsigned int setting)
{
  return setting == 0 ? omp_get_max_threads() : static_cast<int>(setting);
}

/** \brief Part of a longer work that one loop makes up, in fractions of that work. */
struct ProgressSpan {
  double begin = 0.0;
  double end = 0.0;
};

/** \brief Call \a body(begin, end) for consecutive ranges that make up [0, count).
 *
 *  Ranges are handed out as threads come free, so a body must write only to what its
 *  range owns; then the result is the same for any number of threads. Serial when one
 *  range covers everything.
 *  \param[in] count number of items
 *  \param[in] grain items in a range, at least 1
 *  \param[in] threads as from threadCount()
 *  \param[in,out] progress polled by the calling thread between its ranges
 *  \param[in] span the fractions that this loop stands for
 *  \param[in] body callable as void(std::size_t begin, std::size_t end)
 *  \throws CIDCancelled, and whatever \a body or the callback throws (the first of
 *  them) */
template <typename Body>
void
parallelFor(std::size_t count,
            std::size_t grain,
            int threads,
            Progress& progress,
            ProgressSpan span,
            const Body& body)
{
  const std::size_t ranges = (count + grain - 1) / grain;
  const int team = static_cast<int>(
      std::min<std::size_t>(static_cast<std::size_t>(threads), ranges));
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::exception_ptr failure;

#pragma omp parallel num_threads(std::max(team, 1)) if (team > 1)
  {
    const bool reporter = omp_get_thread_num() == 0;
    while (!failed && !progress.cancelled()) {
      const std::size_t range = next++;
      if (range >= ranges)
        break;
      try {
        const std::size_t begin = range * grain;
        body(begin, std::min(begin + grain, count));
        if (reporter)
          progress.report(span.begin + (span.end - span.begin) *
                                           static_cast<double>(range + 1) /
                                           static_cast<double>(ranges));
      }
      catch (...) {
#pragma omp critical(pcl_cid_parallel_for)
        if (!failed.exchange(true))
          failure = std::current_exception();
      }
    }
  }
  if (failure)
    std::rethrow_exception(failure);
  progress.check(span.end);
}

} // namespace pcl_cid
