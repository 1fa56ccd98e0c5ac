/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Files opened and read as a whole, with messages that name them.
 */

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>

namespace pcl_cid {

/** \brief A file, open at its beginning.
 *  \throws CIDException when it cannot be opened */
std::ifstream
openedForReading(const std::string& path);

/** \brief Bytes in a file.
 *  \throws CIDException when they cannot be counted */
std::uint64_t
sizeOfFile(const std::string& path);

/** \brief Bytes of a file that a stream has not read yet.
 *  \param[in] stream of the file
 *  \param[in] size of the file in bytes */
std::uint64_t
bytesLeft(std::istream& stream, std::uint64_t size);

/** \brief What ends the lines of a text: '\r' where that stands alone, as older
 *  programs write it, else '\n'.
 *  \param[in] stream at its beginning; it is there again afterwards */
char
lineEndOf(std::istream& stream);

/** \brief Pass over the byte order mark of UTF-8, if there is one.
 *  \param[in] stream at its beginning */
void
passByteOrderMark(std::istream& stream);

/** \brief Read a line of a header, without its end.
 *  \return whether there was one
 *  \throws CIDException that names the file when a line is longer than any header's */
bool
readHeaderLine(std::istream& stream,
               char line_end,
               const std::string& name,
               std::string& line);

/** \brief All bytes of a file.
 *  \throws CIDException when it cannot be read to its end */
std::string
textOf(const std::string& path);

/** \brief Call \a take(line, number) for each line that is not blank, without its end.
 *
 *  Lines count from 1. They may end as on Windows, even with several '\r', which some
 *  conversions leave behind. */
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
