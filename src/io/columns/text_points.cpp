/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The points of a text: a line of numbers for each, and perhaps names of the columns.
 */

#include "text_points.h"

#include "point_columns.h"
#include "text/file_reading.h"
#include "text/numbers.h"
#include "text/path_names.h"
#include "text/words.h"
#include "text_layout.h"

#include <algorithm>
#include <istream>
#include <limits>

namespace pcl_cid {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

bool
isBlankLine(std::string_view line)
{
  return line.find_first_not_of(usual_blanks) == std::string_view::npos;
}

/** What follows "#" or "//"; none for a line that is no comment. */
std::optional<std::string_view>
commentOf(std::string_view line)
{
  line.remove_prefix(std::min(line.find_first_not_of(usual_blanks), line.size()));
  for (const std::string_view mark : {"#", "//"})
    if (line.substr(0, mark.size()) == mark)
      return line.substr(std::min(line.find_first_not_of("#/"), line.size()));
  return std::nullopt;
}

/** A number; where a comma separates no cells, it may stand for the decimal point. An
 *  empty cell is none, as NaN is. */
std::optional<double>
numberOf(std::string_view cell, char separator)
{
  if (cell.empty())
    return not_a_number;
  const std::optional<double> number = parseLoosely<double>(cell);
  if (number || separator == ',' || cell.find('.') != std::string_view::npos)
    return number;
  std::string text(cell);
  std::replace(text.begin(), text.end(), ',', '.');
  return parseLoosely<double>(text);
}

/** The names of fields that a line may hold. */
std::vector<std::string>
namesIn(std::string_view line, char separator)
{
  std::vector<std::string> names;
  for (const std::string& cell : cellsOf(line, separator))
    names.push_back(fieldNameOf(cell));
  return names;
}

} // namespace

TextPoints::TextPoints(std::istream& stream, LabelledCloud& cloud)
: stream_(stream), line_end_(lineEndOf(stream)), cloud_(cloud)
{
  passByteOrderMark(stream);
  readHead();
  cloud_.layout = {"text", CloudEncoding::ascii};
}

bool
TextPoints::pass()
{
  do
    if (!is_at_point_ && !nextLine())
      return false;
  while (!takeLine());
  if (++points_ > most_points)
    fail("more than ", most_points, " points are not possible");
  return true;
}

bool
TextPoints::next()
{
  if (!pass())
    return false;
  takePoint(line_);
  return true;
}

void
TextPoints::begin()
{
  stream_.clear();
  stream_.seekg(0);
  passByteOrderMark(stream_);
  for (line_number_ = 0; line_number_ < first_point_;)
    nextLine();
  is_at_point_ = true;
  points_ = 0;
  count_ = count_of_head_;
}

void
TextPoints::requireCount() const
{
  if (count_ && *count_ != points_)
    throw CIDException(sentence(cloud_.name,
                                ": says that it holds ",
                                countOf(*count_, "point"),
                                ", but there are ",
                                points_));
}

std::vector<std::string>
TextPoints::names() const
{
  std::vector<std::string> names;
  std::vector<std::string> passed_over;
  for (const TextColumn& column : columns_) {
    if (!column.has_numbers)
      passed_over.push_back("'" + column.name + "'");
    else if (!column.name.empty())
      names.push_back(column.name);
  }
  if (!passed_over.empty())
    cloud_.remarks.push_back("columns without numbers are passed over: " +
                             listed(passed_over, "and"));
  return names;
}

bool
TextPoints::nextLine()
{
  ++line_number_;
  return static_cast<bool>(std::getline(stream_, line_, line_end_));
}

void
TextPoints::readHead()
{
  std::string names;        // of a line before the points, or else of a comment
  std::size_t names_at = 0; // that line; 0: it is a comment
  while (nextLine()) {
    if (line_.find('\0') != std::string::npos)
      fail("holds bytes that are no text");
    if (const auto comment = commentOf(line_)) {
      if (names_at == 0 && namesCoordinates(namesIn(*comment, separatorOf(*comment))))
        names = *comment;
    }
    else if (isBlankLine(line_) || isNameOfSeparator(line_))
      continue;
    else if (const auto count = countIn(line_))
      count_ = count;
    else if (!isPoint(line_) && names_at == 0) {
      names = line_;
      names_at = line_number_;
    }
    else
      return beginColumns(names, names_at);
  }
  throw CIDException(cloud_.name + ": holds no points; at least 1 is needed");
}

