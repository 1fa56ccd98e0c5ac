/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Writing PLY files: vertices, and the pose where PCL looks for it.
 */

#include "base/sentence.h"
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
  std::uint8_t datatype; ///< in the cloud
  std::uint32_t offset;  ///< in a point

  bool
  isLongInteger() const
  {
    return plyTypeName(datatype) == nullptr;
  }

  /** PLY has no integers of 8 bytes. */
  std::uint8_t
  writtenType() const
  {
    return isLongInteger() ? std::uint8_t{pcl::PCLPointField::FLOAT64} : datatype;
  }
};

/** The properties of a cloud, under names that differ. */
class Properties {
public:
  explicit Properties(const pcl::PCLPointCloud2& cloud) : cloud_(cloud)
  {
    for (const pcl::PCLPointField& field : cloud.fields)
      add(field);
  }

  const std::vector<Property>&
  all() const
  {
    return properties_;
  }

private:
  bool
  isTaken(const std::string& name) const
  {
    return findField(cloud_, name) != nullptr;
  }

  void
  add(const pcl::PCLPointField& field)
  {
    if (isColor(field))
      return addColor(field);
    const std::string name = propertyName(field.name);
    if (field.count == 1) {
      properties_.push_back({name, field.datatype, field.offset});
      return;
    }
    const std::string stem = stemOf(name, field.count);
    const auto size = static_cast<std::uint32_t>(sizeOf(field.datatype));
    for (std::uint32_t k = 0; k < field.count; ++k)
      properties_.push_back(
          {stem + std::to_string(k), field.datatype, field.offset + k * size});
  }

  /** What is written as red, green and blue, if these names are free. */
  bool
  isColor(const pcl::PCLPointField& field) const
  {
    return (field.name == "rgb" || field.name == "rgba") && field.count == 1 &&
           sizeOf(field.datatype) == 4 &&
           !isTaken(field.name == "rgb" ? "rgba" : "rgb") && !isTaken("red") &&
           !isTaken("green") && !isTaken("blue") && !isTaken("alpha");
  }

  void
  addColor(const pcl::PCLPointField& field)
  {
    constexpr auto byte = std::uint8_t{pcl::PCLPointField::UINT8};
    properties_.push_back({"red", byte, field.offset + 2});
    properties_.push_back({"green", byte, field.offset + 1});
    properties_.push_back({"blue", byte, field.offset});
    if (field.name == "rgba")
      properties_.push_back({"alpha", byte, field.offset + 3});
  }

  /** PLY's names of normals. */
  std::string
  propertyName(const std::string& field) const
  {
    if (field != "normal_x" && field != "normal_y" && field != "normal_z")
      return field;
    const std::string name = "n" + field.substr(7);
    return isTaken(name) ? field : name;
  }

  /** What the values of a field with several are called, before their numbers: as many
   *  "_" after its name as keep them apart from all fields. */
  std::string
  stemOf(const std::string& name, std::uint32_t count) const
  {
    std::string stem = name;
    bool collides = true;
    while (collides) {
      stem += '_';
      collides = false;
      for (std::uint32_t k = 0; k < count && !collides; ++k)
        collides = isTaken(stem + std::to_string(k));
    }
    return stem;
  }

  const pcl::PCLPointCloud2& cloud_;
  std::vector<Property> properties_;
};

/** \return whether double holds a whole number of 8 bytes exactly */
bool
isExactInDouble(const std::uint8_t* bytes, std::uint8_t datatype)
{
  return visitType(datatype, [&](auto type) {
    using Value = decltype(type);
    const auto value = loadValue<Value>(bytes);
    const auto rounded = static_cast<long double>(static_cast<double>(value));
    return rounded == static_cast<long double>(value);
  });
}

void
requireExact(const LabelledCloud& cloud, const Property& property)
{
  const std::uint8_t* value = cloud.fields.data.data() + property.offset;
  for (std::size_t i = 0; i < cloud.size(); ++i, value += cloud.fields.point_step)
    if (!isExactInDouble(value, property.datatype)) {
      std::string text;
      appendValue(value, property.datatype, text);
      throw CIDException(
          sentence(cloud.name,
                   ": field '",
                   property.name,
                   "' of point ",
                   cloud.first_point + i,
                   " is ",
                   text,
                   "; PLY has no type that holds it; write a .pcd file"));
    }
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
writeHead(std::ostream& stream, const LabelledCloud& cloud, CloudEncoding encoding)
{
  const bool ascii = encoding == CloudEncoding::ascii;
  stream << "ply\nformat " << (ascii ? "ascii" : "binary_little_endian") << " 1.0\n"
         << "element vertex " << cloud.size() << '\n';
  const Properties properties(cloud.fields);
  for (const Property& property : properties.all())
    stream << "property " << plyTypeName(property.writtenType()) << ' ' << property.name
           << '\n';
  stream << "element camera 1\n";
  for (const auto& [name, value] : cameraOf(cloud))
    stream << "property float " << name << '\n';
  stream << "property int viewportx\nproperty int viewporty\n"
            "property float k1\nproperty float k2\nend_header\n";
}

void
writeAsciiRows(std::ostream& stream,
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
}

void
writeBinaryRows(std::ostream& stream,
                const LabelledCloud& cloud,
                const std::vector<Property>& properties)
{
  const std::uint8_t* point = cloud.fields.data.data();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (const Property& property : properties)
      if (property.isLongInteger())
        writeValue(stream, toDouble(point + property.offset, property.datatype));
      else
        stream.write(reinterpret_cast<const char*>(point + property.offset),
                     static_cast<std::streamsize>(sizeOf(property.datatype)));
    point += cloud.fields.point_step;
  }
}

void
writeRows(std::ostream& stream, const LabelledCloud& cloud, CloudEncoding encoding)
{
  const Properties properties(cloud.fields);
  if (encoding == CloudEncoding::ascii)
    writeAsciiRows(stream, cloud, properties.all());
  else
    writeBinaryRows(stream, cloud, properties.all());
}

/** The camera. */
void
writeTail(std::ostream& stream, const LabelledCloud& cloud, CloudEncoding encoding)
{
  const auto camera = cameraOf(cloud);
  if (encoding == CloudEncoding::ascii) {
    std::string line;
    for (const auto& [name, value] : camera) {
      appendNumber(value, line);
      line += ' ';
    }
    stream << line << cloud.fields.width << ' ' << cloud.fields.height << " 0 0\n";
    return;
  }
  for (const auto& [name, value] : camera)
    writeValue(stream, value);
  writeValue(stream, static_cast<std::int32_t>(cloud.fields.width));
  writeValue(stream, static_cast<std::int32_t>(cloud.fields.height));
  writeValue(stream, 0.0f);
  writeValue(stream, 0.0f);
}

} // namespace

void
checkPLYCloud(const LabelledCloud& cloud, const RemarkCallback& remark)
{
  const Properties properties(cloud.fields);
  for (const Property& property : properties.all())
    if (property.isLongInteger()) {
      requireExact(cloud, property);
      remark("field '" + property.name +
             "' has integers of 8 bytes; a PLY holds them as double");
    }
}

CloudPieces
plyPieces()
{
  return {
      {CloudEncoding::ascii, CloudEncoding::binary}, writeHead, writeRows, writeTail};
}

void
writePLYCloud(std::ostream& stream, const LabelledCloud& cloud, CloudEncoding encoding)
{
  writeHead(stream, cloud, encoding);
  writeRows(stream, cloud, encoding);
  writeTail(stream, cloud, encoding);
}

} // namespace pcl_cid
