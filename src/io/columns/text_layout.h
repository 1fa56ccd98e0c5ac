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

/** \brief What separates the cells of a line: ';' where there is one, else ',' unless
 * the line has blanks and commas within its words are decimal ones, else '\t', or ' '
 * for any number of blanks. */
char
separatorOf(std::string_view line);

/** \brief Cut the next cell off a line, without blanks and quotes around it. In quotes,
 *  a separator that is no blank separates nothing.
 *  \param[in,out] line without data once nothing is left
 *  \return none when nothing was left */
std::optional<std::string_view>
takeCell(std::string_view& line, char separator);

/** \brief All cells of a line. */
std::vector<std::string>
cellsOf(std::string_view line, char separator);

} // namespace pcl_cid
