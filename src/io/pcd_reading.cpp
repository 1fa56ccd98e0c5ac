/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reading PCD files: a strict header, then one of three bodies.
 */

#include "../core/validation.h"
#include "field_values.h"
#include "pcd_format.h"

#include <array>
#include <limits>
#include <optional>
#include <sstream>

#include <pcl/io/lzf.h>

namespace pcl_cid {
namespace {

using Words = std::vector<std::string>;

constexpr std::uint64_t largest_count = std::numeric_limits<std::int32_t>::max();

/** One entry of FIELDS with its SIZE, TYPE and COUNT. */
struct Column {
  std::string name;
  std::uint8_t datatype = pcl::PCLPointField::FLOAT32;
  std::uint32_t count = 1;
  /** Where its values go in a point; of no meaning for padding. */
  std::uint32_t offset = 0;

  bool
  isPadding() const
  {
    return name == "_";
  }

  std::size_t
  bytes() const
  {
    return count * sizeOf(datatype);
  }
};

/** Reads one file; each member function is one part of it. */
class PCDReading {
public:
  PCDReading(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
  : stream_(stream), size_(size), cloud_(cloud)
  {
  }

  void
  read()
  {
    readHeader();
    makeColumns();
    makeShape();
    const std::uint64_t position = static_cast<std::uint64_t>(stream_.tellg());
    body_size_ = size_ - position;
    if (cloud_.format == CloudFormat::pcd_ascii)
      readAscii();
    else if (cloud_.format == CloudFormat::pcd_binary)
      readBinary();
    else
      readCompressed();
  }

private:
  template <typename... Parts>
  [[noreturn]] void
  fail(const Parts&... parts) const
  {
    throw CIDException(sentence(cloud_.name, ": ", parts...));
  }

  void
  readHeader()
  {
    std::string line;
    while (data_.empty()) {
      if (!std::getline(stream_, line))
        fail("the PCD header ends without a DATA entry; the file is truncated");
      ++line_;
      std::istringstream words(line);
      std::string key;
      if (!(words >> key) || key.front() == '#')
        continue;
      Words values;
      for (std::string word; words >> word;)
        values.push_back(word);
      takeEntry(key, values);
    }
    if (data_ == "ascii")
      cloud_.format = CloudFormat::pcd_ascii;
    else if (data_ == "binary")
      cloud_.format = CloudFormat::pcd_binary;
    else if (data_ == "binary_compressed")
      cloud_.format = CloudFormat::pcd_binary_compressed;
    else
      fail("DATA is ", data_, "; it must be ascii, binary or binary_compressed");
  }

  void
  takeEntry(const std::string& key, const Words& values)
  {
    if (key == "VERSION")
      return;
    if (values.empty())
      fail("line ", line_, ": ", key, " has no value");
    if (key == "FIELDS" || key == "COLUMNS")
      names_ = values;
    else if (key == "SIZE")
      sizes_ = values;
    else if (key == "TYPE")
      types_ = values;
    else if (key == "COUNT")
      counts_ = values;
    else if (key == "WIDTH")
      width_ = wholeNumber(key, values.front());
    else if (key == "HEIGHT")
      height_ = wholeNumber(key, values.front());
    else if (key == "POINTS")
      points_ = wholeNumber(key, values.front());
    else if (key == "VIEWPOINT")
      takePose(values);
    else if (key == "DATA")
      data_ = values.front();
    else if (names_.empty())
      fail("is neither a PCD nor a PLY file");
    else
      fail("line ", line_, ": '", key.substr(0, 32), "' is no entry of a PCD header");
  }

  std::uint64_t
  wholeNumber(const std::string& key, const std::string& word) const
  {
    std::uint64_t value = 0;
    if (!parseValue(word,
                    pcl::PCLPointField::UINT64,
                    reinterpret_cast<std::uint8_t*>(&value)) ||
        value > largest_count)
      fail(key, " is ", word, "; it must be a whole number, 0 to ", largest_count);
    return value;
  }

  void
  takePose(const Words& values)
  {
    std::array<float, 7> pose{};
    bool good = values.size() == pose.size();
    for (std::size_t i = 0; good && i < pose.size(); ++i)
      good = parseValue(values[i],
                        pcl::PCLPointField::FLOAT32,
                        reinterpret_cast<std::uint8_t*>(&pose[i]));
    if (!good)
      fail("line ", line_, ": VIEWPOINT must be 7 numbers (x y z, qw qx qy qz)");
    cloud_.sensor_origin = Eigen::Vector4f(pose[0], pose[1], pose[2], 0.0f);
    cloud_.sensor_orientation = Eigen::Quaternionf(pose[3], pose[4], pose[5], pose[6]);
  }

  void
  makeColumns()
  {
    requireOneEach("SIZE", sizes_);
    requireOneEach("TYPE", types_);
    requireOneEach("COUNT", counts_);
    std::uint64_t step = 0;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      Column column;
      column.name = names_[i];
      if (!sizes_.empty() && !types_.empty())
        column.datatype =
            datatypeOf(types_[i].size() == 1 ? types_[i].front() : '?',
                       static_cast<std::size_t>(wholeNumber("SIZE", sizes_[i])));
      if (column.datatype == 0)
        fail("field '",
             names_[i],
             "' has TYPE ",
             types_[i],
             " and SIZE ",
             sizes_[i],
             "; known are I and U with 1, 2, 4, 8 and F with 4, 8");
      if (!counts_.empty())
        column.count = static_cast<std::uint32_t>(wholeNumber("COUNT", counts_[i]));
      if (column.count == 0)
        fail("field '", names_[i], "' has COUNT 0; it must be at least 1");
      step += static_cast<std::uint64_t>(column.count) * sizeOf(column.datatype);
      if (step > largest_count)
        fail("a point has more than ", largest_count, " bytes");
      columns_.push_back(column);
    }
    for (Column& column : columns_)
      if (!column.isPadding())
        column.offset =
            addField(column.name, column.datatype, column.count, cloud_.fields).offset;
  }

