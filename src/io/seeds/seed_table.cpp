/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The table in which an annotator labels seeds.
 */

#include "base/sentence.h"
#include "text/numbers.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/cloud_points.h>
#include <pcl_cid/io/seed_table.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <ostream>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

constexpr double coordinate_tolerance = 1e-3; // of the cloud's diagonal

std::string
trimmed(const std::string& text)
{
  constexpr const char* blanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string::npos)
    return "";
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::vector<std::string>
cellsOf(const std::string& line)
{
  std::vector<std::string> cells;
  std::size_t begin = 0;
  for (std::size_t comma = line.find(','); comma != std::string::npos;
       comma = line.find(',', begin)) {
    cells.push_back(trimmed(line.substr(begin, comma - begin)));
    begin = comma + 1;
  }
  cells.push_back(trimmed(line.substr(begin)));
  return cells;
}

/** One row, as text; a column that is missing is empty. */
struct Row {
  std::size_t line;
  std::string index, x, y, z, label;
};

/** The table as text. */
class Rows {
public:
  explicit Rows(const std::string& path) : path_(path), stream_(path)
  {
    if (!stream_)
      throw CIDException(path + ": cannot be opened: " + std::strerror(errno));
    std::vector<std::string> header;
    if (!nextCells(header))
      throw CIDException(path + ": is empty; it must have the columns "
                                "index,x,y,z,label");
    for (std::size_t i = 0; i < header.size(); ++i)
      column_.emplace(header[i], i);
    for (const char* const name : {"index", "label"})
      if (column_.count(name) == 0)
        throw CIDException(sentence(path,
                                    ": line ",
                                    line_,
                                    ": there is no column '",
                                    name,
                                    "'; the header must be index,x,y,z,label"));
  }

  bool
  next(Row& row)
  {
    std::vector<std::string> cells;
    if (!nextCells(cells))
      return false;
    const auto cell = [&](const char* name) {
      const auto found = column_.find(name);
      return found == column_.end() || found->second >= cells.size()
                 ? std::string()
                 : cells[found->second];
    };
    row = {line_, cell("index"), cell("x"), cell("y"), cell("z"), cell("label")};
    return true;
  }

private:
  /** The next line that is not blank. */
  bool
  nextCells(std::vector<std::string>& cells)
  {
    std::string line;
    while (std::getline(stream_, line)) {
      if (++line_ == 1 && line.rfind("\xEF\xBB\xBF", 0) == 0)
        line.erase(0, 3); // byte order mark
      if (line.find_first_not_of(" \t\r,") == std::string::npos)
        continue;
      cells = cellsOf(line);
      return true;
    }
    return false;
  }

  std::string path_;
  std::ifstream stream_;
  std::size_t line_ = 0;
  std::map<std::string, std::size_t> column_;
};

/** Checks rows against the cloud and gathers the seeds. */
class SeedReading {
public:
  SeedReading(const std::string& path, const CloudPoints& points)
  : path_(path), points_(points)
  {
    Eigen::AlignedBox3f box;
    for (const pcl::PointXYZ& point : *points.points)
      if (point.getVector3fMap().allFinite())
        box.extend(point.getVector3fMap());
    if (!box.isEmpty())
      tolerance_ = coordinate_tolerance * static_cast<double>(box.diagonal().norm());
  }

  void
  take(const Row& row)
  {
    const pcl::index_t index = indexOf(row);
    requireSamePlace(row, index);
    if (row.label.empty())
      return;
    const std::uint32_t label = labelOf(row);
    const auto [known, is_new] = first_.emplace(index, Labelled{label, row.line});
    if (!is_new && known->second.label != label)
      fail(row,
           "point ",
           index,
           " has label ",
           label,
           ", but label ",
           known->second.label,
           " in line ",
           known->second.line,
           "; it must have one label");
    if (!is_new)
      return;
    table_.seeds.push_back(index);
    table_.labels.push_back(label);
  }

