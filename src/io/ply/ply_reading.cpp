/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reading the body of a PLY: vertices into fields, the camera into the pose.
 */

#include "base/sentence.h"
#include "fields/field_values.h"
#include "ply_format.h"
#include "ply_header.h"
#include "text/file_reading.h"
#include "text/numbers.h"

#include <pcl_cid/io/labelled_cloud.h>

#include <algorithm>
#include <array>
#include <istream>
#include <limits>
#include <string>
#include <vector>

namespace pcl_cid {
namespace {

/** A value of any type. */
using Bytes = std::array<std::uint8_t, 8>;

double
toDouble(const Bytes& bytes, std::uint8_t datatype)
{
  return visitType(datatype, [&](auto type) {
    return static_cast<double>(loadValue<decltype(type)>(bytes.data()));
  });
}

/** PCL's names of normals. */
std::string
fieldName(const std::string& property)
{
  if (property == "nx" || property == "ny" || property == "nz")
    return "normal_" + property.substr(1);
  return property;
}

/** Which properties of the vertices make up a packed color; -1 where there is none. */
struct ColorProperties {
  int red = -1;
  int green = -1;
  int blue = -1;
  int alpha = -1;

  explicit ColorProperties(const PLYElement& element)
  {
    for (const std::string prefix : {"", "diffuse_"}) {
      if (red >= 0 && green >= 0 && blue >= 0)
        break;
      red = element.find(prefix + "red", pcl::PCLPointField::UINT8);
      green = element.find(prefix + "green", pcl::PCLPointField::UINT8);
      blue = element.find(prefix + "blue", pcl::PCLPointField::UINT8);
    }
    alpha = element.find("alpha", pcl::PCLPointField::UINT8);
  }

  /** \return the byte of the packed color that a property is, -1 when it is none */
  int
  byteOf(int property) const
  {
    if (red < 0 || green < 0 || blue < 0)
      return -1;
    return property == blue    ? 0
           : property == green ? 1
           : property == red   ? 2
           : property == alpha ? 3
                               : -1;
  }
};

/** Reads one file; each member function is one part of it. */
class PLYReading {
public:
  PLYReading(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
  : stream_(stream)
  , header_(readPLYHeader(stream, cloud.name))
  , body_size_(bytesLeft(stream, size))
  , cloud_(cloud)
  {
  }

  void
  read()
  {
    cloud_.layout = {"PLY", isAscii() ? CloudEncoding::ascii : CloudEncoding::binary};
    const PLYElement& points = vertices();
    requireBytes(points);
    makeFields(points);
    for (const PLYElement& element : header_.elements)
      if (&element == &points)
        readVertices(element);
      else if (element.name == "camera" && element.count == 1)
        readCamera(element);
      else
        readRows(element, [](std::uint64_t, std::size_t, const Bytes&) {});
  }

private:
  template <typename... Parts>
  [[noreturn]] void
  fail(const Parts&... parts) const
  {
    throw CIDException(sentence(cloud_.name, ": ", parts...));
  }

  bool
  isAscii() const
  {
    return header_.encoding == PLYHeader::Encoding::ascii;
  }

  const PLYElement&
  vertices() const
  {
    const auto isVertex = [](const PLYElement& e) { return e.name == "vertex"; };
    const auto& elements = header_.elements;
    const auto found = std::find_if(elements.begin(), elements.end(), isVertex);
    if (found == elements.end() || found->count == 0 || found->properties.empty())
      fail("holds no points (PLY element vertex); at least 1 is needed");
    constexpr std::uint64_t most = std::numeric_limits<std::int32_t>::max();
    if (found->count > most)
      fail("holds ", found->count, " points; at most ", most, " are possible");
    return *found;
  }

  /** Refuse a file that is too short, before memory is taken for its points. */
  void
  requireBytes(const PLYElement& points) const
  {
    std::uint64_t row = 0;
    for (const PLYProperty& property : points.properties) {
      if (property.length_datatype != 0)
        fail("the vertices have a list, '",
             property.name,
             "'; only single values can be read");
      row += isAscii() ? 2 : sizeOf(property.datatype);
    }
    const std::uint64_t least = points.count * row - (isAscii() ? 1 : 0);
    if (body_size_ < least)
      fail("is truncated: ",
           countOf(points.count, "point"),
           " need at least ",
           least,
           " bytes after the header, but there are ",
           body_size_);
  }

  /** The fields of the cloud, and where in a point each property goes. */
  void
  makeFields(const PLYElement& points)
  {
    const ColorProperties color(points);
    std::int64_t color_offset = -1;
    for (std::size_t i = 0; i < points.properties.size(); ++i) {
      const PLYProperty& property = points.properties[i];
      const int byte = color.byteOf(static_cast<int>(i));
      if (byte < 0) {
        offsets_.push_back(
            addField(fieldName(property.name), property.datatype, 1, cloud_.fields)
                .offset);
        continue;
      }
      if (color_offset < 0)
        color_offset = addColor(color.alpha >= 0);
      offsets_.push_back(static_cast<std::uint32_t>(color_offset + byte));
    }
    cloud_.fields.width = static_cast<std::uint32_t>(points.count);
    cloud_.fields.height = 1;
  }

  std::uint32_t
  addColor(bool with_alpha)
  {
    return with_alpha
               ? addField("rgba", pcl::PCLPointField::UINT32, 1, cloud_.fields).offset
               : addField("rgb", pcl::PCLPointField::FLOAT32, 1, cloud_.fields).offset;
  }

  void
  readVertices(const PLYElement& points)
  {
    const std::size_t step = cloud_.fields.point_step;
    cloud_.fields.data.assign(step * points.count, 0);
    std::uint8_t* const data = cloud_.fields.data.data();
    readRows(points, [&](std::uint64_t row, std::size_t i, const Bytes& value) {
      std::memcpy(data + row * step + offsets_[i],
                  value.data(),
                  sizeOf(points.properties[i].datatype));
    });
  }

  /** PCL writes the pose as position and axes, and the shape as the viewport. */
  void
  readCamera(const PLYElement& camera)
  {
    std::vector<double> values(camera.properties.size());
    readRows(camera, [&](std::uint64_t, std::size_t i, const Bytes& value) {
      values[i] = toDouble(value, camera.properties[i].datatype);
    });
    const auto valueOf = [&](const std::string& name) {
      const int i = camera.find(name);
      return i < 0 ? 0.0 : values[static_cast<std::size_t>(i)];
    };
    Eigen::Matrix3d axes;
    for (int row = 0; row < 3; ++row) {
      cloud_.sensor_origin[row] =
          static_cast<float>(valueOf(std::string("view_p") + "xyz"[row]));
      for (int column = 0; column < 3; ++column)
        axes(row, column) =
            valueOf({"xyz"[row], '_', 'a', 'x', 'i', 's', "xyz"[column]});
    }
    if ((axes * axes.transpose()).isIdentity(1e-3))
      cloud_.sensor_orientation = Eigen::Quaterniond(axes).normalized().cast<float>();
    takeShape(valueOf("viewportx"), valueOf("viewporty"));
  }

  void
  takeShape(double width, double height)
  {
    if (width < 1.0 || height < 1.0 ||
        width * height != static_cast<double>(cloud_.size()))
      return;
    cloud_.fields.width = static_cast<std::uint32_t>(width);
    cloud_.fields.height = static_cast<std::uint32_t>(height);
  }

  /** Every value of an element, lists included, to \a take(row, property, value). */
  template <typename Take>
  void
  readRows(const PLYElement& element, const Take& take)
  {
    Bytes value;
    for (std::uint64_t row = 0; row < element.count; ++row)
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PLYProperty& property = element.properties[i];
        std::uint64_t length = 1;
        if (property.length_datatype != 0) {
          readValue(element, row, property.length_datatype, value);
          length = listLength(element, toDouble(value, property.length_datatype));
        }
        for (std::uint64_t k = 0; k < length; ++k) {
          readValue(element, row, property.datatype, value);
          take(row, i, value);
        }
      }
  }