  void
  requireOneEach(const char* key, const Words& values) const
  {
    if (!values.empty() && values.size() != names_.size())
      fail(key, " has ", values.size(), " values for ", names_.size(), " FIELDS");
  }

  void
  makeShape()
  {
    const std::uint64_t width = width_.value_or(points_.value_or(0));
    const std::uint64_t height = height_.value_or(1);
    const std::uint64_t points = points_.value_or(width * height);
    if (width * height != points)
      fail("WIDTH ", width, " x HEIGHT ", height, " is not POINTS ", points);
    if (points == 0)
      fail("holds no points; at least 1 is needed");
    if (points > largest_count)
      fail("holds ", points, " points; at most ", largest_count, " are possible");
    cloud_.fields.width = static_cast<std::uint32_t>(width);
    cloud_.fields.height = static_cast<std::uint32_t>(height);
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
    for (const Column& column : columns_)
      values += column.count;
    return values;
  }

  void
  readAscii()
  {
    // At least a digit and a separator for each value, but for the last separator.
    const std::uint64_t least = 2 * valuesOfPoint() * cloud_.size() - 1;
    if (body_size_ < least)
      failTruncated(least);
    makeRoom();
    std::uint8_t* point = cloud_.fields.data.data();
    std::string line;
    std::size_t read = 0;
    while (std::getline(stream_, line)) {
      ++line_;
      if (line.find_first_not_of(" \t\r") == std::string::npos)
        continue;
      if (read == cloud_.size())
        fail("line ", line_, ": more points than the ", read, " that the header says");
      readPoint(line, point);
      point += cloud_.fields.point_step;
      ++read;
    }
    if (read < cloud_.size())
      fail("is truncated: the header says ",
           countOf(cloud_.size(), "point"),
           ", but there are ",
           read);
  }

  void
  readPoint(std::string_view line, std::uint8_t* point) const
  {
    constexpr std::string_view blanks = " \t\r";
    std::uint8_t padding[8];
    for (const Column& column : columns_)
      for (std::uint32_t k = 0; k < column.count; ++k) {
        line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
        const std::string_view word = line.substr(0, line.find_first_of(blanks));
        line.remove_prefix(word.size());
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
    if (line.find_first_not_of(blanks) != std::string_view::npos)
      fail("line ", line_, ": more values than the ", valuesOfPoint(), " of a point");
  }

  void
  readBinary()
  {
    std::size_t file_step = 0;
    for (const Column& column : columns_)
      file_step += column.bytes();
    const std::uint64_t needed = static_cast<std::uint64_t>(file_step) * cloud_.size();
    if (body_size_ < needed)
      failTruncated(needed);
    makeRoom();
    std::uint8_t* point = cloud_.fields.data.data();
    std::vector<char> row(file_step);
    for (std::size_t i = 0; i < cloud_.size(); ++i) {
      readBytes(row.data(), row.size());
      const char* source = row.data();
      for (const Column& column : columns_) {
        if (!column.isPadding())
          std::memcpy(point + column.offset, source, column.bytes());
        source += column.bytes();
      }
      point += cloud_.fields.point_step;
    }
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
    // LZF turns 3 bytes into at most 264: what claims more is not worth the memory.
    if (plain_size != needed || plain_size / 88 > packed_size)
      fail("is damaged: ",
           countOf(cloud_.size(), "point"),
           " are ",
           needed,
           " bytes, but the compressed data announce ",
           plain_size,
           " in ",
           packed_size);
    constexpr std::size_t longest_run = 64; // a damaged run may be read past the end
    std::vector<char> packed(packed_size + longest_run);
    readBytes(packed.data(), packed_size);
    std::vector<std::uint8_t> plain(plain_size);
    if (pcl::lzfDecompress(packed.data(), packed_size, plain.data(), plain_size) !=
        plain_size)
      fail("is damaged: the compressed data cannot be unpacked");
    makeRoom();
    unpackFields(plain.data());
  }

  void
  unpackFields(const std::uint8_t* source)
  {
    for (const Column& column : columns_) {
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
  std::uint64_t size_;
  LabelledCloud& cloud_;
  std::uint64_t body_size_ = 0;
  std::size_t line_ = 0;
  Words names_, sizes_, types_, counts_;
  std::optional<std::uint64_t> width_, height_, points_;
  std::string data_;
  std::vector<Column> columns_;
};

} // namespace

void
readPCD(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
{
  PCDReading(stream, size, cloud).read();
}

} // namespace pcl_cid
