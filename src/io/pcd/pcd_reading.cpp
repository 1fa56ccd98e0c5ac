/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reading PCD files: a strict header, then one of three bodies.
 */

#include "base/sentence.h"
#include "fields/field_values.h"
#include "pcd_format.h"
#include "pcd_header.h"
#include "text/file_reading.h"
#include "text/numbers.h"
#include "text/words.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <istream>
#include <memory>
#include <string_view>
#include <vector>

#include <pcl/io/lzf.h>

namespace pcl_cid {
namespace {

/** Reads one file, all at once or block by block. */
class PCDReading : public CloudRows {
public:
  PCDReading(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
  : stream_(stream)
  , header_(readPCDHeader(stream, cloud.name))
  , body_size_(bytesLeft(stream, size))
  , body_(stream.tellg())
  , line_(header_.lines)
  , cloud_(cloud)
  {
    makeFields();
    for (const PCDColumn& column : header_.columns)
      file_step_ += column.bytes();
  }

  void
  readAll()
  {
    if (!hasRows())
      return readCompressed();
    requireBytes();
    makeRoom();
    read(cloud_.size(), cloud_.fields.data.data());
    end();
  }

  /** Whether its points stand one after the other. */
  bool
  hasRows() const
  {
    return header_.encoding != CloudEncoding::compressed;
  }

  /** Refuse a file that is too short, before memory is taken for its points. */
  void
  requireBytes() const
  {
    // In ascii at least a digit and a separator for each value; the last needs no
    // separator.
    const std::uint64_t least =
        isAscii() ? 2 * valuesOfPoint() * cloud_.size() - 1 : bytesOfRows();
    if (body_size_ < least)
      failTruncated(least);
  }

  void
  begin() override
  {
    stream_.clear();
    stream_.seekg(body_);
    line_ = header_.lines;
    points_read_ = 0;
  }

  void
  read(std::size_t count, std::uint8_t* points) override
  {
    if (isAscii())
      readAscii(count, points);
    else
      readBinary(count, points);
  }

  void
  end() override
  {
    if (!isAscii())
      passPadding(bytesOfRows());
    else if (nextLine())
      fail("line ",
           line_,
           ": more points than the ",
           cloud_.size(),
           " that the header says");
  }

private:
  template <typename... Parts>
  [[noreturn]] void
  fail(const Parts&... parts) const
  {
    throw CIDException(sentence(cloud_.name, ": ", parts...));
  }

  void
  makeFields()
  {
    cloud_.layout = {"PCD", header_.encoding};
    cloud_.sensor_origin = header_.origin;
    cloud_.sensor_orientation = header_.orientation;
    cloud_.fields.width = header_.width;
    cloud_.fields.height = header_.height;
    for (const std::string& name : header_.empty_columns)
      cloud_.remarks.push_back("field '" + name + "' has COUNT 0; it is passed over");
    for (const PCDColumn& column : header_.columns)
      if (!column.isPadding())
        addField(column.name, column.datatype, column.count, cloud_.fields);
    cloud_.fields.row_step = cloud_.fields.point_step * cloud_.fields.width;
  }

  [[noreturn]] void
  failTruncated(std::uint64_t needed) const
  {
    fail("is truncated: ",
         countOf(cloud_.size(), "point"),
         " need at least ",
         needed,
         " bytes after the header, but there are ",
         body_size_);
  }

  /** \return values of a point, padding included or not */
  std::size_t
  valuesOfPoint() const
  {
    std::size_t values = 0;
    for (const PCDColumn& column : header_.columns)
      values += column.count;
    return values;
  }

  bool
  isAscii() const
  {
    return header_.encoding == CloudEncoding::ascii;
  }

  /** Of all points of a binary file. */
  std::uint64_t
  bytesOfRows() const
  {
    return static_cast<std::uint64_t>(file_step_) * cloud_.size();
  }

  /** \return whether there is one more line that is not blank */
  bool
  nextLine()
  {
    while (std::getline(stream_, text_, header_.line_end)) {
      ++line_;
      if (text_.find_first_not_of(usual_blanks) != std::string::npos)
        return true;
    }
    return false;
  }

  void
  readAscii(std::size_t count, std::uint8_t* point)
  {
    for (std::size_t i = 0; i < count; ++i) {
      if (!nextLine())
        fail("is truncated: the header says ",
             countOf(cloud_.size(), "point"),
             ", but there are ",
             points_read_);
      readPoint(text_, point);
      point += cloud_.fields.point_step;
      ++points_read_;
    }
  }

  void
  readPoint(std::string_view line, std::uint8_t* point) const
  {
    std::uint8_t padding[8];
    for (const PCDColumn& column : header_.columns)
      for (std::uint32_t k = 0; k < column.count; ++k) {
        const std::string_view word = takeWord(line);
        if (word.empty())
          fail("line ",
               line_,
               ": fewer values than the ",
               valuesOfPoint(),
               " of a point");
        std::uint8_t* const target =
            column.isPadding() ? padding
                               : point + column.offset + k * sizeOf(column.datatype);
        if (!parseValue(word, column.datatype, target))
          fail("line ",
               line_,
               ": '",
               word.substr(0, 32),
               "' is no value for field '",
               column.name,
               "' (",
               kindOf(column.datatype),
               sizeOf(column.datatype),
               ")");
      }
    if (!takeWord(line).empty())
      fail("line ", line_, ": more values than the ", valuesOfPoint(), " of a point");
  }

  void
  readBinary(std::size_t count, std::uint8_t* point)
  {
    if (file_step_ == cloud_.fields.point_step) // no padding: as it is in the file
      return readBytes(reinterpret_cast<char*>(point), count * file_step_);
    constexpr std::size_t block_bytes = 65536; // the system is asked once for many rows
    const std::size_t block = std::max<std::size_t>(1, block_bytes / file_step_);
    std::vector<char> rows(file_step_ * std::min(block, count));
    for (std::size_t i = 0; i < count; i += block) {
      const std::size_t some = std::min(block, count - i);
      readBytes(rows.data(), some * file_step_);
      const char* row = rows.data();
      for (std::size_t k = 0; k < some; ++k) {
        copyRow(row, point);
        row += file_step_;
        point += cloud_.fields.point_step;
      }
    }
  }

  void
  copyRow(const char* row, std::uint8_t* point) const
  {
    for (const PCDColumn& column : header_.columns) {
      if (!column.isPadding())
        std::memcpy(point + column.offset, row, column.bytes());
      row += column.bytes();
    }
  }

  /** Some programs fill the last page of memory with zeros. Anything else after the
   *  points shows that the header does not fit them.
   *  \param[in] read bytes of the points */
  void
  passPadding(std::uint64_t read)
  {
    const std::uint64_t left = body_size_ - read;
    if (left == 0)
      return;
    constexpr std::uint64_t page = 4096;
    std::vector<char> rest(std::min(left, page));
    readBytes(rest.data(), rest.size());
    const bool is_zero =
        std::all_of(rest.begin(), rest.end(), [](char c) { return c == 0; });
    if (left > page || !is_zero)
      fail("has ",
           countOf(left, "byte"),
           " after its last point; the header says ",
           countOf(cloud_.size(), "point"),
           " in ",
           read,
           " bytes, so fields or points are missing in it");
    cloud_.remarks.push_back(
        sentence(left, " zero bytes after the last point are passed over"));
  }

  /** Two sizes, then all values of the first field, of the second, ... compressed. */
  void
  readCompressed()
  {
    std::array<std::uint32_t, 2> sizes{};
    if (body_size_ < sizeof(sizes))
      failTruncated(sizeof(sizes));
    readBytes(reinterpret_cast<char*>(sizes.data()), sizeof(sizes));
    const auto [packed_size, plain_size] = sizes;
    const std::uint64_t needed =
        static_cast<std::uint64_t>(cloud_.fields.point_step) * cloud_.size();
    if (body_size_ - sizeof(sizes) < packed_size)
      failTruncated(sizeof(sizes) + packed_size);
    // LZF expands 3 bytes to at most 264. A damaged size must not cost any memory.
    if (plain_size != needed || plain_size / 88 > packed_size)
      fail("is damaged: ",
           countOf(cloud_.size(), "point"),
           " are ",
           needed,
           " bytes, but the compressed data announce ",
           plain_size,
           " in ",
           packed_size);
    constexpr std::size_t longest_run = 64; // damaged data may begin one at their end
    std::vector<char> packed(packed_size + longest_run);
    readBytes(packed.data(), packed_size);
    std::vector<std::uint8_t> plain(plain_size);
    if (pcl::lzfDecompress(packed.data(), packed_size, plain.data(), plain_size) !=
        plain_size)
      fail("is damaged: the compressed data cannot be unpacked");
    makeRoom();
    unpackFields(plain.data());
    passPadding(sizeof(sizes) + packed_size);
  }

  void
  unpackFields(const std::uint8_t* source)
  {
    for (const PCDColumn& column : header_.columns) {
      if (column.isPadding())
        continue;
      std::uint8_t* target = cloud_.fields.data.data() + column.offset;
      for (std::size_t i = 0; i < cloud_.size(); ++i) {
        std::memcpy(target, source, column.bytes());
        source += column.bytes();
        target += cloud_.fields.point_step;
      }
    }
  }

  void
  makeRoom()
  {
    cloud_.fields.data.resize(static_cast<std::size_t>(cloud_.fields.point_step) *
                              cloud_.size());
  }

  void
  readBytes(char* bytes, std::size_t count)
  {
    if (!stream_.read(bytes, static_cast<std::streamsize>(count)))
      fail("cannot be read to its end");
  }

  std::istream& stream_;
  const PCDHeader header_;
  const std::uint64_t body_size_;
  const std::streampos body_; ///< where it begins
  std::size_t file_step_ = 0; ///< bytes of a point in it
  std::size_t line_;
  std::string text_; ///< of the line
  std::size_t points_read_ = 0;
  LabelledCloud& cloud_;
};

} // namespace

void
readPCD(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
{
  PCDReading(stream, size, cloud).readAll();
}

std::unique_ptr<CloudRows>
streamPCD(std::istream& stream,
          std::uint64_t size,
          LabelledCloud& head,
          const ProgressCallback&)
{
  auto reading = std::make_unique<PCDReading>(stream, size, head);
  if (!reading->hasRows())
    return nullptr;
  reading->requireBytes();
  return reading;
}

} // namespace pcl_cid
