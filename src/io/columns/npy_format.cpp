/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reading arrays of NumPy: a row for each point, or an element with named fields.
 */

#include "base/sentence.h"
#include "column_formats.h"
#include "fields/field_values.h"
#include "npy_header.h"
#include "point_columns.h"
#include "text/file_reading.h"
#include "text/numbers.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <istream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pcl_cid {
namespace {

/** What programs call vectors, and the columns that these are. */
const std::map<std::string, std::array<const char*, 3>> known_vectors{
    {"position", {"x", "y", "z"}},
    {"positions", {"x", "y", "z"}},
    {"point", {"x", "y", "z"}},
    {"points", {"x", "y", "z"}},
    {"color", {"r", "g", "b"}},
    {"colors", {"r", "g", "b"}},
    {"normal", {"nx", "ny", "nz"}},
    {"normals", {"nx", "ny", "nz"}}};

/** The datatype of a field of a cloud. */
std::uint8_t
typeOfField(const NpyField& field)
{
  const char kind = field.kind == 'f' ? 'F' : field.kind == 'i' ? 'I' : 'U';
  return datatypeOf(kind, field.size);
}

/** A number of the file, whose bytes may be in the other order. */
double
numberAt(const std::uint8_t* bytes, const NpyField& field)
{
  std::uint8_t ordered[8];
  std::copy_n(bytes, field.size, ordered);
  if (field.is_big_endian)
    std::reverse(ordered, ordered + field.size);
  return toDouble(ordered, typeOfField(field));
}

/** Reads one file; each member function is one part of it. */
class NpyReading {
public:
  NpyReading(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
  : stream_(stream)
  , header_(readNpyHeader(stream, cloud.name))
  , body_size_(bytesLeft(stream, size))
  , cloud_(cloud)
  {
  }

  void
  read()
  {
    cloud_.layout = {"NumPy", CloudEncoding::binary};
    setFields(isPlain() ? plainColumns() : namedColumns(), cloud_);
  }

private:
  template <typename... Parts>
  [[noreturn]] void
  fail(const Parts&... parts) const
  {
    throw CIDException(sentence(cloud_.name, ": ", parts...));
  }

  /** Whether each element is one number. */
  bool
  isPlain() const
  {
    return header_.fields.size() == 1 && header_.fields[0].name.empty();
  }

  /** "100 x 3". */
  std::string
  shape() const
  {
    std::string text;
    for (const std::uint64_t length : header_.shape)
      text += (text.empty() ? "" : " x ") + std::to_string(length);
    return text;
  }

  /** Width and height of the cloud; points in two dimensions are an image.
   *  \param[in] dimensions of the points */
  PointColumns
  columnsOfShape(std::size_t dimensions) const
  {
    const std::uint64_t height = dimensions == 2 ? header_.shape[0] : 1;
    const std::uint64_t width = header_.shape[dimensions - 1];
    if (height == 0 || width == 0)
      fail("holds no points; at least 1 is needed");
    if (height > most_points || width > most_points / height)
      fail("holds ", shape(), " points; at most ", most_points, " are possible");
    PointColumns columns;
    columns.width = static_cast<std::uint32_t>(width);
    columns.height = static_cast<std::uint32_t>(height);
    return columns;
  }

  std::vector<std::uint8_t>
  body(std::uint64_t points, std::uint64_t bytes_of_point)
  {
    const std::uint64_t needed = points * bytes_of_point;
    if (body_size_ != needed)
      fail("has ",
           countOf(body_size_, "byte"),
           " after its header; ",
           countOf(points, "point"),
           " need ",
           needed);
    std::vector<std::uint8_t> bytes(needed);
    if (!stream_.read(reinterpret_cast<char*>(bytes.data()),
                      static_cast<std::streamsize>(needed)))
      fail("cannot be read to its end");
    return bytes;
  }

  /** N x C, or H x W x C. */
  PointColumns
  plainColumns()
  {
    const std::vector<std::uint64_t>& lengths = header_.shape;
    if ((lengths.size() != 2 && lengths.size() != 3) || lengths.back() < 3 ||
        lengths.back() > most_numbers_of_point)
      fail("is an array of the shape ",
           shape(),
           "; a row of 3 or more numbers is needed for each point");
    PointColumns columns = columnsOfShape(lengths.size() - 1);
    const NpyField& field = header_.fields[0];
    const std::uint64_t points = std::uint64_t{columns.width} * columns.height;
    const std::uint64_t count = lengths.back();
    const std::vector<std::uint8_t> bytes = body(points, count * field.size);
    columns.values.assign(count, std::vector<double>(points));
    for (std::uint64_t i = 0; i < points; ++i)
      for (std::uint64_t k = 0; k < count; ++k)
        columns.values[k][i] =
            numberAt(bytes.data() + placeOf(i, k, columns) * field.size, field);
    return columns;
  }

  /** Where in the file a number stands: in Fortran's order the first index runs
   *  fastest. */
  std::uint64_t
  placeOf(std::uint64_t point, std::uint64_t column, const PointColumns& columns) const
  {
    if (!header_.is_fortran_order)
      return point * header_.shape.back() + column;
    const std::uint64_t x = point % columns.width;
    const std::uint64_t y = point / columns.width;
    return (column * columns.width + x) * columns.height + y;
  }

  /** Elements with fields: a column for each, or for each of its numbers. */
  PointColumns
  namedColumns()
  {
    const std::size_t dimensions = header_.shape.size();
    if (dimensions != 1 && dimensions != 2)
      fail("is an array of the shape ", shape(), "; one or two lengths are needed");
    if (dimensions == 2 && header_.is_fortran_order)
      fail("is an image in Fortran's order; only C's can be read");
    PointColumns columns = columnsOfShape(dimensions);
    const std::uint64_t points = std::uint64_t{columns.width} * columns.height;
    std::size_t step = 0;
    std::size_t numbers = 0;
    for (const NpyField& field : header_.fields) {
      step += field.bytes();
      numbers += field.count;
    }
    if (numbers > most_numbers_of_point)
      fail("holds ",
           numbers,
           " numbers a point; at most ",
           most_numbers_of_point,
           " are possible");
    const std::vector<std::uint8_t> bytes = body(points, step);
    std::size_t offset = 0;
    for (const NpyField& field : header_.fields)
      for (std::size_t n = 0; n < field.count; ++n) {
        columns.names.push_back(nameOf(field, n));
        std::vector<double> values(points);
        for (std::uint64_t i = 0; i < points; ++i)
          values[i] = numberAt(bytes.data() + i * step + offset, field);
        columns.values.push_back(std::move(values));
        offset += field.size;
      }
    return columns;
  }

  /** Vectors have a letter for each number in their names, as "xyz" and "rgb" have;
   *  else the number is added. */
  static std::string
  nameOf(const NpyField& field, std::size_t number)
  {
    if (field.count == 1)
      return fieldNameOf(field.name);
    if (const auto known = known_vectors.find(field.name);
        known != known_vectors.end() && field.count == 3)
      return fieldNameOf(known->second[number]);
    if (field.name.size() == field.count)
      return fieldNameOf(std::string(1, field.name[number]));
    return fieldNameOf(field.name + "_" + std::to_string(number));
  }

  std::istream& stream_;
  const NpyHeader header_;
  const std::uint64_t body_size_;
  LabelledCloud& cloud_;
};

void
readNpy(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
{
  NpyReading(stream, size, cloud).read();
}

} // namespace

CloudFormat
npyFormat()
{
  CloudFormat format;
  format.name = "NumPy";
  format.extensions = {".npy"};
  format.recognizes = recognizesNpy;
  format.read = readNpy;
  return format;
}

} // namespace pcl_cid
