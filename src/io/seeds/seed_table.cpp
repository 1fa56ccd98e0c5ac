/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The table in which an annotator labels seeds.
 */

#include "base/sentence.h"
#include "text/delimited_text.h"
#include "text/file_reading.h"
#include "text/numbers.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/cloud_points.h>
#include <pcl_cid/io/seed_table.h>

#include <cctype>
#include <fstream>
#include <limits>
#include <map>
#include <ostream>
#include <set>
#include <string_view>

#include <Eigen/Geometry>

namespace pcl_cid {
namespace {

constexpr double coordinate_tolerance = 1e-3; // of the cloud's diagonal

/** One row, as text; a column that is missing is empty. */
struct Row {
  std::size_t line;
  std::string index, x, y, z, label;
};

/** The table as text. */
class Rows {
public:
  explicit Rows(const std::string& path)
  : path_(path), table_(readTextTable(textOf(path), path))
  {
    if (table_.rows.empty())
      throw CIDException(path + ": is empty; it must have the columns "
                                "index,x,y,z,label");
    const TextRow& header = table_.rows.front();
    for (std::size_t i = 0; i < header.cells.size(); ++i)
      column_.emplace(header.cells[i], i);
    for (const char* const name : {"index", "label"})
      if (column_.count(name) == 0)
        throw CIDException(sentence(path,
                                    ": line ",
                                    header.line,
                                    ": there is no column '",
                                    name,
                                    "'; the header must be index,x,y,z,label"));
  }

  std::vector<Row>
  all() const
  {
    std::vector<Row> rows;
    for (auto row = table_.rows.begin() + 1; row != table_.rows.end(); ++row)
      rows.push_back({row->line,
                      cell(*row, "index"),
                      cell(*row, "x"),
                      cell(*row, "y"),
                      cell(*row, "z"),
                      cell(*row, "label")});
    return rows;
  }

  const TextTable&
  text() const
  {
    return table_;
  }

private:
  std::string
  cell(const TextRow& row, const char* name) const
  {
    const auto found = column_.find(name);
    return found == column_.end() || found->second >= row.cells.size()
               ? std::string()
               : row.cells[found->second];
  }

  std::string path_;
  TextTable table_;
  std::map<std::string, std::size_t> column_;
};

/** \return whether a label is the name of a class, no number that is none */
bool
isName(const std::string& label)
{
  return std::isdigit(static_cast<unsigned char>(label.front())) == 0 &&
         std::string_view("+-.").find(label.front()) == std::string_view::npos &&
         !parseNumber<double>(label);
}

/** Numbers for the names of classes, in the order in which they come: 1, 2, ... without
 *  those that are labels already. */
std::map<std::string, std::uint32_t>
numbersOfNames(const std::vector<Row>& rows, const TextTable& text)
{
  std::set<std::uint32_t> taken;
  for (const Row& row : rows)
    if (const auto label = text.number<std::uint32_t>(row.label))
      taken.insert(*label);
  std::map<std::string, std::uint32_t> numbers;
  std::uint32_t next = 1;
  for (const Row& row : rows) {
    if (row.label.empty() || !isName(row.label) || numbers.count(row.label) > 0)
      continue;
    while (taken.count(next) > 0)
      ++next;
    numbers[row.label] = next++;
  }
  return numbers;
}

/** Where a point is, in the frame and the unit of its file. */
Eigen::Vector3d
placeInFile(pcl::index_t index, const CloudPoints& points)
{
  const auto local = (*points.points)[static_cast<std::size_t>(index)].getVector3fMap();
  return points.frame.toFile(local.cast<double>()) / points.metres_per_unit;
}

/** Checks rows against the cloud and gathers the seeds. */
class SeedReading {
public:
  SeedReading(const std::string& path, const Rows& rows, const CloudPoints& points)
  : path_(path)
  , text_(rows.text())
  , points_(points)
  , number_of_name_(numbersOfNames(rows.all(), rows.text()))
  {
    for (const auto& [name, number] : number_of_name_)
      table_.names[number] = name;
    Eigen::AlignedBox3f box;
    for (const pcl::PointXYZ& point : *points.points)
      if (point.getVector3fMap().allFinite())
        box.extend(point.getVector3fMap());
    if (!box.isEmpty())
      tolerance_ = coordinate_tolerance * static_cast<double>(box.diagonal().norm()) /
                   points.metres_per_unit;
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
           points_.indexInFile(index),
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
    const auto index = text_.number<std::int64_t>(row.index);
    const pcl::index_t point = index ? points_.find(*index) : -1;
    if (point < 0 && index && *index >= 0 &&
        static_cast<std::uint64_t>(*index) < points_.sizeOfFile())
      fail(row,
           "the index is ",
           *index,
           ", which is no point that a voxel kept; seeds must be proposed with voxels "
           "of "
           "the same size");
    if (point < 0)
      fail(row,
           "the index is '",
           row.index,
           "'; it must be a whole number, 0 to ",
           points_.sizeOfFile() - 1);
    if (!(*points_.points)[static_cast<std::size_t>(point)]
             .getVector3fMap()
             .allFinite())
      fail(row,
           "the index is ",
           *index,
           ", a point whose coordinates are not finite; a seed must be a finite point");
    return point;
  }

