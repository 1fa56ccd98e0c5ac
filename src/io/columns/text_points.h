/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The points of a text: a line of numbers for each, and perhaps names of the columns.
 */

#pragma once

#include "base/sentence.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/labelled_cloud.h>

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl_cid {

/** \brief Reads the points of one file, one after the other, as often as need be. */
class TextPoints {
public:
  /** \param[in] stream at the beginning of the file; both outlive this
   *  \param[in,out] cloud has its name; gets the layout
   *  \throws CIDException when no columns of points can be made out */
  TextPoints(std::istream& stream, LabelledCloud& cloud);

  /** \brief Go to the line of the next point, whatever it holds; false after the last.
   *  \throws CIDException for more points than a cloud can have */
  bool
  pass();

  /** \brief Read the next point; false after the last.
   *  \throws CIDException that names the line, for what is no point */
  bool
  next();

  /** \brief The numbers of the point that was read, of the columns that have any. */
  const std::vector<double>&
  row() const
  {
    return row_;
  }

  /** \brief Points so far. */
  std::size_t
  points() const
  {
    return points_;
  }

  /** \brief Go to the first point again. */
  void
  begin();

  /** \brief After the last point: refuse other points than the file says it has.
   *  \throws CIDException */
  void
  requireCount() const;

  /** \brief Whether the file says how many points it has, as a PTS does. */
  bool
  areOfPTS() const
  {
    return count_.has_value();
  }

  /** \brief How many columns have numbers. */
  std::size_t
  columns() const
  {
    return row_.size();
  }

  /** \brief The names of the columns that have numbers, where there are any; a remark
   *  of the cloud says which have none. */
  std::vector<std::string>
  names() const;

private:
  /** A column of the file. */
  struct TextColumn {
    std::string name;        ///< as of a field; empty: it has none
    bool has_numbers = true; ///< else it is passed over
  };

  template <typename... Parts>
  [[noreturn]] void
  fail(const Parts&... parts) const
  {
    throw CIDException(sentence(cloud_.name, ": line ", line_number_, ": ", parts...));
  }

  bool
  nextLine();

  /** All up to the first point: comments, names of the columns, the number of points.
   *  \post line_ holds the first point */
  void
  readHead();

  /** "sep=;", as spreadsheets write it. */
  static bool
  isNameOfSeparator(std::string_view line);

  /** The number of points that follow, as a PTS has it: a whole number alone. */
  static std::optional<std::uint64_t>
  countIn(std::string_view line);

  /** Whether a line begins with a number, or with nothing where one may stand. */
  static bool
  isPoint(std::string_view line);

  /** \param[in] names a comment, or the line before the points
   *  \param[in] names_at the number of that line; 0: it is a comment */
  void
  beginColumns(const std::string& names, std::size_t names_at);

  /** Whether a column cannot be passed over. */
  static bool
  isNeeded(const std::string& name);

  /** Names are laid out as the points, or in their own way. A comment need not hold
   *  any. */
  void
  takeNames(const std::string& line, std::size_t names_at);

  /** Whether a line holds a point. */
  bool
  takeLine();

  /** "#N/A" and the like stand where a number is missing. */
  static bool
  isErrorOfSpreadsheet(std::string_view line);

  void
  takePoint(std::string_view line);

  std::string
  ofColumn(std::size_t k) const;

  std::istream& stream_;
  const char line_end_;
  LabelledCloud& cloud_;
  std::string line_;
  std::size_t line_number_ = 0;
  std::size_t first_point_ = 0;        ///< its line
  bool is_at_point_ = false;           ///< line_ is one that was not yet taken
  std::optional<std::uint64_t> count_; ///< of points, as the file says so far
  std::optional<std::uint64_t> count_of_head_;
  char separator_ = ' ';
  std::vector<TextColumn> columns_;
  std::vector<double> row_;
  std::size_t points_ = 0;
};

} // namespace pcl_cid
