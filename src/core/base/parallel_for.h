/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parallel loops over ranges. No other file of the library starts a thread.
 */

#pragma once

#include "progress.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <vector>

namespace pcl_cid {

/** \brief The number of threads that a setting means (0: one for each processor that
 *  this process may run on). */
int
threadCount(unsigned int setting);

/** \brief A pool of threads that sleep until there is work to share.
 *
 *  Nobody waits for a helper to start: on a busy machine it may come after the work is
 *  done, or never. Nobody busy-waits. */
class Helpers {
public:
  /** \brief Starts a thread that runs a function; may throw. */
  using Starter = std::function<void(std::function<void()>)>;

  /** \brief Helpers are started on demand and never end, so this object must outlive
   *  the process. */
  explicit Helpers(Starter start);

  /** \brief The pool of this process; a forked child has its own. */
  static Helpers&
  ofProcess();

  /** \brief Do \a work on this thread and on up to \a helpers others.
   *
   *  Returns when this thread and every helper that has begun are done. May be called
   *  from any thread, and from within \a work.
   *  \param[in] helpers the most that may join; fewer do when no more can be started
   *  \param[in] work returns when nothing is left to begin; must not throw */
  void
  share(std::size_t helpers, const std::function<void()>& work);

private:
  struct Job {
    const std::function<void()>& work;
    std::size_t wanted;             ///< helpers that may still join
    std::size_t inside = 0;         ///< helpers at work
    std::condition_variable left{}; ///< signaled when the last one leaves
  };

  void
  startMissing();

  void
  close(const Job& job);

  void
  help();

  Starter start_;
  std::mutex mutex_; ///< of everything below, jobs included
  std::condition_variable asked_;
  std::vector<Job*> jobs_; ///< those that want helpers; each belongs to its caller
  std::size_t most_;       ///< never more helpers than this
  std::size_t started_ = 0;
  std::size_t busy_ = 0;
};

/** \brief The share of a longer job that one loop makes up, in fractions of the job. */
struct ProgressSpan {
  double begin = 0.0;
  double end = 0.0;
};

/** \brief Call \a body(begin, end) for consecutive ranges that make up [0, count).
 *
 *  Ranges are handed out as threads come free, so a body must write only to what its
 *  range owns; then the result is the same for any number of threads. Serial when one
 *  range covers everything. A body may call this itself.
 *  \param[in] count number of items
 *  \param[in] grain items in a range, at least 1
 *  \param[in] threads as from threadCount()
 *  \param[in,out] progress told of the ranges of its own thread; ends the loop when it
 *  was cancelled
 *  \param[in] span the share of the job that this loop is
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
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::exception_ptr failure;
  const auto work = [&] {
    while (!failed && !progress.cancelled()) {
      const std::size_t range = next++;
      if (range >= ranges)
        break;
      try {
        const std::size_t begin = range * grain;
        body(begin, std::min(begin + grain, count));
        progress.report(span.begin + (span.end - span.begin) *
                                         static_cast<double>(range + 1) /
                                         static_cast<double>(ranges));
      }
      catch (...) {
        if (!failed.exchange(true))
          failure = std::current_exception();
      }
    }
  };
  const std::size_t team = std::min(static_cast<std::size_t>(threads), ranges);
  if (team > 1)
    Helpers::ofProcess().share(team - 1, std::ref(work));
  else
    work();
  if (failure)
    std::rethrow_exception(failure);
  progress.check(span.end);
}

/** \brief Call \a work(i) for each i below \a count: for items that take long. As
 *  parallelFor() in ranges of one.
 *  \param[in] work callable as void(std::size_t) */
template <typename Work>
void
parallelForEach(std::size_t count,
                int threads,
                Progress& progress,
                ProgressSpan span,
                const Work& work)
{
  parallelFor(
      count, 1, threads, progress, span, [&](std::size_t i, std::size_t) { work(i); });
}

} // namespace pcl_cid
