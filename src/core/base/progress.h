/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Rate-limited progress reports, and the cancellation they may ask for.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

namespace pcl_cid {

/** \brief Turns the steps of one piece of work into calls of a ProgressCallback.
 *
 *  Only the thread that started the work reports; any thread may ask whether the work
 *  was cancelled. */
class Progress {
public:
  explicit Progress(ProgressCallback callback) : callback_(std::move(callback)) {}

  /** \brief Tell the callback, unless it was told a moment ago or this is another
   *  thread.
   *  \param[in] fraction share of the work done, 0 to 1 */
  void
  report(double fraction)
  {
    if (!callback_ || cancelled_ || std::this_thread::get_id() != reporter_)
      return;
    const auto now = Clock::now();
    if (told_once_ && now - told_ < std::chrono::milliseconds(50) && fraction < 1.0)
      return;
    told_once_ = true;
    told_ = now;
    highest_ = std::max(highest_, std::min(fraction, 1.0));
    if (!callback_(highest_))
      cancelled_ = true;
  }

  /** \brief From inside a long step, on any thread: report that the work goes on, and
   *  abort it when it was cancelled.
   *  \throws CIDCancelled */
  void
  poll()
  {
    if (std::this_thread::get_id() == reporter_)
      report(highest_);
    if (cancelled_)
      throw CIDCancelled();
  }

  bool
  cancelled() const
  {
    return cancelled_;
  }

  /** \brief Report, and abort the work when it was cancelled.
   *  \throws CIDCancelled */
  void
  check(double fraction)
  {
    report(fraction);
    if (cancelled_)
      throw CIDCancelled();
  }

private:
  using Clock = std::chrono::steady_clock;

  ProgressCallback callback_;
  std::thread::id reporter_ = std::this_thread::get_id();
  std::atomic<bool> cancelled_{false};
  bool told_once_ = false;
  Clock::time_point told_;
  double highest_ = 0.0;
};

} // namespace pcl_cid
