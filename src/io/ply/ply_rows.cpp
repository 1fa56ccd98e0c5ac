/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reading the body of a PLY, row by row: whatever its header does not announce is
 * refused.
 */

#include "ply_rows.h"

#include "base/sentence.h"
#include "fields/field_values.h"
#include "text/file_reading.h"
#include "text/numbers.h"
#include "text/words.h"

#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cstring>
#include <istream>

namespace pcl_cid {
namespace {

constexpr std::size_t largest_value = 8; // bytes

} // namespace

PLYRows::PLYRows(std::istream& stream,
                 std::uint64_t size,
                 const PLYHeader& header,
                 const std::string& name)
: stream_(stream)
, size_(size)
, header_(header)
, name_(name)
, is_ascii_(header.encoding == PLYHeader::Encoding::ascii)
, values_(largest_value)
, line_number_(header.lines)
{
}

void
PLYRows::pass(const PLYElement& element)
{
  read(element, [](std::uint64_t, std::size_t, const std::uint8_t*, std::uint64_t) {});
}

void
PLYRows::requireEnd()
{
  if (is_ascii_) {
    nextWord();
    if (!word_.empty())
      fail("line ",
           line_number_,
           ": '",
           word_.substr(0, 32),
           "' is left after the last of the ",
           countOf(element_->count, "row"),
           " of element '",
           element_->name,
           "' that the header announces");
    return;
  }
  if (const std::uint64_t left = bytesLeft(stream_, size_); left > 0)
    fail(countOf(left, "byte"),
         " left after the last of the ",
         countOf(element_->count, "row"),
         " of element '",
         element_->name,
         "'; the header announces too few rows or properties");
}

template <typename... Parts>
void
PLYRows::fail(const Parts&... parts) const
{
  throw CIDException(sentence(name_, ": ", parts...));
}

std::string
PLYRows::place() const
{
  return sentence("row ", row_ + 1, " of element '", element_->name, "'");
}

void
PLYRows::begin(const PLYElement& element)
{
  element_ = &element;
  row_ = 0;
  std::size_t bytes = 0;
  bool has_lists = false;
  for (const PLYProperty& property : element.properties) {
    bytes += sizeOf(property.datatype);
    has_lists = has_lists || property.length_datatype != 0;
  }
  row_bytes_.resize(is_ascii_ || has_lists ? 0 : bytes);
}

void
PLYRows::beginRow()
{
  first_line_ = 0;
  values_of_row_ = 0;
  next_byte_ = 0;
  if (!row_bytes_.empty() && !take(row_bytes_.data(), row_bytes_.size()))
    failTruncated();
}

void
PLYRows::endRow()
{
  const std::uint64_t expected = values_of_row_;
  while (!(word_ = takeWord(rest_)).empty())
    ++values_of_row_;
  if (values_of_row_ == expected)
    return;
  // A row that goes on in a line with more than it needs has lost a value before.
  const std::uint64_t found =
      first_line_ == line_number_ ? values_of_row_ : values_of_first_line_;
  fail("line ",
       first_line_,
       ": ",
       place(),
       " has ",
       countOf(found, "value"),
       "; the header says ",
       expected);
}

std::uint64_t
PLYRows::readProperty(const PLYProperty& property)
{
  if (property.length_datatype == 0) {
    readValue(property.datatype, values_.data());
    return 1;
  }
  readValue(property.length_datatype, values_.data());
  const double length = toDouble(values_.data(), property.length_datatype);
  if (length < 0.0)
    fail("the list '", property.name, "' in ", place(), " has ", length, " values");
  const auto count = static_cast<std::uint64_t>(length);
  const std::size_t size = sizeOf(property.datatype);
  for (std::uint64_t k = 0; k < count; ++k) {
    // Room is made as values come: a damaged length must not cost any memory.
    if (values_.size() < (k + 1) * size)
      values_.resize(2 * values_.size());
    readValue(property.datatype, values_.data() + k * size);
  }
  return count;
}

void
PLYRows::readValue(std::uint8_t datatype, std::uint8_t* value)
{
  if (is_ascii_) {
    nextWord();
    if (!word_.empty() && parseValue(word_, datatype, value))
      return;
    if (!word_.empty())
      fail("line ",
           line_number_,
           ": '",
           word_.substr(0, 32),
           "' in ",
           place(),
           " is no value of type ",
           plyTypeName(datatype));
  }
  else if (readBytes(datatype, value))
    return;
  failTruncated();
}

void
PLYRows::failTruncated() const
{
  fail("is truncated: it ends in row ",
       row_ + 1,
       " of the ",
       element_->count,
       " of element '",
       element_->name,
       "'");
}

bool
PLYRows::take(std::uint8_t* bytes, std::size_t count)
{
  const auto size = static_cast<std::streamsize>(count);
  return stream_.rdbuf()->sgetn(reinterpret_cast<char*>(bytes), size) == size;
}

bool
PLYRows::readBytes(std::uint8_t datatype, std::uint8_t* value)
{
  const std::size_t size = sizeOf(datatype);
  if (row_bytes_.empty()) {
    if (!take(value, size))
      return false;
  }
  else {
    std::memcpy(value, row_bytes_.data() + next_byte_, size);
    next_byte_ += size;
  }
  if (header_.encoding == PLYHeader::Encoding::big_endian)
    std::reverse(value, value + size);
  return true;
}

void
PLYRows::nextWord()
{
  while ((word_ = takeWord(rest_)).empty())
    if (!nextLine())
      return;
  if (first_line_ == 0)
    first_line_ = line_number_;
  ++values_of_row_;
  if (first_line_ == line_number_)
    values_of_first_line_ = values_of_row_;
}

bool
PLYRows::nextLine()
{
  if (!std::getline(stream_, line_, header_.line_end))
    return false;
  ++line_number_;
  rest_ = line_;
  return true;
}

} // namespace pcl_cid
