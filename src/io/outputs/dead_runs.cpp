/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What runs that were killed have left in a folder.
 */

#include "dead_runs.h"

#include "commit_record.h"
#include "hidden_files.h"

#include <filesystem>

#include <fcntl.h>
#include <unistd.h>

namespace pcl_cid {
namespace {

namespace fs = std::filesystem;

/** The base in the first folder of a run, which its other folders refer to. */
std::string
firstBase(const OpenFile& lock, const std::string& base)
{
  const std::string text = lock.readAll();
  if (text.empty() || text.back() != '\n')
    return base; // it died before it could begin a commit
  const fs::path folder = fs::path(base).parent_path();
  return (folder / text.substr(0, text.size() - 1)).lexically_normal().string();
}

void
removePartials(const std::string& base)
{
  for (const std::string& file : filesIn(fs::path(base).parent_path().string()))
    if (file.rfind(base + "-", 0) == 0 && fs::path(file).extension() == ".partial")
      unlink(file.c_str());
}

/** Bring a run to its end, if it is dead: then nobody has locked its file. */
void
endIfDead(const std::string& base)
{
  const std::string name = base + ".run";
  const OpenFile lock(name, O_RDWR);
  if (!lock.isOurs() || lock.lock() != 0 || !lock.hasName(name))
    return;
  const std::string first = firstBase(lock, base);
  if (first != base && isHidden(first)) {
    endIfDead(first);
    if (isThere(first + ".run"))
      return; // another run is at it
  }
  endCommit(base);
  removePartials(base);
  unlink(name.c_str());
}

} // namespace

void
endDeadRuns(const std::string& folder)
{
  for (const std::string& file : filesIn(folder))
    if (isHidden(file) && fs::path(file).extension() == ".run")
      endIfDead(fs::path(file).replace_extension().string());
}

} // namespace pcl_cid
