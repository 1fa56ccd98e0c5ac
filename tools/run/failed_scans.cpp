/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scans of several that fail: the others are done nevertheless.
 */

#include "failed_scans.h"

#include "interruption.h"
#include "run.h"

#include <pcl_cid/exceptions.h>

#include <cstdio>
#include <exception>

namespace pcl_cid::tools {

std::string
aboutScan(const std::string& name, const std::string& sentence)
{
  const std::string begin = name + ": ";
  return sentence.rfind(begin, 0) == 0 ? sentence : begin + sentence;
}

bool
attempt(const char* tool,
        const std::string& name,
        const std::function<void()>& work,
        std::vector<FailedScan>& failed)
{
  try {
    work();
    return true;
  }
  catch (const Interrupted&) {
    throw;
  }
  catch (const CIDCancelled&) {
    throw Interrupted();
  }
  catch (const std::exception& error) {
    const char* const message = messageOf(error);
    std::fflush(stdout);
    std::fprintf(stderr, "%s: %s\n", tool, aboutScan(name, message).c_str());
    failed.push_back({name, message});
    return false;
  }
}

void
requireNoFailure(const std::vector<FailedScan>& failed,
                 std::size_t scans,
                 const std::string& done,
                 FailureList list)
{
  if (failed.empty())
    return;
  std::string text;
  for (const FailedScan& scan : failed)
    text += list == FailureList::reasons ? "\n  " + aboutScan(scan.name, scan.error)
                                         : (text.empty() ? " " : ", ") + scan.name;
  throw CIDException(std::to_string(failed.size()) + " of " + std::to_string(scans) +
                     (scans == 1 ? " scan" : " scans") + " could not be " + done + ":" +
                     text);
}

} // namespace pcl_cid::tools
