/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a run tells its user: messages in the look of PCL's tools, and a progress bar.
 */

#include "console.h"

#include "failed_scans.h"
#include "interruption.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>

#include <pcl/console/print.h>

#include <fcntl.h>
#include <unistd.h>

namespace pcl_cid::tools {

void
occupyClosedStreams()
{
  // Opened the wrong way round, they fail as closed ones do.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0)
      open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void
requirePrinted()
{
  errno = 0;
  std::cout.flush();
  const bool is_flushed = std::fflush(stdout) == 0;
  if (is_flushed && std::cout && std::ferror(stdout) == 0)
    return;
  throw CIDException("the standard output could not be written in full" +
                     (errno == 0 ? "" : std::string(": ") + std::strerror(errno)));
}

Console::Console(bool quiet)
: quiet_(quiet), has_terminal_(!quiet && isatty(STDERR_FILENO) == 1)
{
  if (quiet)
    pcl::console::setVerbosityLevel(pcl::console::L_ERROR);
}

Console::~Console()
{
  eraseBar();
}

void
Console::beBriefOn(const std::string& scan)
{
  brief_on_ = scan;
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
  if (quiet_ || !brief_on_.empty())
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
  if (quiet_)
    return;
  const std::string text =
      brief_on_.empty() ? sentence : aboutScan(brief_on_, sentence);
  pcl::console::print_warn("%s\n", text.c_str());
}

void
Console::value(const std::string& name, const std::string& value) const
{
  if (quiet_ || !brief_on_.empty())
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
