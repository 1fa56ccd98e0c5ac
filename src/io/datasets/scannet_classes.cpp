/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * ScanNet's table of what its annotators call things.
 */

#include "scannet_classes.h"

#include "base/sentence.h"
#include "text/file_reading.h"
#include "text/numbers.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/class_names.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace pcl_cid {
namespace {

std::vector<std::string>
cellsOf(std::string_view line)
{
  std::vector<std::string> cells;
  for (std::size_t tab = line.find('\t'); tab != std::string_view::npos;
       tab = line.find('\t')) {
    cells.emplace_back(line.substr(0, tab));
    line.remove_prefix(tab + 1);
  }
  cells.emplace_back(line);
  return cells;
}

/** Reads the table line by line; the first one names the columns. */
class ClassTableReading {
public:
  explicit ClassTableReading(const std::string& path) : path_(path) {}

  void
  take(std::string_view line, std::size_t number)
  {
    const std::vector<std::string> cells = cellsOf(line);
    if (!header_taken_) {
      category_ = columnOf(cells, "raw_category");
      class_ = columnOf(cells, "nyu40id");
      header_taken_ = true;
      return;
    }
    if (cells.size() <= std::max(category_, class_))
      fail(number, sentence("has only ", countOf(cells.size(), "column")));
    classes_[cells[category_]] = classOf(cells[class_], number);
  }

  const std::map<std::string, std::uint32_t>&
  classes() const
  {
    if (classes_.empty())
      throw CIDException(path_ + ": holds no class; at least 1 is needed");
    return classes_;
  }

private:
  [[noreturn]] void
  fail(std::size_t number, const std::string& reason) const
  {
    throw CIDException(sentence(path_, ": line ", number, ": ", reason));
  }

  std::size_t
  columnOf(const std::vector<std::string>& cells, const std::string& name) const
  {
    const auto found = std::find(cells.begin(), cells.end(), name);
    if (found == cells.end())
      throw CIDException(path_ + ": has no column '" + name +
                         "'; its columns, separated by tabs, must contain "
                         "raw_category and nyu40id");
    return static_cast<std::size_t>(found - cells.begin());
  }

  std::uint32_t
  classOf(const std::string& text, std::size_t number) const
  {
    const auto value = parseNumber<std::uint32_t>(text);
    if (!value || !className(nyu40Classes(), *value))
      fail(number,
           "nyu40id is '" + text + "'; it must be a whole number, 1 to " +
               std::to_string(nyu40Classes().back().number));
    return *value;
  }

  std::string path_;
  bool header_taken_ = false;
  std::size_t category_ = 0; ///< column
  std::size_t class_ = 0;    ///< column
  std::map<std::string, std::uint32_t> classes_;
};

} // namespace

std::map<std::string, std::uint32_t>
readScannetClasses(const std::string& path)
{
  ClassTableReading reading(path);
  forEachLine(textOf(path), [&](std::string_view line, std::size_t number) {
    reading.take(line, number);
  });
  return reading.classes();
}

} // namespace pcl_cid
