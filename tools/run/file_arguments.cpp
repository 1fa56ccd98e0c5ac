/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The files of a command line that are not options.
 */

#include "file_arguments.h"

#include "command_line.h"
#include "words.h"

#include <pcl_cid/io/output_files.h>
#include <pcl_cid/io/scan_source.h>

#include <algorithm>

#include <boost/algorithm/string/join.hpp>

namespace pcl_cid::tools {
namespace {

/** "INPUT and OUTPUT are needed, 2 file names". */
std::string
needOf(const std::vector<FileArgument>& files)
{
  std::vector<std::string> names;
  for (const FileArgument& file : files)
    names.push_back(file.name);
  if (names.empty())
    return "No files are needed";
  const bool is_one = names.size() == 1;
  return boost::algorithm::join(names, " and ") + (is_one ? " is" : " are") +
         " needed, " + std::to_string(names.size()) + " file name" +
         (is_one ? "" : "s");
}

} // namespace

FileArgument
scanArgument(const std::string& name)
{
  return {name, scanExtensions()};
}

FileArgument
outputArgument(const std::string& name, const std::vector<std::string>& extensions)
{
  return {name, extensions, true};
}

void
requireExtension(const std::string& name,
                 const std::string& path,
                 const std::vector<std::string>& extensions)
{
  if (std::find(extensions.begin(), extensions.end(), extensionOf(path)) ==
      extensions.end())
    throw UsageError(name + " is '" + path + "'; its name must end in " +
                     alternatives(extensions));
}

void
takeFiles(const std::vector<FileArgument>& files,
          const std::vector<std::string>& given,
          const std::vector<std::string*>& targets,
          const std::string& list_option)
{
  const bool is_list = given.size() > files.size() && !list_option.empty();
  if (given.size() != files.size())
    throw UsageError(needOf(files) + "; given: " + std::to_string(given.size()) +
                     (is_list ? "; several scans need --" + list_option : ""));
  for (std::size_t i = 0; i < files.size(); ++i) {
    const bool is_stream = files[i].may_be_stream && given[i] == standard_output;
    if (files[i].is_checked && !is_stream)
      requireExtension(files[i].name, given[i], files[i].extensions);
    *targets[i] = given[i];
  }
}

} // namespace pcl_cid::tools
