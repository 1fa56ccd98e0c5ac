/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Clouds from and to files: which format, coordinates, labels, colours.
 */

#include "base/sentence.h"
#include "field_exchange.h"
#include "field_values.h"
#include "pcd_format.h"
#include "ply_format.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>
#include <set>
#include <type_traits>

namespace pcl_cid {
namespace {

bool
isPCDKey(const std::string& word)
{
  for (const char* const key : {"VERSION", "FIELDS", "COLUMNS", "WIDTH"})
    if (word == key)
      return true;
  return word.rfind("#", 0) == 0;
}

/** By the first word of the file: "ply", or a comment or entry of a PCD. */
void
readByContent(std::istream& stream, std::uint64_t size, LabelledCloud& cloud)
{
  char beginning[8] = {};
  stream.get(beginning, sizeof(beginning), '\n');
  stream.clear();
  stream.seekg(0);
  const std::string line = beginning;
  const std::string word = line.substr(0, line.find_first_of(" \t\r"));
  if (word == "ply")
    readPLY(stream, size, cloud);
  else if (isPCDKey(word))
    readPCD(stream, size, cloud);
  else
    throw CIDException(cloud.name + ": is neither a PCD nor a PLY file");
}

std::string
listOfFields(const LabelledCloud& cloud)
{
  std::string names;
  for (const pcl::PCLPointField& field : cloud.fields.fields)
    names += (names.empty() ? "" : ", ") + field.name;
  return names;
}

void
requireDistinctFields(const LabelledCloud& cloud)
{
  std::set<std::string> names;
  for (const pcl::PCLPointField& field : cloud.fields.fields)
    if (!names.insert(field.name).second)
      throw CIDException(sentence(
          cloud.name, ": has two fields named '", field.name, "'; names must differ"));
}

const pcl::PCLPointField&
requireField(const LabelledCloud& cloud, const std::string& name)
{
  const pcl::PCLPointField* const field = findField(cloud.fields, name);
  if (!field)
    throw CIDException(sentence(cloud.name,
                                ": has no field '",
                                name,
                                "'; its fields are ",
                                listOfFields(cloud)));
  if (field->count != 1)
    throw CIDException(sentence(cloud.name,
                                ": field '",
                                name,
                                "' has ",
                                field->count,
                                " values for each point; it must have 1"));
  return *field;
}

const pcl::PCLPointField&
requireCoordinate(const LabelledCloud& cloud, const std::string& name)
{
  const pcl::PCLPointField& field = requireField(cloud, name);
  if (kindOf(field.datatype) != 'F')
    throw CIDException(sentence(cloud.name,
                                ": field '",
                                name,
                                "' has type ",
                                kindOf(field.datatype),
                                sizeOf(field.datatype),
                                "; it must be F4 or F8"));
  return field;
}

/** Coordinates as they stand in the file. */
class CoordinateReading {
public:
  explicit CoordinateReading(const LabelledCloud& cloud)
  : cloud_(cloud)
  , fields_{requireCoordinate(cloud, "x"),
            requireCoordinate(cloud, "y"),
            requireCoordinate(cloud, "z")}
  {
  }

  Eigen::Vector3d
  point(std::size_t i) const
  {
    const std::uint8_t* const bytes =
        cloud_.fields.data.data() + i * cloud_.fields.point_step;
    Eigen::Vector3d p;
    for (int axis = 0; axis < 3; ++axis) {
      const pcl::PCLPointField& field = fields_[axis];
      p[axis] = field.datatype == pcl::PCLPointField::FLOAT32
                    ? static_cast<double>(loadValue<float>(bytes + field.offset))
                    : loadValue<double>(bytes + field.offset);
    }
    return p;
  }

  bool
  areDouble() const
  {
    for (const pcl::PCLPointField& field : fields_)
      if (field.datatype == pcl::PCLPointField::FLOAT64)
        return true;
    return false;
  }

