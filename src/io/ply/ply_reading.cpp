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
#include "ply_rows.h"
#include "text/file_reading.h"
#include "text/numbers.h"

#include <pcl_cid/io/labelled_cloud.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl_cid {
namespace {

/** PCL's names of normals, unless these are taken. */
std::string
fieldName(const std::string& property, const PLYElement& points)
{
  if (property != "nx" && property != "ny" && property != "nz")
    return property;
  const std::string name = "normal_" + property.substr(1);
  return points.find(name) < 0 ? name : property;
}

/** What holds no values: a PLY by PCL has padding, as a PCD has. */
bool
isPadding(const PLYProperty& property)
{
  return property.name == padding_name;
}

/** A list of the vertices: a field with several values when all have the same number.
 */
struct VertexList {
  std::size_t property;
  std::optional<std::uint64_t> length = {};
  bool varies = false;
  std::vector<std::uint8_t> values = {};

  void
  take(const std::uint8_t* bytes, std::uint64_t count, std::size_t value_size)
  {
    varies = varies || count != length.value_or(count);
    length = count;
    if (varies)
      values = {};
    else
      values.insert(values.end(), bytes, bytes + count * value_size);
  }
};

/** Which properties of the vertices make up a packed color; -1 where there is none. */
struct ColorProperties {
  int red = -1;
  int green = -1;
  int blue = -1;
  int alpha = -1;

  explicit ColorProperties(const PLYElement& element)
  {
    if (element.find("rgb") >= 0 || element.find("rgba") >= 0)
      return;
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
  : header_(readPLYHeader(stream, cloud.name))
  , body_size_(bytesLeft(stream, size))
  , rows_(stream, size, header_, cloud.name)
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
        passOver(element);
    rows_.requireEnd();
    for (const VertexList& list : lists_)
      addList(points.properties[list.property], list);
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
    for (const PLYProperty& property : points.properties)
      row += isAscii()                       ? 2
             : property.length_datatype != 0 ? sizeOf(property.length_datatype)
                                             : sizeOf(property.datatype);
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
    targets_.resize(points.properties.size());
    for (std::size_t i = 0; i < points.properties.size(); ++i) {
      const PLYProperty& property = points.properties[i];
      if (isPadding(property))
        continue;
      if (property.length_datatype != 0) {
        targets_[i].list = static_cast<int>(lists_.size());
        lists_.push_back({i});
        continue;
      }
      const int byte = color.byteOf(static_cast<int>(i));
      if (byte >= 0 && color_offset < 0)
        color_offset = addColor(color.alpha >= 0);
      targets_[i].offset = byte >= 0 ? color_offset + byte : addValue(property, points);
    }
    cloud_.fields.width = static_cast<std::uint32_t>(points.count);
    cloud_.fields.height = 1;
  }

  std::int64_t
  addValue(const PLYProperty& property, const PLYElement& points)
  {
    return addField(
               fieldName(property.name, points), property.datatype, 1, cloud_.fields)
        .offset;
  }

  std::int64_t
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
    std::vector<std::size_t> sizes;
    for (const PLYProperty& property : points.properties)
      sizes.push_back(sizeOf(property.datatype));
    rows_.read(points,
               [&](std::uint64_t row,
                   std::size_t i,
                   const std::uint8_t* values,
                   std::uint64_t count) {
                 const Target& target = targets_[i];
                 if (target.offset >= 0)
                   std::memcpy(data + row * step + target.offset, values, sizes[i]);
                 else if (target.list >= 0)
                   lists_[static_cast<std::size_t>(target.list)].take(
                       values, count, sizes[i]);
               });
  }

  void
  passOver(const PLYElement& element)
  {
    rows_.pass(element);
    if (element.name == "face" && element.count > 0)
      cloud_.remarks.push_back(ply_is_mesh);
  }

  void
  addList(const PLYProperty& property, const VertexList& list)
  {
    const std::uint64_t count = list.varies ? 0 : list.length.value_or(0);
    constexpr std::uint64_t largest_step = std::numeric_limits<std::int32_t>::max();
    if (count == 0 ||
        cloud_.fields.point_step + count * sizeOf(property.datatype) > largest_step) {
      cloud_.remarks.push_back("the list '" + property.name +
                               "' of its vertices is passed over; only lists that are "
                               "equally long for all of them can be kept");
      return;
    }
    const std::size_t old_step = cloud_.fields.point_step;
    const std::size_t bytes = count * sizeOf(property.datatype);
    addField(property.name,
             property.datatype,
             static_cast<std::uint32_t>(count),
             cloud_.fields);
    std::vector<std::uint8_t> data;
    data.reserve(cloud_.size() * cloud_.fields.point_step);
    const std::uint8_t* point = cloud_.fields.data.data();
    const std::uint8_t* values = list.values.data();
    for (std::size_t i = 0; i < cloud_.size(); ++i) {
      data.insert(data.end(), point, point + old_step);
      data.insert(data.end(), values, values + bytes);
      point += old_step;
      values += bytes;
    }
    cloud_.fields.data = std::move(data);
  }

  /** PCL writes the pose as position and axes, and the shape as the viewport. */
  void
  readCamera(const PLYElement& camera)
  {
    std::vector<double> values(camera.properties.size());
    rows_.read(camera,
               [&](std::uint64_t,
                   std::size_t i,
                   const std::uint8_t* bytes,
                   std::uint64_t count) {
                 if (count > 0)
                   values[i] = toDouble(bytes, camera.properties[i].datatype);
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
    if (width < 1.0 || height < 1.0 || std::floor(width) != width ||
        width * height != static_cast<double>(cloud_.size()))
      return;
    cloud_.fields.width = static_cast<std::uint32_t>(width);
    cloud_.fields.height = static_cast<std::uint32_t>(height);
  }

  /** Where the values of a property go: to an offset in the points, or to a list, or
   *  nowhere. */
  struct Target {
    std::int64_t offset = -1;
    int list = -1;
  };

  const PLYHeader header_;
  const std::uint64_t body_size_;
  PLYRows rows_;
  LabelledCloud& cloud_;
  std::vector<Target> targets_;
  std::vector<VertexList> lists_;
};

} // namespace

void
readPLYCloud(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
{
  PLYReading(stream, size, cloud).read();
  cloud.fields.row_step = cloud.fields.point_step * cloud.fields.width;
}

} // namespace pcl_cid