  std::uint32_t
  labelOf(const Row& row) const
  {
    if (const auto named = number_of_name_.find(row.label);
        named != number_of_name_.end())
      return named->second;
    const auto label = text_.number<std::uint32_t>(row.label);
    if (!label)
      fail(row,
           "the label is '",
           row.label,
           "'; it must be a whole number, 0 to 4294967295, the name of a class, or "
           "empty");
    return *label;
  }

  void
  requireSamePlace(const Row& row, pcl::index_t index) const
  {
    const Eigen::Vector3d place = placeInFile(index, points_);
    int axis = 0;
    for (const std::string* const text : {&row.x, &row.y, &row.z}) {
      if (!text->empty()) {
        const auto value = text_.number<double>(*text);
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
               points_.indexInFile(index),
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
  const TextTable& text_;
  const CloudPoints& points_;
  const std::map<std::string, std::uint32_t> number_of_name_;
  double tolerance_ = 0.0;
  std::map<pcl::index_t, Labelled> first_;
  SeedTable table_;
};

} // namespace

void
writeSeedTable(std::ostream& stream,
               const pcl::Indices& seeds,
               const CloudPoints& points,
               const std::vector<std::optional<std::uint32_t>>& labels)
{
  stream << "index,x,y,z,label\n";
  const bool is_double = !points.frame.origin.isZero(0.0);
  std::string line;
  for (std::size_t k = 0; k < seeds.size(); ++k) {
    const pcl::index_t seed = seeds[k];
    line = std::to_string(points.indexInFile(seed));
    const Eigen::Vector3d in_file = placeInFile(seed, points);
    for (int axis = 0; axis < 3; ++axis) {
      line += ',';
      if (is_double)
        appendNumber(in_file[axis], line);
      else
        appendNumber(static_cast<float>(in_file[axis]), line);
    }
    line += ',';
    if (!labels.empty() && labels[k])
      line += std::to_string(*labels[k]);
    stream << line << '\n';
  }
}

SeedTable
readSeedTable(const std::string& path, const CloudPoints& points)
{
  const Rows rows(path);
  SeedReading reading(path, rows, points);
  for (const Row& row : rows.all())
    reading.take(row);
  return reading.table();
}

bool
holdsLabels(const std::string& path)
{
  if (!std::ifstream(path))
    return false;
  try {
    const Rows rows(path);
    for (const Row& row : rows.all())
      if (!row.label.empty())
        return true;
  }
  catch (const CIDException&) {
    return false; // no seed table
  }
  return false;
}

} // namespace pcl_cid
