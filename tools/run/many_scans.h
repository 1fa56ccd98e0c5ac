/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Several scans in one call: their names, and the names of their outputs.
 */

#pragma once

#include "command_line.h"

#include <functional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

struct Settings;

/** \brief What is said about several scans; without a folder, there is one scan. */
struct ManyScans {
  std::vector<std::string> scans;
  std::string list;       ///< a file with more of them, a line each
  std::string output_dir; ///< where each has its OUTPUT
  std::string format;     ///< of these: extension without the dot
  std::string summary;    ///< a table with a row for each scan
};

/** \brief Format: that of the scan where it can be written, else the first one. */
inline constexpr const char* same_format = "same";

/** \brief An option whose value names a file or a folder of each scan. */
struct NameOption {
  std::string option;          ///< without dashes
  std::string* name = nullptr; ///< empty: it is not given
  bool may_be_shared = false;  ///< whether one may serve all scans
};

/** \brief Declare the options for several scans.
 *  \param[in] format_option says in which format outputs are; the default is in \a many
 *  \param[in] formats for it */
void
declareManyScans(ManyScans& many,
                 const std::string& format_option,
                 const std::vector<std::string>& formats,
                 CommandLine& line);

/** \brief Read a command line for one scan and its output, or, with `--output-dir`, for
 *  several.
 *  \param[in] output what the user calls it
 *  \param[in] names options that must tell several scans apart
 *  \param[out] settings its scan and its output are set, or else its scans
 *  \return whether there is work to do
 *  \throws UsageError
 *  \throws CIDException when a list of scans cannot be read */
bool
parseScans(int argc,
           const char* const* argv,
           const FileArgument& output,
           const std::vector<NameOption>& names,
           Settings& settings,
           CommandLine& line);

/** \brief Put the name of a scan in the place of each `{}`. */
void
insertName(const std::string& scan, const std::vector<NameOption>& options);

/** \brief Refuse scans that would have the same name.
 *  \param[in] named makes one of a path
 *  \throws UsageError */
void
requireDifferentNames(const std::vector<std::string>& scans,
                      const std::function<std::string(const std::string&)>& named);

/** \brief The name of a scan, also of one that cannot be read: what is wrong with it
 *  shows when it is. */
std::string
nameOfScan(const std::string& path);

/** \brief OUTPUT of a scan. */
std::string
outputOf(const ManyScans& many, const std::string& scan);

} // namespace pcl_cid::tools