  /** The middle of the cloud, in steps of about its size, so that what remains is as
   *  small as the cloud; 0 when it is near 0 anyway. */
  Eigen::Vector3d
  middle() const
  {
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < cloud_.size(); ++i)
      if (const Eigen::Vector3d p = point(i); p.allFinite())
        box.extend(p);
    if (box.isEmpty())
      return Eigen::Vector3d::Zero();
    const double size = box.sizes().maxCoeff();
    const double step = size > 0.0 ? std::exp2(std::ceil(std::log2(size))) : 1.0;
    return box.center().unaryExpr([step](double centre) {
      return std::abs(centre) < 2.0 * step ? 0.0 : std::round(centre / step) * step;
    });
  }

private:
  const LabelledCloud& cloud_;
  const pcl::PCLPointField fields_[3];
};

constexpr double largest_label = std::numeric_limits<std::uint32_t>::max();

/** \return whether the value is a whole number that a label can be */
template <typename Value>
bool
isLabel(Value value)
{
  if constexpr (std::is_floating_point_v<Value>)
    return value >= 0 && static_cast<double>(value) <= largest_label &&
           std::floor(value) == value;
  else
    return value >= 0 && static_cast<std::uint64_t>(value) <=
                             std::numeric_limits<std::uint32_t>::max();
}

void
requireLabelsFit(const std::vector<std::uint32_t>& labels, LabelType type)
{
  const std::uint32_t largest =
      type == LabelType::U4   ? std::numeric_limits<std::uint32_t>::max()
      : type == LabelType::I4 ? std::numeric_limits<std::int32_t>::max()
                              : 1u << std::numeric_limits<float>::digits;
  for (const std::uint32_t label : labels)
    if (label > largest)
      throw CIDException(sentence("label ",
                                  label,
                                  " does not fit the label type ",
                                  type == LabelType::I4 ? "I4" : "F4",
                                  ", which goes to ",
                                  largest,
                                  "; use U4"));
}

std::uint8_t
datatypeOf(LabelType type)
{
  return type == LabelType::U4   ? pcl::PCLPointField::UINT32
         : type == LabelType::I4 ? pcl::PCLPointField::INT32
                                 : pcl::PCLPointField::FLOAT32;
}

void
storeLabel(std::uint32_t label, LabelType type, std::uint8_t* bytes)
{
  const auto as_float = static_cast<float>(label);
  if (type == LabelType::F4)
    std::memcpy(bytes, &as_float, sizeof(as_float));
  else
    std::memcpy(bytes, &label, sizeof(label));
}

} // namespace

LabelledCloud
readCloud(const std::string& path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::exists(path, error))
    throw CIDException(path + ": there is no such file");
  if (fs::is_directory(path, error))
    throw CIDException(path + ": is a folder; a PCD or PLY file is needed");
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw CIDException(path + ": cannot be opened: " + std::strerror(errno));
  stream.seekg(0, std::ios::end);
  const std::streamoff size = stream.tellg();
  stream.seekg(0);
  if (!stream || size < 0)
    throw CIDException(path + ": cannot be read like a file; a PCD or PLY file is "
                              "needed");
  if (size == 0)
    throw CIDException(path + ": is empty; a PCD or PLY file is needed");

  LabelledCloud cloud;
  cloud.name = path;
  readByContent(stream, static_cast<std::uint64_t>(size), cloud);
  requireDistinctFields(cloud);
  CoordinateReading{cloud};
  return cloud;
}

CloudPoints
pointsOf(const LabelledCloud& cloud)
{
  const CoordinateReading coordinates(cloud);
  CloudPoints result;
  if (coordinates.areDouble())
    result.offset = coordinates.middle();
  result.points.reset(new pcl::PointCloud<pcl::PointXYZ>);
  result.points->reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f p = (coordinates.point(i) - result.offset).cast<float>();
    result.points->emplace_back(p.x(), p.y(), p.z());
    result.finite += p.allFinite() ? 1 : 0;
  }
  result.points->width = cloud.fields.width;
  result.points->height = cloud.fields.height;
  result.points->is_dense = result.finite == cloud.size();
  result.points->sensor_origin_.head<3>() =
      (cloud.sensor_origin.head<3>().cast<double>() - result.offset).cast<float>();
  result.points->sensor_orientation_ = cloud.sensor_orientation;
  return result;
}

