/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds from and to files, in every format of one table.
 */

#include "base/sentence.h"
#include "columns/column_formats.h"
#include "fields/field_values.h"
#include "fields/required_fields.h"
#include "file_format.h"
#include "foreign_formats.h"
#include "pcd/pcd_format.h"
#include "ply/ply_format.h"
#include "text/format_table.h"
#include "text/numbers.h"
#include "text/opened_file.h"

#include <pcl_cid/io/cloud_formats.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <utility>

namespace pcl_cid {
namespace {

/** A new format is one more row here. */
FormatTable<CloudFormat>&
formatTable()
{
  static FormatTable<CloudFormat> table{
      pcdFormat(), plyFormat(), npyFormat(), textFormat(), lidarFormat()};
  return table;
}

bool
hasEncoding(const CloudFormat& format, CloudEncoding encoding)
{
  const auto& known = format.encodings;
  return std::find(known.begin(), known.end(), encoding) != known.end();
}

/** "is neither a PCD nor a PLY file". */
std::string
noneOfAll()
{
  std::vector<std::string> names;
  for (const std::string& name : readableCloudNames())
    names.push_back("a " + name);
  return "is neither " + listed(names, "nor") + " file";
}

void
rewind(std::istream& stream)
{
  stream.clear();
  stream.seekg(0);
}

const CloudFormat&
givenFormat(const std::string& extension, const std::string& path)
{
  const CloudFormat* const format = findCloudFormat("file" + extension);
  if (!format || !format->read)
    throw CIDException(path + ": " + neededFile() + ", not one with the extension " +
                       extension);
  return *format;
}

} // namespace

const CloudFormat&
formatOf(const OpenedFile& file, const std::string& path, const std::string& given)
{
  if (!given.empty())
    return givenFormat(given, path);
  std::istream& stream = *file.stream;
  const std::string extension = extensionOf(file.name);
  const auto isOfThis = [&](const CloudFormat& format) {
    rewind(stream);
    return format.read && (format.recognizes ? format.recognizes(stream)
                                             : hasExtension(format, extension));
  };
  const CloudFormat* const format = formatTable().find(isOfThis);
  rewind(stream);
  if (format)
    return *format;
  refuseForeignFormat(stream, path);
  throw CIDException(path + ": " + noneOfAll() +
                     " by its content and its name; say which it is (--input-format)");
}

void
requireWhole(const LabelledCloud& cloud, std::size_t points)
{
  std::size_t bytes = 0;
  for (const pcl::PCLPointField& field : cloud.fields.fields)
    bytes += field.count * sizeOf(field.datatype);
  if (cloud.size() == 0)
    throw CIDException(cloud.name + ": holds no points; at least 1 is needed");
  if (bytes != cloud.fields.point_step || cloud.fields.data.size() != bytes * points)
    throw CIDException(sentence(cloud.name,
                                ": was read as ",
                                countOf(cloud.size(), "point"),
                                " of ",
                                cloud.fields.point_step,
                                " bytes each, but its fields have ",
                                bytes,
                                " bytes, and all data ",
                                cloud.fields.data.size()));
  requireDistinctFields(cloud);
  requireCoordinates(cloud);
}

namespace {

/** Names that every format can hold, and that can be told apart. */
void
requireNames(const LabelledCloud& cloud)
{
  for (const pcl::PCLPointField& field : cloud.fields.fields)
    if (field.name.empty() || field.name == padding_name ||
        std::any_of(field.name.begin(), field.name.end(), [](unsigned char c) {
          return c <= ' ' || c == 0x7F;
        }))
      throw CIDException(
          sentence(cloud.name,
                   ": a field is named '",
                   field.name,
                   "'; to be written, a name must not be empty or '_', and "
                   "must have no blanks"));
  requireDistinctFields(cloud);
}

void
requireHolds(const CloudFormat& format,
             const LabelledCloud& cloud,
             const RemarkCallback& remark)
{
  requireNames(cloud);
  if (format.check)
    format.check(cloud, [&](const std::string& sentence) {
      if (remark)
        remark(sentence);
    });
}

/** \param[in] source the layout that the cloud came in */
const CloudFormat&
writableFormat(const std::string& path, const CloudLayout& source)
{
  if (path == standard_stream) {
    const CloudFormat* const same = formatTable().named(source.format);
    return same && same->write ? *same : *formatTable().named("PCD");
  }
  const CloudFormat* const format = findCloudFormat(path);
  if (!format || !format->write)
    throw CIDException(path + ": a cloud is written as " +
                       listed(writableCloudExtensions()));
  return *format;
}

} // namespace

void
mendPose(LabelledCloud& cloud)
{
  const float norm = cloud.sensor_orientation.norm();
  if (cloud.sensor_origin.allFinite() && norm > 0.0f && std::isfinite(norm))
    return;
  cloud.sensor_origin.setZero();
  cloud.sensor_orientation.setIdentity();
  cloud.remarks.push_back(
      "its viewpoint is no pose; it is taken for (0, 0, 0), not turned");
}

std::string
neededFile()
{
  return "a " + listed(readableCloudNames()) + " file is needed";
}

LabelledCloud
readCloud(const std::string& path, const std::string& extension)
{
  const OpenedFile file = openFile(path, neededFile());
  LabelledCloud cloud;
  cloud.name = path;
  formatOf(file, path, extension).read(*file.stream, file.size, cloud);
  requireWhole(cloud, cloud.size());
  mendPose(cloud);
  return cloud;
}

CloudLayout
layoutFor(const std::string& path, const CloudLayout& source)
{
  const CloudFormat& format = writableFormat(path, source);
  const bool keeps =
      source.format == format.name || source.encoding == CloudEncoding::ascii;
  return {format.name,
          keeps && hasEncoding(format, source.encoding) ? source.encoding
                                                        : format.encodings.back()};
}

void
requireWritable(const LabelledCloud& cloud,
                const std::string& path,
                const RemarkCallback& remark)
{
  requireHolds(writableFormat(path, cloud.layout), cloud, remark);
}

void
writeCloud(std::ostream& stream, const LabelledCloud& cloud, const CloudLayout& layout)
{
  const CloudFormat* const format = formatTable().named(layout.format);
  if (!format || !format->write || !hasEncoding(*format, layout.encoding))
    throw CIDException(cloud.name + ": cannot be written as " + layout.format +
                       " in the encoding that is asked for; choose another layout");
  requireHolds(*format, cloud, {});
  format->write(stream, cloud, layout.encoding);
}

std::vector<CloudFormat>
cloudFormats()
{
  return formatTable().all();
}

const CloudFormat*
findCloudFormat(const std::string& path)
{
  return formatTable().forFile(withoutGzip(path));
}

std::vector<std::string>
readableCloudNames()
{
  std::vector<std::string> names;
  for (const CloudFormat& format : cloudFormats())
    if (format.read)
      names.push_back(format.name);
  return names;
}

std::vector<std::string>
writableCloudExtensions()
{
  std::vector<std::string> extensions;
  for (const CloudFormat& format : cloudFormats())
    if (format.write)
      extensions.insert(
          extensions.end(), format.extensions.begin(), format.extensions.end());
  return extensions;
}

void
registerCloudFormat(CloudFormat format)
{
  if (!format.read && !format.write)
    throw CIDException("the format " + format.name + " must be read or written");
  if (format.write && format.encodings.empty())
    throw CIDException("the format " + format.name +
                       " is written, so it must have an encoding");
  formatTable().add(std::move(format));
}

} // namespace pcl_cid