  std::uint64_t
  listLength(const PLYElement& element, double length) const
  {
    if (length < 0.0)
      fail("a list of element '", element.name, "' has ", length, " values");
    return static_cast<std::uint64_t>(length);
  }

  void
  readValue(const PLYElement& element,
            std::uint64_t row,
            std::uint8_t datatype,
            Bytes& value)
  {
    const bool good =
        isAscii() ? readText(datatype, value) : readBytes(datatype, value);
    if (good)
      return;
    if (stream_.eof() && (!isAscii() || word_.empty()))
      fail("is truncated: it ends in row ",
           row + 1,
           " of the ",
           element.count,
           " of element '",
           element.name,
           "'");
    fail("'",
         word_.substr(0, 32),
         "' in row ",
         row + 1,
         " of element '",
         element.name,
         "' is no value of type ",
         plyTypeName(datatype));
  }

  bool
  readText(std::uint8_t datatype, Bytes& value)
  {
    word_.clear();
    return stream_ >> word_ && parseValue(word_, datatype, value.data());
  }

  bool
  readBytes(std::uint8_t datatype, Bytes& value)
  {
    const auto size = static_cast<std::ptrdiff_t>(sizeOf(datatype));
    stream_.read(reinterpret_cast<char*>(value.data()), size);
    if (header_.encoding == PLYHeader::Encoding::big_endian)
      std::reverse(value.begin(), value.begin() + size);
    return static_cast<bool>(stream_);
  }

  std::istream& stream_;
  PLYHeader header_;
  std::uint64_t body_size_;
  LabelledCloud& cloud_;
  std::vector<std::uint32_t> offsets_; ///< in a point, of each property
  std::string word_;
};

} // namespace

void
readPLYCloud(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
{
  PLYReading(stream, size, cloud).read();
  cloud.fields.row_step = cloud.fields.point_step * cloud.fields.width;
}

} // namespace pcl_cid