bool
hasField(const LabelledCloud& cloud, const std::string& name)
{
  return findField(cloud.fields, name) != nullptr;
}

PointSet
finitePoints(const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  Points points;
  points.reserve(cloud.size());
  for (const pcl::PointXYZ& point : cloud)
    points.emplace_back(point.x, point.y, point.z);
  pcl::Indices source(cloud.size());
  std::iota(source.begin(), source.end(), 0);
  return PointSet(std::move(points), std::move(source));
}

std::vector<std::uint32_t>
labelsOf(const LabelledCloud& cloud,
         const std::string& field,
         const CloudPoints& points)
{
  const pcl::PCLPointField& source = requireField(cloud, field);
  std::vector<std::uint32_t> labels(cloud.size(), 0);
  visitType(source.datatype, [&](auto type) {
    const std::uint8_t* bytes = cloud.fields.data.data() + source.offset;
    for (std::size_t i = 0; i < cloud.size(); ++i, bytes += cloud.fields.point_step) {
      if (!(*points.points)[i].getVector3fMap().allFinite())
        continue;
      const auto value = loadValue<decltype(type)>(bytes);
      if (!isLabel(value))
        throw CIDException(
            sentence(cloud.name,
                     ": field '",
                     field,
                     "' of point ",
                     i,
                     " is ",
                     +value,
                     "; a label must be a whole number, 0 to 4294967295"));
      labels[i] = static_cast<std::uint32_t>(value);
    }
  });
  return labels;
}

std::vector<ColorRGB>
colorsOf(const LabelledCloud& cloud)
{
  const char* const name = findField(cloud.fields, "rgb") ? "rgb" : "rgba";
  if (!findField(cloud.fields, name))
    throw CIDException(cloud.name + ": has no colours, in a field 'rgb' or 'rgba'; " +
                       "its fields are " + listOfFields(cloud));
  const pcl::PCLPointField& field = requireField(cloud, name);
  if (sizeOf(field.datatype) != sizeof(std::uint32_t))
    throw CIDException(sentence(cloud.name,
                                ": field '",
                                name,
                                "' has ",
                                sizeOf(field.datatype),
                                " bytes; colours must have 4"));
  std::vector<ColorRGB> colors;
  colors.reserve(cloud.size());
  const std::uint8_t* bytes = cloud.fields.data.data() + field.offset;
  for (std::size_t i = 0; i < cloud.size(); ++i, bytes += cloud.fields.point_step)
    colors.push_back(unpackColor(loadValue<std::uint32_t>(bytes)));
  return colors;
}

void
setLabels(const std::vector<std::uint32_t>& labels,
          LabelType type,
          LabelledCloud& cloud,
          const std::string& name)
{
  requireOneEach(labels.size(), "labels", cloud);
  requireLabelsFit(labels, type);
  exchangeField(
      name,
      datatypeOf(type),
      [&](std::size_t i, std::uint8_t* bytes) { storeLabel(labels[i], type, bytes); },
      cloud);
}

CloudFormat
formatFor(const std::string& path, CloudFormat source)
{
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& letter : extension)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  const bool ascii =
      source == CloudFormat::pcd_ascii || source == CloudFormat::ply_ascii;
  if (extension == ".ply")
    return ascii ? CloudFormat::ply_ascii : CloudFormat::ply_binary;
  if (extension != ".pcd")
    throw CIDException(path + ": a cloud is written as .pcd or .ply");
  if (ascii)
    return CloudFormat::pcd_ascii;
  return source == CloudFormat::pcd_binary ? CloudFormat::pcd_binary
                                           : CloudFormat::pcd_binary_compressed;
}

void
writeCloud(std::ostream& stream, const LabelledCloud& cloud, CloudFormat format)
{
  if (format == CloudFormat::ply_ascii || format == CloudFormat::ply_binary)
    writePLY(stream, cloud, format);
  else
    writePCD(stream, cloud, format);
}

} // namespace pcl_cid
