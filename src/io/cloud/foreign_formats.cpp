/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Files of points that are not read, and how to convert them.
 */

#include "foreign_formats.h"

#include <pcl_cid/exceptions.h>

#include <istream>
#include <string_view>

namespace pcl_cid {
namespace {

using namespace std::string_view_literals;

struct ForeignFormat {
  const char* name;
  std::string_view begin; ///< of each file
  const char* command;    ///< that converts one; the file follows it
  const char* more = "";  ///< what follows the file
};

constexpr const char* cloud_compare = "CloudCompare -SILENT -C_EXPORT_FMT PLY -O";

constexpr ForeignFormat foreign_formats[] = {
    {"a LAS or LAZ", "LASF"sv, cloud_compare, " -SAVE_CLOUDS"},
    {"an E57", "ASTM-E57"sv, cloud_compare, " -SAVE_CLOUDS"},
    {"an NPZ or another ZIP", "PK\x03\x04"sv, "unzip"}};

} // namespace

void
refuseForeignFormat(std::istream& stream, const std::string& path)
{
  std::string begin(8, '\0');
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  for (const ForeignFormat& format : foreign_formats)
    if (begin.compare(0, format.begin.size(), format.begin) == 0)
      throw CIDException(path + ": is " + format.name +
                         " file, which is not read; convert it first: " +
                         format.command + " '" + path + "'" + format.more);
}

} // namespace pcl_cid