bool
TextPoints::isNameOfSeparator(std::string_view line)
{
  return line.substr(0, 4) == "sep=" && line.size() <= 6;
}

std::optional<std::uint64_t>
TextPoints::countIn(std::string_view line)
{
  const std::string_view word = takeWord(line);
  return takeWord(line).empty() ? parseNumber<std::uint64_t>(word) : std::nullopt;
}

bool
TextPoints::isPoint(std::string_view line)
{
  const char separator = separatorOf(line);
  if (namesCoordinates(namesIn(line, separator)))
    return false;
  const std::optional<std::string_view> cell = takeCell(line, separator);
  return cell && numberOf(*cell, separator);
}

void
TextPoints::beginColumns(const std::string& names, std::size_t names_at)
{
  separator_ = separatorOf(line_);
  first_point_ = line_number_;
  is_at_point_ = true;
  count_of_head_ = count_;
  std::vector<std::string> cells = cellsOf(line_, separator_);
  // Some programs end a line with a separator.
  if (cells.back().empty() && namesIn(names, separator_).size() != cells.size())
    cells.pop_back();
  columns_.resize(cells.size());
  takeNames(names, names_at);
  for (std::size_t k = 0; k < cells.size(); ++k)
    columns_[k].has_numbers =
        isNeeded(columns_[k].name) || numberOf(cells[k], separator_);
  row_.resize(static_cast<std::size_t>(std::count_if(
      columns_.begin(), columns_.end(), [](const auto& c) { return c.has_numbers; })));
}

bool
TextPoints::isNeeded(const std::string& name)
{
  return name.empty() || name == "x" || name == "y" || name == "z";
}

void
TextPoints::takeNames(const std::string& line, std::size_t names_at)
{
  for (const char separator : {separator_, separatorOf(line)}) {
    const std::vector<std::string> names = namesIn(line, separator);
    if (names.size() != columns_.size() || !namesCoordinates(names))
      continue;
    for (std::size_t k = 0; k < names.size(); ++k)
      columns_[k].name =
          names[k].empty() ? "column_" + std::to_string(k + 1) : names[k];
    return;
  }
  if (names_at != 0)
    throw CIDException(sentence(cloud_.name,
                                ": line ",
                                names_at,
                                ": '",
                                line.substr(0, 64),
                                "' is no point, and does not name the ",
                                countOf(columns_.size(), "column"),
                                " of line ",
                                line_number_,
                                " with x, y and z among them"));
}

bool
TextPoints::takeLine()
{
  is_at_point_ = false;
  if (isBlankLine(line_) || (commentOf(line_) && !isErrorOfSpreadsheet(line_)))
    return false;
  const auto more = count_ ? countIn(line_) : std::nullopt;
  if (more) // a PTS of several scans
    *count_ += *more;
  return !more;
}

bool
TextPoints::isErrorOfSpreadsheet(std::string_view line)
{
  for (const std::string_view error : {"#N/A", "#DIV/0!", "#VALUE!", "#NUM!", "#REF!"})
    if (line.substr(0, error.size()) == error)
      return true;
  return false;
}

void
TextPoints::takePoint(std::string_view line)
{
  auto value = row_.begin();
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const std::optional<std::string_view> cell = takeCell(line, separator_);
    if (!cell)
      fail(countOf(k, "value"),
           "; as on line ",
           first_point_,
           " there must be ",
           columns_.size());
    if (!columns_[k].has_numbers)
      continue;
    const std::optional<double> number = numberOf(*cell, separator_);
    if (!number)
      fail("'", cell->substr(0, 32), "' is no number", ofColumn(k));
    *value++ = *number;
  }
  while (const std::optional<std::string_view> cell = takeCell(line, separator_))
    if (!cell->empty()) // some programs end a line with a separator
      fail("more than the ", columns_.size(), " values of line ", first_point_);
}

std::string
TextPoints::ofColumn(std::size_t k) const
{
  return sentence(
      " (column ", k + 1, columns_[k].name.empty() ? "" : ", " + columns_[k].name, ")");
}

} // namespace pcl_cid
