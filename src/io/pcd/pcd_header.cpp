/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reading the header of a PCD: what the file holds.
 */

#include "pcd_header.h"

#include "base/sentence.h"
#include "text/file_reading.h"
#include "text/numbers.h"

#include <algorithm>
#include <istream>
#include <limits>
#include <optional>
#include <sstream>

namespace pcl_cid {
namespace {

using Words = std::vector<std::string>;

constexpr const char* entries[] = {"VERSION",
                                   "FIELDS",
                                   "COLUMNS",
                                   "SIZE",
                                   "TYPE",
                                   "COUNT",
                                   "WIDTH",
                                   "HEIGHT",
                                   "VIEWPOINT",
                                   "POINTS",
                                   "DATA"};
constexpr std::uint64_t largest_count = std::numeric_limits<std::int32_t>::max();

/** Gathers the entries, then makes a header of them. */
class HeaderReading {
public:
  HeaderReading(const std::string& name, char line_end) : name_(name)
  {
    header_.line_end = line_end;
  }

  /** \return whether more lines follow */
  bool
  takeLine(const std::string& line)
  {
    ++header_.lines;
    std::istringstream words(line);
    std::string key;
    if (!(words >> key) || key.front() == '#')
      return true;
    Words values;
    for (std::string word; words >> word;)
      values.push_back(word);
    takeEntry(key, values);
    return key != "DATA";
  }

  PCDHeader
  header()
  {
    makeColumns();
    makeShape();
    return header_;
  }

private:
  template <typename... Parts>
  [[noreturn]] void
  fail(const Parts&... parts) const
  {
    throw CIDException(sentence(name_, ": ", parts...));
  }

  void
  takeEntry(const std::string& key, const Words& values)
  {
    if (key == "VERSION")
      return;
    if (key == "FIELDS" || key == "COLUMNS")
      names_ = values;
    else if (values.empty())
      fail("line ", header_.lines, ": ", key, " has no value");
    else if (key == "SIZE")
      sizes_ = values;
    else if (key == "TYPE")
      types_ = values;
    else if (key == "COUNT")
      counts_ = values;
    else if (key == "WIDTH")
      width_ = wholeNumber(key, values.front());
    else if (key == "HEIGHT")
      height_ = wholeNumber(key, values.front());
    else if (key == "POINTS")
      points_ = wholeNumber(key, values.front());
    else if (key == "VIEWPOINT")
      takePose(values);
    else if (key == "DATA")
      takeEncoding(values.front());
    else
      fail("line ",
           header_.lines,
           ": '",
           key.substr(0, 32),
           "' is no entry of a PCD header");
  }

  std::uint64_t
  wholeNumber(const std::string& key, const std::string& word) const
  {
    const auto value = parseNumber<std::uint64_t>(word);
    if (!value || *value > largest_count)
      fail(key, " is ", word, "; it must be a whole number, 0 to ", largest_count);
    return *value;
  }

  void
  takePose(const Words& values)
  {
    std::vector<float> pose;
    for (const std::string& value : values)
      if (const auto number = parseNumber<float>(value))
        pose.push_back(*number);
    if (values.size() != 7 || pose.size() != 7)
      fail(
          "line ", header_.lines, ": VIEWPOINT must be 7 numbers (x y z, qw qx qy qz)");
    header_.origin = Eigen::Vector4f(pose[0], pose[1], pose[2], 0.0f);
    header_.orientation = Eigen::Quaternionf(pose[3], pose[4], pose[5], pose[6]);
  }

  void
  takeEncoding(const std::string& data)
  {
    if (data == "ascii")
      header_.encoding = CloudEncoding::ascii;
    else if (data == "binary")
      header_.encoding = CloudEncoding::binary;
    else if (data == "binary_compressed")
      header_.encoding = CloudEncoding::compressed;
    else
      fail("DATA is ", data, "; it must be ascii, binary or binary_compressed");
  }

  void
  makeColumns()
  {
    if (names_.empty())
      fail("the PCD header names no FIELDS; x, y and z are needed");
    requireOneEach("SIZE", sizes_);
    requireOneEach("TYPE", types_);
    requireOneEach("COUNT", counts_);
    std::uint64_t bytes = 0; // with padding
    std::uint32_t offset = 0;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (!counts_.empty() && wholeNumber("COUNT", counts_[i]) == 0) {
        if (names_[i] != padding_name)
          header_.empty_columns.push_back(names_[i]);
        continue;
      }
      PCDColumn column = columnOf(i);
      bytes += column.bytes();
      if (bytes > largest_count)
        fail("a point has more than ", largest_count, " bytes");
      column.offset = offset;
      if (!column.isPadding())
        offset += static_cast<std::uint32_t>(column.bytes());
      header_.columns.push_back(column);
    }
    if (header_.columns.empty())
      fail("the PCD header has COUNT 0 for all of its FIELDS; x, y and z are needed");
  }

  void
  requireOneEach(const char* key, const Words& values) const
  {
    if (!values.empty() && values.size() != names_.size())
      fail(key, " has ", values.size(), " values for ", names_.size(), " FIELDS");
  }

  PCDColumn
  columnOf(std::size_t i) const
  {
    PCDColumn column;
    column.name = names_[i];
    if (!sizes_.empty() && !types_.empty())
      column.datatype =
          datatypeOf(types_[i].size() == 1 ? types_[i].front() : '?',
                     static_cast<std::size_t>(wholeNumber("SIZE", sizes_[i])));
    if (column.datatype == 0)
      fail("field '",
           names_[i],
           "' has TYPE ",
           types_[i],
           " and SIZE ",
           sizes_[i],
           "; known are I and U with 1, 2, 4, 8, F with 4, 8 and B with 1");
    if (!counts_.empty())
      column.count = static_cast<std::uint32_t>(wholeNumber("COUNT", counts_[i]));
    return column;
  }

  void
  makeShape()
  {
    const std::uint64_t width = width_.value_or(points_.value_or(0));
    const std::uint64_t height = height_.value_or(1);
    const std::uint64_t points = points_.value_or(width * height);
    if (width * height != points)
      fail("WIDTH ", width, " x HEIGHT ", height, " is not POINTS ", points);
    if (points == 0)
      fail("holds no points; at least 1 is needed");
    if (points > largest_count)
      fail("holds ", points, " points; at most ", largest_count, " are possible");
    header_.width = static_cast<std::uint32_t>(width);
    header_.height = static_cast<std::uint32_t>(height);
  }

  const std::string& name_;
  PCDHeader header_;
  Words names_, sizes_, types_, counts_;
  std::optional<std::uint64_t> width_, height_, points_;
};

} // namespace

bool
isPCDEntry(std::string_view word)
{
  return std::find(std::begin(entries), std::end(entries), word) != std::end(entries);
}

PCDHeader
readPCDHeader(std::istream& stream, const std::string& name)
{
  const char line_end = lineEndOf(stream);
  passByteOrderMark(stream);
  HeaderReading reading(name, line_end);
  std::string line;
  do {
    if (!readHeaderLine(stream, line_end, name, line))
      throw CIDException(name + ": the PCD header has no DATA entry; the file is "
                                "truncated");
  } while (reading.takeLine(line));
  return reading.header();
}

} // namespace pcl_cid
