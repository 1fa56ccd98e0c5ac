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
#include "ply_vertices.h"
#include "text/file_reading.h"
#include "text/numbers.h"

#include <pcl_cid/io/labelled_cloud.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl_cid {
namespace {

/** Reads one file, all at once or block by block. */
class PLYReading : public CloudRows {
public:
  PLYReading(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
  : stream_(stream)
  , size_(size)
  , header_(readPLYHeader(stream, cloud.name))
  , points_(vertices(cloud.name))
  , body_size_(bytesLeft(stream, size))
  , rows_(stream, size, header_, cloud.name)
  , cloud_(cloud)
  {
    cloud_.layout = {"PLY", isAscii() ? CloudEncoding::ascii : CloudEncoding::binary};
    requireBytes();
    makeFields();
    for (const PLYProperty& property : points_.properties)
      sizes_.push_back(sizeOf(property.datatype));
  }

  void
  readAll()
  {
    readAround([&] {
      cloud_.fields.data.assign(cloud_.fields.point_step * points_.count, 0);
      rows_.begin(points_);
      read(points_.count, cloud_.fields.data.data());
    });
    for (const VertexList& list : lists_)
      addList(points_.properties[list.property], list);
  }

  /** Whether it is known where each of its points stands. */
  bool
  hasRows() const
  {
    return !isAscii() &&
           std::none_of(points_.properties.begin(),
                        points_.properties.end(),
                        [](const PLYProperty& p) { return p.length_datatype != 0; });
  }

  /** Read all but the points, which may stand before or after the rest. */
  void
  readHead()
  {
    readAround([&] {
      rows_.begin(points_);
      first_point_ = stream_.tellg();
      const std::uint64_t bytes =
          points_.count *
          std::accumulate(sizes_.begin(), sizes_.end(), std::uint64_t{0});
      if (bytesLeft(stream_, size_) < bytes)
        fail("is truncated: it ends before the last of its points");
      stream_.seekg(static_cast<std::streamoff>(bytes), std::ios::cur);
    });
  }

  void
  begin() override
  {
    stream_.clear();
    stream_.seekg(first_point_);
    rows_.begin(points_);
  }

  void
  read(std::size_t count, std::uint8_t* points) override
  {
    const std::size_t step = cloud_.fields.point_step;
    const std::uint64_t first = rows_.row();
    rows_.readRows(count,
                   [&](std::uint64_t row,
                       std::size_t i,
                       const std::uint8_t* values,
                       std::uint64_t values_count) {
                     const Target& target = targets_[i];
                     if (target.offset >= 0)
                       std::memcpy(points + (row - first) * step + target.offset,
                                   values,
                                   sizes_[i]);
                     else if (target.list >= 0)
                       lists_[static_cast<std::size_t>(target.list)].take(
                           values, values_count, sizes_[i]);
                   });
  }

  /** What follows the points was read with the head. */
  void
  end() override
  {
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

  /** Read the elements in their order.
   *  \param[in] readPoints reads or passes over the vertices */
  template <typename ReadPoints>
  void
  readAround(const ReadPoints& readPoints)
  {
    for (const PLYElement& element : header_.elements)
      if (&element == &points_)
        readPoints();
      else if (element.name == "camera" && element.count == 1)
        readCamera(element);
      else
        passOver(element);
    rows_.requireEnd();
  }

  /** \param[in] name of the file, for messages */
  const PLYElement&
  vertices(const std::string& name) const
  {
    const auto isVertex = [](const PLYElement& e) { return e.name == "vertex"; };
    const auto& elements = header_.elements;
    const auto found = std::find_if(elements.begin(), elements.end(), isVertex);
    if (found == elements.end() || found->count == 0 || found->properties.empty())
      throw CIDException(
          name + ": holds no points (PLY element vertex); at least 1 is needed");
    constexpr std::uint64_t most = std::numeric_limits<std::int32_t>::max();
    if (found->count > most)
      throw CIDException(sentence(
          name, ": holds ", found->count, " points; at most ", most, " are possible"));
    return *found;
  }

  /** Refuse a file that is too short, before memory is taken for its points. */
  void
  requireBytes() const
  {
    const PLYElement& points = points_;
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
  makeFields()
  {
    const PLYElement& points = points_;
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

  std::istream& stream_;
  const std::uint64_t size_;
  const PLYHeader header_;
  const PLYElement& points_;
  const std::uint64_t body_size_;
  PLYRows rows_;
  LabelledCloud& cloud_;
  std::vector<Target> targets_;
  std::vector<std::size_t> sizes_; ///< of the values of each property
  std::vector<VertexList> lists_;
  std::streampos first_point_;
};

} // namespace

void
readPLYCloud(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
{
  PLYReading(stream, size, cloud).readAll();
  cloud.fields.row_step = cloud.fields.point_step * cloud.fields.width;
}

std::unique_ptr<CloudRows>
streamPLYCloud(std::istream& stream,
               std::uint64_t size,
               LabelledCloud& head,
               const ProgressCallback&)
{
  auto reading = std::make_unique<PLYReading>(stream, size, head);
  if (!reading->hasRows())
    return nullptr;
  reading->readHead();
  head.fields.row_step = head.fields.point_step * head.fields.width;
  return reading;
}

} // namespace pcl_cid
