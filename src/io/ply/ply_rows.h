/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reading the body of a PLY, row by row: whatever its header does not announce is
 * refused.
 */

#pragma once

#include "ply_header.h"

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace pcl_cid {

/** \brief Reads the elements in the order of the header, then makes sure that nothing
 *  is left. In ascii a row ends where its line ends; a line may break within a row. */
class PLYRows {
public:
  /** \param[in] stream after the header
   *  \param[in] size of the file in bytes
   *  \param[in] header must live as long as the reading
   *  \param[in] name of the file, for messages */
  PLYRows(std::istream& stream,
          std::uint64_t size,
          const PLYHeader& header,
          const std::string& name);

  /** \brief Read the next element.
   *  \param[in] take called as take(row, property, values, count) for each property of
   *  each row; \a values are bytes, \a count is 1 for what is no list
   *  \throws CIDException when the file does not fit the header */
  template <typename Take>
  void
  read(const PLYElement& element, const Take& take)
  {
    begin(element);
    if (!element.properties.empty())
      readRows(element.count, take);
  }

  /** \brief Begin to read an element that is read in pieces. */
  void
  begin(const PLYElement& element);

  /** \brief Read the next rows of the element that was begun; there are so many.
   *  \param[in] take as in read() */
  template <typename Take>
  void
  readRows(std::uint64_t count, const Take& take)
  {
    const PLYElement& element = *element_;
    for (const std::uint64_t last = row_ + count; row_ < last; ++row_) {
      beginRow();
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const std::uint64_t count = readProperty(element.properties[i]);
        take(row_, i, values_.data(), count);
      }
      endRow();
    }
  }

  /** \brief The number, from 0, of the row that comes next. */
  std::uint64_t
  row() const
  {
    return row_;
  }

  /** \brief Read the next element, and use none of it. */
  void
  pass(const PLYElement& element);

  /** \throws CIDException when something is left after the last element */
  void
  requireEnd();

private:
  template <typename... Parts>
  [[noreturn]] void
  fail(const Parts&... parts) const;

  /** "row 1 of element 'vertex'". */
  std::string
  place() const;

  void
  beginRow();

  void
  endRow();

  /** \return number of values, which are in values_ then */
  std::uint64_t
  readProperty(const PLYProperty& property);

  void
  readValue(std::uint8_t datatype, std::uint8_t* value);

  [[noreturn]] void
  failTruncated() const;

  /** \return false when the file ends before */
  bool
  take(std::uint8_t* bytes, std::size_t count);

  bool
  readBytes(std::uint8_t datatype, std::uint8_t* value);

  /** The next word, on a later line if need be; empty at the end of the file. */
  void
  nextWord();

  bool
  nextLine();

  std::istream& stream_;
  const std::uint64_t size_;
  const PLYHeader& header_;
  const std::string& name_;
  const bool is_ascii_;

  const PLYElement* element_ = nullptr;
  std::uint64_t row_ = 0;
  std::vector<std::uint8_t> values_;

  std::vector<std::uint8_t> row_bytes_; ///< of a binary row without lists, read at once
  std::size_t next_byte_ = 0;           ///< of row_bytes_

  std::string line_;
  std::string_view rest_; ///< of the line
  std::string_view word_;
  std::size_t line_number_;
  std::size_t first_line_ = 0;      ///< of the row
  std::uint64_t values_of_row_ = 0; ///< so far
  std::uint64_t values_of_first_line_ = 0;
};

} // namespace pcl_cid