  SeedTable
  table() const
  {
    if (table_.seeds.empty())
      throw CIDException(path_ + ": no label is filled in; at least 1 is needed");
    return table_;
  }

private:
  struct Labelled {
    std::uint32_t label;
    std::size_t line;
  };

  template <typename... Parts>
  [[noreturn]] void
  fail(const Row& row, const Parts&... parts) const
  {
    throw CIDException(sentence(path_, ": line ", row.line, ": ", parts...));
  }

  pcl::index_t
  indexOf(const Row& row) const
  {
    const auto index = parseNumber<std::int64_t>(row.index);
    const std::size_t count = points_.points->size();
    if (!index || *index < 0 || static_cast<std::uint64_t>(*index) >= count)
      fail(row,
           "the index is '",
           row.index,
           "'; it must be a whole number, 0 to ",
           count - 1);
    if (!(*points_.points)[static_cast<std::size_t>(*index)]
             .getVector3fMap()
             .allFinite())
      fail(row,
           "the index is ",
           *index,
           ", a point whose coordinates are not finite; a seed must be a finite point");
    return static_cast<pcl::index_t>(*index);
  }

  std::uint32_t
  labelOf(const Row& row) const
  {
    const auto label = parseNumber<std::uint32_t>(row.label);
    if (!label)
      fail(row,
           "the label is '",
           row.label,
           "'; it must be a whole number, 0 to 4294967295, or empty");
    return *label;
  }

  void
  requireSamePlace(const Row& row, pcl::index_t index) const
  {
    const Eigen::Vector3d place =
        points_.frame.toFile((*points_.points)[static_cast<std::size_t>(index)]
                                 .getVector3fMap()
                                 .cast<double>());
    int axis = 0;
    for (const std::string* const text : {&row.x, &row.y, &row.z}) {
      if (!text->empty()) {
        const auto value = parseNumber<double>(*text);
        if (!value)
          fail(row, "the ", "xyz"[axis], " is '", *text, "'; it must be a number");
        const double rounding =
            std::numeric_limits<float>::epsilon() * std::abs(place[axis]);
        if (!(std::abs(*value - place[axis]) <= tolerance_ + rounding))
          fail(row,
               "the table says (",
               row.x,
               ", ",
               row.y,
               ", ",
               row.z,
               "), but point ",
               index,
               " is at (",
               place.x(),
               ", ",
               place.y(),
               ", ",
               place.z(),
               "); the table must belong to this cloud");
      }
      ++axis;
    }
  }

  std::string path_;
  const CloudPoints& points_;
  double tolerance_ = 0.0;
  std::map<pcl::index_t, Labelled> first_;
  SeedTable table_;
};

} // namespace

void
writeSeedTable(std::ostream& stream,
               const pcl::Indices& seeds,
               const CloudPoints& points)
{
  stream << "index,x,y,z,label\n";
  const bool is_double = !points.frame.origin.isZero(0.0);
  std::string line;
  for (const pcl::index_t seed : seeds) {
    line = std::to_string(seed);
    const auto point =
        (*points.points)[static_cast<std::size_t>(seed)].getVector3fMap();
    const Eigen::Vector3d in_file = points.frame.toFile(point.cast<double>());
    for (int axis = 0; axis < 3; ++axis) {
      line += ',';
      if (is_double)
        appendNumber(in_file[axis], line);
      else
        appendNumber(point[axis], line);
    }
    stream << line << ",\n";
  }
}

SeedTable
readSeedTable(const std::string& path, const CloudPoints& points)
{
  Rows rows(path);
  SeedReading reading(path, points);
  for (Row row; rows.next(row);)
    reading.take(row);
  return reading.table();
}

bool
holdsLabels(const std::string& path)
{
  if (!std::ifstream(path))
    return false;
  try {
    Rows rows(path);
    for (Row row; rows.next(row);)
      if (!row.label.empty())
        return true;
  }
  catch (const CIDException&) {
    return false; // no seed table
  }
  return false;
}

} // namespace pcl_cid
