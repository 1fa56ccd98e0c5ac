/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The files of a command line that are not options.
 */

#pragma once

#include "tool_description.h"

#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief A scan that is read: a file, or a folder of a data set. */
FileArgument
scanArgument(const std::string& name);

/** \brief A file that is written. */
FileArgument
outputArgument(const std::string& name, const std::vector<std::string>& extensions);

/** \brief Refuse a file name with another extension.
 *  \param[in] name what the user calls the file: OUTPUT, --labels
 *  \throws UsageError */
void
requireExtension(const std::string& name,
                 const std::string& path,
                 const std::vector<std::string>& extensions);

/** \brief Take exactly as many files as asked for.
 *  \param[in] given their names
 *  \param[out] targets get them
 *  \param[in] list_option the option with which there may be more; empty: none
 *  \throws UsageError */
void
takeFiles(const std::vector<FileArgument>& files,
          const std::vector<std::string>& given,
          const std::vector<std::string*>& targets,
          const std::string& list_option = "");

} // namespace pcl_cid::tools
