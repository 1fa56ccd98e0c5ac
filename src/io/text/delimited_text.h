/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Tables of text as spreadsheets write them.
 */

#pragma once

#include "numbers.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl_cid {

/** \brief A row of a table. */
struct TextRow {
  std::size_t line;               ///< its first, from 1
  std::vector<std::string> cells; ///< without blanks around them
};

/** \brief A table whose cells are separated by commas, semicolons or tabs. */
struct TextTable {
  char separator = ',';
  /** Those with at least one cell that is not empty. */
  std::vector<TextRow> rows;

  /** \brief A number as this table writes it, see parseLoosely(): where a comma
   *  separates no cells, it may stand for the decimal point. */
  template <typename Number>
  std::optional<Number>
  number(std::string cell) const
  {
    if (separator != ',')
      std::replace(cell.begin(), cell.end(), ',', '.');
    return parseLoosely<Number>(cell);
  }
};

/** \brief Read a table (RFC 4180, and what spreadsheets make of it).
 *
 *  A first line `sep=;` names the separator; else it is the one that the first row has
 *  most of. Cells may be in quotes, and hold separators, line breaks and doubled quotes
 *  then. Lines end in CR, LF or both. The text may be UTF-8 or UTF-16, with a byte
 *  order mark.
 *  \param[in] name of the file, for messages
 *  \throws CIDException when quotes do not end */
TextTable
readTextTable(std::string_view text, const std::string& name);

} // namespace pcl_cid
