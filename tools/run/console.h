/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a run tells its user: messages in the look of PCL's tools, and a progress bar.
 */

#pragma once

#include <pcl_cid/core/execution.h>

#include <chrono>
#include <string>

namespace pcl_cid::tools {

/** \brief Let no output file take the place of a standard stream that is closed: what
 *  is printed would end up in it. */
void
occupyClosedStreams();

/** \brief Make sure that the standard output has reached its reader.
 *  \throws CIDException when some of it was lost */
void
requirePrinted();

/** \brief Results go to the standard output, the progress bar to a terminal. */
class Console {
public:
  explicit Console(bool quiet);
  ~Console();
  // The callback of progress() refers to it.
  Console(const Console&) = delete;
  Console&
  operator=(const Console&) = delete;

  /** \brief Tell nothing from now on but remarks, which begin with the name of the
   *  scan, and how far a step is: of several scans, each has one line. */
  void
  beBriefOn(const std::string& scan);

  /** \brief Begin a step of the run.
   *  \throws Interrupted */
  void
  begin(const std::string& step);

  /** \brief End it: "> Loading room.pcd [done, 12 ms : 3400 points]".
   *  \param[in] result "3400 points"
   *  \return how many seconds it took */
  double
  end(const std::string& result);

  /** \brief Something that the user should know about the input, to the standard
   *  error. */
  void
  remark(const std::string& sentence) const;

  /** \brief "Coverage: 0.05 metres". */
  void
  value(const std::string& name, const std::string& value) const;

  /** \brief For the library: draws the bar, and cancels when the run was asked to
   *  end. */
  ProgressCallback
  progress();

private:
  void
  drawBar(double fraction);

  void
  eraseBar();

  bool quiet_;
  std::string brief_on_; ///< the scan; empty: all is told
  bool has_terminal_;
  bool bar_drawn_ = false;
  std::string step_;
  std::chrono::steady_clock::time_point begun_;
};

} // namespace pcl_cid::tools
