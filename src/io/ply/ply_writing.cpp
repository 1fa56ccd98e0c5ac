/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Writing PLY files: vertices, and the pose where PCL looks for it.
 */

#include "fields/field_values.h"
#include "ply_format.h"
#include "ply_header.h"
#include "text/binary_writing.h"
#include "text/numbers.h"

#include <pcl_cid/io/labelled_cloud.h>

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace pcl_cid {
namespace {

/** One value of a vertex. */
struct Property {
  std::string name;
  std::uint8_t datatype;
  std::uint32_t offset; ///< in a point
};

void
addColor(const pcl::PCLPointField& field, std::vector<Property>& properties)
{
  constexpr auto byte = std::uint8_t{pcl::PCLPointField::UINT8};
  properties.push_back({"red", byte, field.offset + 2});
  properties.push_back({"green", byte, field.offset + 1});
  properties.push_back({"blue", byte, field.offset});
  if (field.name == "rgba")
    properties.push_back({"alpha", byte, field.offset + 3});
}

/** PLY's names of normals. */
std::string
propertyName(const std::string& field)
{
  if (field == "normal_x" || field == "normal_y" || field == "normal_z")
    return "n" + field.substr(7);
  return field;
}

std::vector<Property>
propertiesOf(const LabelledCloud& cloud)
{
  std::vector<Property> properties;
  for (const pcl::PCLPointField& field : cloud.fields.fields) {
    const std::size_t size = sizeOf(field.datatype);
    if ((field.name == "rgb" || field.name == "rgba") && size == 4) {
      addColor(field, properties);
      continue;
    }
    if (!plyTypeName(field.datatype))
      throw CIDException(cloud.name +
                         ": PLY has no type for the 8-byte integers of "
                         "field '" +
                         field.name + "'; write a .pcd file");
    for (std::uint32_t k = 0; k < field.count; ++k)
      properties.push_back(
          {propertyName(field.name) + (field.count > 1 ? "_" + std::to_string(k) : ""),
           field.datatype,
           field.offset + static_cast<std::uint32_t>(k * size)});
  }
  return properties;
}

/** The camera element as PCL writes it: each property with its value. */
std::vector<std::pair<std::string, float>>
cameraOf(const LabelledCloud& cloud)
{
  const Eigen::Matrix3f axes = cloud.sensor_orientation.toRotationMatrix();
  std::vector<std::pair<std::string, float>> camera;
  for (int row = 0; row < 3; ++row)
    camera.emplace_back(std::string("view_p") + "xyz"[row], cloud.sensor_origin[row]);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      camera.emplace_back(std::string(1, "xyz"[row]) + "_axis" + "xyz"[column],
                          axes(row, column));
  for (const char* const unused : {"focal", "scalex", "scaley", "centerx", "centery"})
    camera.emplace_back(unused, 0.0f);
  return camera;
}

void
writeHeader(std::ostream& stream,
            const LabelledCloud& cloud,
            const std::vector<Property>& properties,
            bool ascii)
{
  stream << "ply\nformat " << (ascii ? "ascii" : "binary_little_endian") << " 1.0\n"
         << "element vertex " << cloud.size() << '\n';
  for (const Property& property : properties)
    stream << "property " << plyTypeName(property.datatype) << ' ' << property.name
           << '\n';
  stream << "element camera 1\n";
  for (const auto& [name, value] : cameraOf(cloud))
    stream << "property float " << name << '\n';
  stream << "property int viewportx\nproperty int viewporty\n"
            "property float k1\nproperty float k2\nend_header\n";
}

void
writeAscii(std::ostream& stream,
           const LabelledCloud& cloud,
           const std::vector<Property>& properties)
{
  std::string line;
  const std::uint8_t* point = cloud.fields.data.data();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    line.clear();
    for (const Property& property : properties) {
      appendValue(point + property.offset, property.datatype, line);
      line += ' ';
    }
    line.back() = '\n';
    stream << line;
    point += cloud.fields.point_step;
  }
  line.clear();
  for (const auto& [name, value] : cameraOf(cloud)) {
    appendNumber(value, line);
    line += ' ';
  }
  stream << line << cloud.fields.width << ' ' << cloud.fields.height << " 0 0\n";
}

void
writeBinary(std::ostream& stream,
            const LabelledCloud& cloud,
            const std::vector<Property>& properties)
{
  const std::uint8_t* point = cloud.fields.data.data();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (const Property& property : properties)
      stream.write(reinterpret_cast<const char*>(point + property.offset),
                   static_cast<std::streamsize>(sizeOf(property.datatype)));
    point += cloud.fields.point_step;
  }
  for (const auto& [name, value] : cameraOf(cloud))
    writeValue(stream, value);
  writeValue(stream, static_cast<std::int32_t>(cloud.fields.width));
  writeValue(stream, static_cast<std::int32_t>(cloud.fields.height));
  writeValue(stream, 0.0f);
  writeValue(stream, 0.0f);
}

} // namespace

void
writePLYCloud(std::ostream& stream, const LabelledCloud& cloud, CloudEncoding encoding)
{
  const std::vector<Property> properties = propertiesOf(cloud);
  const bool ascii = encoding == CloudEncoding::ascii;
  writeHeader(stream, cloud, properties, ascii);
  if (ascii)
    writeAscii(stream, cloud, properties);
  else
    writeBinary(stream, cloud, properties);
}

} // namespace pcl_cid
