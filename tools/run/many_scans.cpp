/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Several scans in one call: their names, and the names of their outputs.
 */

#include "many_scans.h"

#include "common_settings.h"
#include "words.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/scan_source.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include <boost/algorithm/string/replace.hpp>

namespace pcl_cid::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* place_of_name = "{}";

void
readLines(std::istream& stream, std::vector<std::string>& lines)
{
  for (std::string line; std::getline(stream, line);) {
    while (!line.empty() && line.back() == '\r')
      line.pop_back();
    if (!line.empty())
      lines.push_back(line);
  }
}

/** Add the scans of a list, which `-` reads from the standard input. */
void
readList(const std::string& list, std::vector<std::string>& scans)
{
  if (list == "-")
    return readLines(std::cin, scans);
  std::ifstream stream(list);
  readLines(stream, scans);
  if (!stream.eof())
    throw CIDException(list + ": cannot be read: " + std::strerror(errno));
}

/** The extension of a scan, without its dot, where clouds can be written so. */
std::string
formatLike(const std::string& scan)
{
  const CloudFormat* const format = findCloudFormat(scan);
  const std::vector<std::string> extensions = format != nullptr && format->write
                                                  ? format->extensions
                                                  : writableCloudExtensions();
  return extensions.front().substr(1);
}

/** No option may mean the same file for all scans. */
void
requireNamesOfEach(const std::vector<NameOption>& options)
{
  for (const NameOption& option : options)
    if (!option.name->empty() && !option.may_be_shared &&
        option.name->find(place_of_name) == std::string::npos)
      throw UsageError("--" + option.option + " is '" + *option.name +
                       "' for each scan; with --output-dir it must hold {}, which "
                       "stands for the name of the scan");
}

/** The standard input has none. */
void
requireNames(const std::vector<std::string>& scans)
{
  if (std::count(scans.begin(), scans.end(), "-") > 0)
    throw UsageError(
        "SCAN is '-', the standard input, which has no name that an output "
        "could have; give it without --output-dir");
}

} // namespace

void
declareManyScans(ManyScans& many,
                 const std::string& format_option,
                 const std::vector<std::string>& formats,
                 CommandLine& line)
{
  line.group("Several scans");
  line.text("output-dir",
            "DIR",
            many.output_dir,
            "do each SCAN as a call of its own would, with its OUTPUT in this folder, "
            "made when missing, under the scan's name; in names of files that other "
            "options take, {} stands for this name: --report 'DIR/{}.json'. A scan "
            "that fails does not stop the others");
  line.word(format_option,
            "F",
            formats,
            many.format,
            "format of these outputs: " + alternatives(formats));
  line.file("summary",
            "FILE",
            {".csv", ".json"},
            many.summary,
            "write a row for each scan: how it ended, its size, seconds");
  line.text("scans-from",
            "FILE",
            many.list,
            "more scans, a path on each line; - is the standard input");
  for (const char* const option : {format_option.c_str(), "summary", "scans-from"})
    line.require(option, {"output-dir"});
}

bool
parseScans(int argc,
           const char* const* argv,
           const FileArgument& output,
           const std::vector<NameOption>& names,
           Settings& settings,
           CommandLine& line)
{
  ManyScans& many = settings.many;
  if (!line.parseEither(argc,
                        argv,
                        {scanArgument("INPUT"), output},
                        {&settings.input, &settings.output},
                        "output-dir",
                        many.scans))
    return false;
  if (many.output_dir.empty())
    return true;
  requireNamesOfEach(names);
  if (!many.list.empty())
    readList(many.list, many.scans);
  if (many.scans.empty())
    throw UsageError(
        "SCAN is needed with --output-dir, at least 1 file name; given: 0");
  requireNames(many.scans);
  requireDifferentNames(many.scans, nameOfScan);
  return true;
}

void
requireDifferentNames(const std::vector<std::string>& scans,
                      const std::function<std::string(const std::string&)>& named)
{
  std::map<std::string, std::string> known;
  for (const std::string& scan : scans) {
    const auto [other, is_new] = known.emplace(named(scan), scan);
    if (!is_new)
      throw UsageError(
          other->second + " and " + scan + " have the same name, '" + other->first +
          "', and would have the same outputs; names of scans must differ");
  }
}

void
insertName(const std::string& scan, const std::vector<NameOption>& options)
{
  for (const NameOption& option : options)
    boost::algorithm::replace_all(*option.name, place_of_name, nameOfScan(scan));
}

std::string
nameOfScan(const std::string& path)
{
  try {
    return scanName(path);
  }
  catch (const CIDException&) {
    return fs::path(path).stem().string();
  }
}

std::string
outputOf(const ManyScans& many, const std::string& scan)
{
  const std::string format =
      many.format == same_format ? formatLike(scan) : many.format;
  return (fs::path(many.output_dir) / (nameOfScan(scan) + "." + format)).string();
}

} // namespace pcl_cid::tools
