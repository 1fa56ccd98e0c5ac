/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reading text files as a whole, line by line.
 */

#pragma once

#include "binary_reading.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace pcl_cid {

/** \brief The bytes of a file.
 *  \throws CIDException when it cannot be read */
inline std::string
textOf(const std::string& path)
{
  std::ifstream stream = openedForReading(path);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error)
    throw CIDException(path + ": cannot be read: " + error.message());
  std::string text(size, '\0');
  if (!stream.read(text.data(), static_cast<std::streamsize>(text.size())))
    throw CIDException(path + ": could not be read in full: " + std::strerror(errno));
  return text;
}

/** \brief Call \a take(line, number) for each line that is not blank, without its end,
 *  which may be that of Windows, even with several '\r' as some conversions leave them.
 *  Lines count from 1. */
template <typename Take>
void
forEachLine(std::string_view text, const Take& take)
{
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!line.empty() && line.back() == '\r')
      line.remove_suffix(1);
    if (line.find_first_not_of(" \t") != std::string_view::npos)
      take(line, number);
  }
}

} // namespace pcl_cid
