/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Tables as CSV.
 */

#pragma once

#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>

namespace pcl_cid::tools {

/** \brief One line of a CSV table, cell by cell; it ends when this does. */
class CsvRow {
public:
  explicit CsvRow(std::ostream& stream) : stream_(stream) {}

  ~CsvRow() { stream_ << "\n"; }

  CsvRow(const CsvRow&) = delete;
  CsvRow&
  operator=(const CsvRow&) = delete;

  /** \brief Text, in quotes where it needs them. */
  CsvRow&
  operator<<(const std::string& text)
  {
    next();
    if (text.find_first_of(",\"\n\r") == std::string::npos) {
      stream_ << text;
      return *this;
    }
    stream_ << '"';
    for (const char letter : text)
      stream_ << (letter == '"' ? "\"" : "") << letter;
    stream_ << '"';
    return *this;
  }

  CsvRow&
  operator<<(std::size_t number)
  {
    next();
    stream_ << number;
    return *this;
  }

  /** \brief A number, or an empty cell for NaN. */
  CsvRow&
  operator<<(double number)
  {
    next();
    if (!std::isnan(number))
      stream_ << number;
    return *this;
  }

private:
  void
  next()
  {
    stream_ << (is_first_ ? "" : ",");
    is_first_ = false;
  }

  std::ostream& stream_;
  bool is_first_ = true;
};

} // namespace pcl_cid::tools
