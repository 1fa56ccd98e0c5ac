/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The words of a line.
 */

#pragma once

#include <algorithm>
#include <string_view>

namespace pcl_cid {

/** \brief What separates words of one line in files that people and many programs
 *  write. */
constexpr std::string_view usual_blanks = " \t\r\v\f";

/** \brief Cut the next word off a line. Scans have millions: standard searches in a set
 *  of characters take several times as long.
 *  \param[in] blanks characters up to the space
 *  \return empty when only blanks are left */
inline std::string_view
takeWord(std::string_view& line, std::string_view blanks = usual_blanks)
{
  const auto isBlank = [blanks](char c) {
    return static_cast<unsigned char>(c) <= ' ' &&
           blanks.find(c) != std::string_view::npos;
  };
  const auto begin = std::find_if_not(line.begin(), line.end(), isBlank);
  const auto end = std::find_if(begin, line.end(), isBlank);
  const std::string_view word =
      line.substr(static_cast<std::size_t>(begin - line.begin()),
                  static_cast<std::size_t>(end - begin));
  line.remove_prefix(static_cast<std::size_t>(end - line.begin()));
  return word;
}

} // namespace pcl_cid
