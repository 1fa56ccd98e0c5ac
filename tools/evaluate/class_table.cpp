/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the class numbers of scans mean, and which classes are scored.
 */

#include "class_table.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <charconv>
#include <fstream>

namespace pcl_cid::tools {
namespace {

constexpr const char* blanks = " \t\r";

/** The text without the blanks at its ends. */
std::string
trimmed(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string::npos)
    return "";
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

/** A class from "number name". */
SemanticClass
parseClass(const std::string& text, const std::string& place)
{
  SemanticClass result{0, ""};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, result.number);
  result.name = trimmed(std::string(rest, end));
  const bool is_apart =
      rest != end && std::string(blanks).find(*rest) != std::string::npos;
  if (error != std::errc() || result.number == 0 || !is_apart || result.name.empty())
    throw CIDException(place + ": '" + text +
                       "' is not a number above 0 and the name of a class");
  return result;
}

SemanticClasses
readClasses(const std::string& path)
{
  std::ifstream stream(path);
  if (!stream)
    throw CIDException("--classes is '" + path +
                       "'; it must be s3dis, scannet or a file that can be read");
  SemanticClasses classes;
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    const std::string text = trimmed(line.substr(0, line.find('#')));
    if (text.empty())
      continue;
    const std::string place = path + ", line " + std::to_string(number);
    const SemanticClass read = parseClass(text, place);
    for (const SemanticClass& known : classes)
      if (known.number == read.number || known.name == read.name)
        throw CIDException(place + ": class " + std::to_string(read.number) + " '" +
                           read.name + "' repeats the number or the name of " +
                           std::to_string(known.number) + " '" + known.name + "'");
    classes.push_back(read);
  }
  if (stream.bad() || classes.empty())
    throw CIDException(path + ": holds no class; a line for each is needed, with its "
                              "number and name");
  std::sort(classes.begin(),
            classes.end(),
            [](const SemanticClass& a, const SemanticClass& b) {
              return a.number < b.number;
            });
  return classes;
}

} // namespace

ClassTable
classTable(const std::string& source)
{
  if (source == "s3dis")
    return {source, s3disClasses(), s3disClasses()};
  if (source == "scannet")
    return {source, nyu40Classes(), scannetBenchmarkClasses()};
  const SemanticClasses classes = readClasses(source);
  return {source, classes, classes};
}

ClassTable
oneClass()
{
  const SemanticClasses classes{{1, "instance"}};
  return {"none", classes, classes};
}

} // namespace pcl_cid::tools
