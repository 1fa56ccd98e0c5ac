/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Writing PCD files, to the last bit of every field.
 */

#include "base/sentence.h"
#include "fields/field_values.h"
#include "pcd_format.h"
#include "text/numbers.h"

#include <pcl_cid/io/labelled_cloud.h>

#include <array>
#include <ostream>
#include <string>
#include <vector>

#include <pcl/io/lzf.h>

namespace pcl_cid {
namespace {

/** PCL and others expect packed colors as whole numbers in ascii. */
bool
isPackedColor(const pcl::PCLPointField& field)
{
  return field.name == "rgb" && field.datatype == pcl::PCLPointField::FLOAT32;
}

std::uint8_t
writtenType(const pcl::PCLPointField& field, CloudEncoding encoding)
{
  return encoding == CloudEncoding::ascii && isPackedColor(field)
             ? std::uint8_t{pcl::PCLPointField::UINT32}
             : field.datatype;
}

std::string
header(const LabelledCloud& cloud, CloudEncoding encoding)
{
  std::string names, sizes, types, counts;
  for (const pcl::PCLPointField& field : cloud.fields.fields) {
    const std::uint8_t datatype = writtenType(field, encoding);
    names += " " + field.name;
    sizes += " " + std::to_string(sizeOf(datatype));
    types += std::string(" ") + kindOf(datatype);
    counts += " " + std::to_string(field.count);
  }
  std::string pose;
  const Eigen::Vector4f& origin = cloud.sensor_origin;
  const Eigen::Quaternionf& turn = cloud.sensor_orientation;
  for (const float value :
       {origin.x(), origin.y(), origin.z(), turn.w(), turn.x(), turn.y(), turn.z()}) {
    pose += ' ';
    appendNumber(value, pose);
  }
  return sentence("# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS",
                  names,
                  "\nSIZE",
                  sizes,
                  "\nTYPE",
                  types,
                  "\nCOUNT",
                  counts,
                  "\nWIDTH ",
                  cloud.fields.width,
                  "\nHEIGHT ",
                  cloud.fields.height,
                  "\nVIEWPOINT",
                  pose,
                  "\nPOINTS ",
                  cloud.size(),
                  "\nDATA ");
}

void
writeAsciiRows(std::ostream& stream, const LabelledCloud& cloud)
{
  const std::uint8_t* point = cloud.fields.data.data();
  std::string line;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    line.clear();
    for (const pcl::PCLPointField& field : cloud.fields.fields) {
      const std::uint8_t datatype = writtenType(field, CloudEncoding::ascii);
      for (std::uint32_t k = 0; k < field.count; ++k) {
        appendValue(point + field.offset + k * sizeOf(datatype), datatype, line);
        line += ' ';
      }
    }
    line.back() = '\n';
    stream << line;
    point += cloud.fields.point_step;
  }
}

void
writeBytes(std::ostream& stream, const void* bytes, std::size_t count)
{
  stream.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(count));
}

void
writeHead(std::ostream& stream, const LabelledCloud& cloud, CloudEncoding encoding)
{
  stream << header(cloud, encoding)
         << (encoding == CloudEncoding::ascii ? "ascii\n" : "binary\n");
}

void
writeRows(std::ostream& stream, const LabelledCloud& cloud, CloudEncoding encoding)
{
  if (encoding == CloudEncoding::ascii)
    writeAsciiRows(stream, cloud);
  else
    writeBytes(stream, cloud.fields.data.data(), cloud.fields.data.size());
}

/** All values of the first field, of the second, ... */
std::vector<std::uint8_t>
valuesByField(const LabelledCloud& cloud)
{
  std::vector<std::uint8_t> values;
  values.reserve(cloud.fields.data.size());
  for (const pcl::PCLPointField& field : cloud.fields.fields) {
    const std::size_t bytes = field.count * sizeOf(field.datatype);
    const std::uint8_t* source = cloud.fields.data.data() + field.offset;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      values.insert(values.end(), source, source + bytes);
      source += cloud.fields.point_step;
    }
  }
  return values;
}

void
writeCompressed(std::ostream& stream, const LabelledCloud& cloud)
{
  const std::vector<std::uint8_t> plain = valuesByField(cloud);
  const std::size_t room = plain.size() + plain.size() / 16 + 64; // LZF's worst case
  std::vector<char> packed(room);
  const auto plain_size = static_cast<std::uint32_t>(plain.size());
  const std::uint32_t packed_size = pcl::lzfCompress(
      plain.data(), plain_size, packed.data(), static_cast<std::uint32_t>(room));
  if (packed_size == 0)
    throw CIDException(cloud.name + ": the points cannot be compressed");
  const std::array<std::uint32_t, 2> sizes{packed_size, plain_size};
  stream << header(cloud, CloudEncoding::compressed) << "binary_compressed\n";
  writeBytes(stream, sizes.data(), sizeof(sizes));
  writeBytes(stream, packed.data(), packed_size);
}

} // namespace

CloudPieces
pcdPieces()
{
  return {{CloudEncoding::ascii, CloudEncoding::binary}, writeHead, writeRows, {}};
}

void
writePCD(std::ostream& stream, const LabelledCloud& cloud, CloudEncoding encoding)
{
  // The compressed form counts its bytes in 32 bits.
  constexpr std::size_t most_compressible = 3500000000;
  if (encoding == CloudEncoding::compressed &&
      cloud.fields.data.size() <= most_compressible)
    return writeCompressed(stream, cloud);
  const CloudEncoding plain =
      encoding == CloudEncoding::ascii ? CloudEncoding::ascii : CloudEncoding::binary;
  writeHead(stream, cloud, plain);
  writeRows(stream, cloud, plain);
}

} // namespace pcl_cid
