/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scans of several that fail: the others are done nevertheless.
 */

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief A scan of several that failed. */
struct FailedScan {
  std::string name;
  std::string error;
};

/** \brief A sentence about a scan, which begins with its name: once, where it does so
 *  by itself. */
std::string
aboutScan(const std::string& name, const std::string& sentence);

/** \brief Do the work of one scan of several. What it throws is told to the user and
 *  noted down, want of memory, too; only an interruption is thrown on.
 *  \param[in,out] failed one more when the work failed
 *  \return whether it was done
 *  \throws Interrupted */
bool
attempt(const char* tool,
        const std::string& name,
        const std::function<void()>& work,
        std::vector<FailedScan>& failed);

/** \brief What the last message says about scans that failed. */
enum class FailureList {
  names,  ///< on one line: "a, c"
  reasons ///< a line for each, why it failed
};

/** \brief The end of a run of several scans: an error where some failed.
 *  \param[in] scans how many there were
 *  \param[in] done "scored"
 *  \throws CIDException */
void
requireNoFailure(const std::vector<FailedScan>& failed,
                 std::size_t scans,
                 const std::string& done,
                 FailureList list);

} // namespace pcl_cid::tools
