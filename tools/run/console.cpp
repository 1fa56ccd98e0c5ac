/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a run tells its user: messages in the look of PCL's tools, and a progress bar.
 */

#include "console.h"

#include "interruption.h"

#include <algorithm>
#include <cstdio>

#include <pcl/console/print.h>

#include <unistd.h>

namespace pcl_cid::tools {

Console::Console(bool quiet)
: quiet_(quiet), has_terminal_(!quiet && isatty(STDERR_FILENO) == 1)
{
  if (quiet)
    pcl::console::setVerbosityLevel(pcl::console::L_ERROR);
}

void
Console::begin(const std::string& step)
{
  if (caughtSignal() != 0)
    throw Interrupted();
  step_ = step;
  begun_ = std::chrono::steady_clock::now();
}

double
Console::end(const std::string& result)
{
  eraseBar();
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - begun_;
  if (quiet_)
    return seconds.count();
  pcl::console::print_highlight("%s ", step_.c_str());
  pcl::console::print_info("[done, ");
  pcl::console::print_value("%.0f", 1e3 * seconds.count());
  pcl::console::print_info(" ms : ");
  pcl::console::print_value("%s", result.c_str());
  pcl::console::print_info("]\n");
  std::fflush(stdout);
  return seconds.count();
}

void
Console::remark(const std::string& sentence) const
{
  if (!quiet_)
    pcl::console::print_warn("%s\n", sentence.c_str());
}

void
Console::value(const std::string& name, const std::string& value) const
{
  if (quiet_)
    return;
  pcl::console::print_info("%s: ", name.c_str());
  pcl::console::print_value("%s\n", value.c_str());
}

ProgressCallback
Console::progress()
{
  return [this](double fraction) {
    drawBar(fraction);
    return caughtSignal() == 0;
  };
}

void
Console::drawBar(double fraction)
{
  if (!has_terminal_)
    return;
  constexpr int width = 40;
  std::string bar(width, ' ');
  std::fill_n(bar.begin(), static_cast<int>(width * fraction), '#');
  std::fprintf(
      stderr, "\r%s [%s] %3.0f %%", step_.c_str(), bar.c_str(), 100 * fraction);
  bar_drawn_ = true;
}

void
Console::eraseBar()
{
  if (bar_drawn_)
    std::fputs("\r\033[K", stderr);
  bar_drawn_ = false;
}

} // namespace pcl_cid::tools
