/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How the lines of a text are divided into cells.
 */

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl_cid {

/** \brief What separates the cells of a line, and what the decimals of a number. */
struct TextLayout {
  char separator = ' '; ///< ',', ';' or '\t'; ' ' for any number of blanks
  bool has_decimal_comma = false;
};

/** \brief The layout of a line: its cells are separated by ';' where there is one, else
 *  by tabs, by blanks where that gives three numbers with a comma inside, else by ','.
 */
TextLayout
layoutOf(std::string_view line);

/** \brief Cut the next cell off a line, without blanks and quotes around it.
 *  \param[in,out] line without data once nothing is left
 *  \return none when nothing was left */
std::optional<std::string_view>
takeCell(std::string_view& line, const TextLayout& layout);

/** \brief All cells of a line. */
std::vector<std::string>
cellsOf(std::string_view line, const TextLayout& layout);

} // namespace pcl_cid
