/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Columns of numbers as the fields of a cloud.
 */

#include "point_columns.h"

#include "base/sentence.h"
#include "fields/bulk.h"
#include "fields/field_values.h"
#include "text/numbers.h"
#include "text/path_names.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <utility>

namespace pcl_cid {
namespace {

using Values = std::vector<double>;

/** The fields of a color, in the order of the bytes of a packed one. */
constexpr const char* channels[] = {"blue", "green", "red"};

/** What other programs call the fields that have a meaning here. */
const std::map<std::string, std::string>&
knownColumns()
{
  static const std::map<std::string, std::string> known{{"x", "x"},
                                                        {"y", "y"},
                                                        {"z", "z"},
                                                        {"points:0", "x"},
                                                        {"points:1", "y"},
                                                        {"points:2", "z"},
                                                        {"r", "red"},
                                                        {"g", "green"},
                                                        {"b", "blue"},
                                                        {"red", "red"},
                                                        {"green", "green"},
                                                        {"blue", "blue"},
                                                        {"nx", "normal_x"},
                                                        {"ny", "normal_y"},
                                                        {"nz", "normal_z"},
                                                        {"normals:0", "normal_x"},
                                                        {"normals:1", "normal_y"},
                                                        {"normals:2", "normal_z"},
                                                        {"intensity", "intensity"},
                                                        {"label", "label"}};
  return known;
}

bool
isWhole(const Values& values, double least, double most)
{
  return std::all_of(values.begin(), values.end(), [=](double value) {
    return value >= least && value <= most && std::floor(value) == value;
  });
}

/** What three columns hold, as their values tell. */
enum class Triple { normals, colors, none };

Triple
tripleAt(const PointColumns& columns, std::size_t first)
{
  if (columns.values.size() < first + 3)
    return Triple::none;
  constexpr double tolerance = 0.01;
  bool are_unit = true;
  bool are_bytes = true;
  bool are_shares = true; // of white
  for (std::size_t i = 0; i < columns.values[first].size(); ++i) {
    const Eigen::Vector3d v(columns.values[first][i],
                            columns.values[first + 1][i],
                            columns.values[first + 2][i]);
    are_unit = are_unit && std::abs(v.norm() - 1.0) < tolerance;
    are_shares = are_shares && v.minCoeff() >= 0.0 && v.maxCoeff() <= 1.0;
    are_bytes = are_bytes && v.minCoeff() >= 0.0 && v.maxCoeff() <= 255.0 &&
                v == v.array().floor().matrix();
  }
  return are_unit                  ? Triple::normals
         : are_bytes || are_shares ? Triple::colors
                                   : Triple::none;
}

/** The names of columns that have none, by their order. */
std::vector<std::string>
usualNames(const PointColumns& columns)
{
  std::vector<std::string> names{"x", "y", "z"};
  const auto add = [&](std::initializer_list<const char*> more) {
    names.insert(names.end(), more.begin(), more.end());
  };
  const std::size_t count = columns.values.size();
  if (columns.are_of_pts && count > 3)
    add({"intensity"});
  const Triple triple = tripleAt(columns, names.size());
  if (triple == Triple::colors)
    add({"red", "green", "blue"});
  if (count == names.size() + 3)
    add({"normal_x", "normal_y", "normal_z"});
  else if (names.size() == 3 && (count == 4 || count == 5))
    add({"intensity"});
  while (names.size() < count)
    names.push_back("column_" + std::to_string(names.size() + 1));
  names.resize(count);
  return names;
}

/** Whether the largest error of float is small beside the extent of the values. */
bool
fitsFloat(const Values& values)
{
  double error = 0.0;
  for (const double value : values)
    if (std::isfinite(value))
      error = std::max(
          error, std::abs(value - static_cast<double>(static_cast<float>(value))));
  constexpr double small_share = 1e-6;
  const Bulk bulk = bulkOf(values.size(), [&](std::size_t i) { return values[i]; });
  return error == 0.0 || error <= small_share * bulk.extent;
}

std::uint8_t
realType(const Values& values)
{
  return fitsFloat(values) ? pcl::PCLPointField::FLOAT32 : pcl::PCLPointField::FLOAT64;
}

/** The type of a column whose name says nothing about it. */
std::uint8_t
plainType(const Values& values)
{
  using Signed = std::numeric_limits<std::int32_t>;
  using Unsigned = std::numeric_limits<std::uint32_t>;
  if (isWhole(values, 0.0, Unsigned::max()))
    return pcl::PCLPointField::UINT32;
  if (isWhole(values, Signed::min(), Signed::max()))
    return pcl::PCLPointField::INT32;
  return realType(values);
}

/** Makes fields of columns, one after the other. */
class FieldMaking {
public:
  FieldMaking(const PointColumns& columns, LabelledCloud& cloud)
  : columns_(columns), cloud_(cloud)
  {
  }

  void
  make()
  {
    cloud_.fields.width = columns_.width;
    cloud_.fields.height = columns_.height;
    has_bytes_of_color_ = hasWholeColors(255.0) && !areShares();
    channel_type_ = hasWholeColors(65535.0) && !areShares()
                        ? pcl::PCLPointField::UINT16
                        : pcl::PCLPointField::FLOAT32;
    const std::uint8_t coordinates = coordinateType();
    for (std::size_t k = 0; k < columns_.names.size(); ++k)
      addColumn(k, coordinates);
    cloud_.fields.row_step = cloud_.fields.point_step * cloud_.fields.width;
    cloud_.fields.data.assign(cloud_.size() * cloud_.fields.point_step, 0);
    for (std::size_t k = 0; k < targets_.size(); ++k)
      store(k);
  }

private:
  /** Where the values of a column go. */
  struct Target {
    std::size_t offset = 0;
    std::uint8_t datatype = 0;
  };

  std::size_t
  find(const std::string& name) const
  {
    const auto found = std::find(columns_.names.begin(), columns_.names.end(), name);
    return static_cast<std::size_t>(found - columns_.names.begin());
  }

  /** One type for all three: the widest that one of them needs. */
  std::uint8_t
  coordinateType() const
  {
    for (const char* const axis : {"x", "y", "z"})
      if (!fitsFloat(columns_.values[find(axis)]))
        return pcl::PCLPointField::FLOAT64;
    return pcl::PCLPointField::FLOAT32;
  }

  /** Whether there are all three channels, of whole numbers up to \a most. */
  bool
  hasWholeColors(double most) const
  {
    return std::all_of(std::begin(channels), std::end(channels), [&](const char* name) {
      return find(name) < columns_.names.size() &&
             isWhole(columns_.values[find(name)], 0.0, most);
    });
  }

  /** Whether no channel is above 1, so that 1 is white. */
  bool
  areShares() const
  {
    return std::all_of(std::begin(channels), std::end(channels), [&](const char* name) {
      const Values& values = columns_.values[find(name)];
      return std::none_of(
          values.begin(), values.end(), [](double v) { return v > 1.0; });
    });
  }

  /** \param[in] coordinates the type of x, y and z */
  void
  addColumn(std::size_t k, std::uint8_t coordinates)
  {
    const std::string& name = columns_.names[k];
    const auto channel = std::find(std::begin(channels), std::end(channels), name);
    const bool is_color = channel != std::end(channels);
    if (is_color && has_bytes_of_color_)
      return addByteOfColor(channel - std::begin(channels));
    const bool is_coordinate = name == "x" || name == "y" || name == "z";
    const bool is_real = name == "intensity" || name.rfind("normal_", 0) == 0;
    const std::uint8_t datatype = is_coordinate ? coordinates
                                  : is_real     ? realType(columns_.values[k])
                                  : is_color    ? channel_type_
                                                : plainType(columns_.values[k]);
    targets_.push_back({addField(name, datatype, 1, cloud_.fields).offset, datatype});
  }

  /** \param[in] byte of the packed color, 0 for blue */
  void
  addByteOfColor(std::ptrdiff_t byte)
  {
    if (color_offset_ < 0)
      color_offset_ =
          addField("rgb", pcl::PCLPointField::FLOAT32, 1, cloud_.fields).offset;
    targets_.push_back(
        {static_cast<std::size_t>(color_offset_ + byte), pcl::PCLPointField::UINT8});
  }

  void
  store(std::size_t k)
  {
    std::uint8_t* target = cloud_.fields.data.data() + targets_[k].offset;
    visitType(targets_[k].datatype, [&](auto type) {
      for (const double value : columns_.values[k]) {
        const auto converted = static_cast<decltype(type)>(value);
        std::memcpy(target, &converted, sizeof(converted));
        target += cloud_.fields.point_step;
      }
    });
  }

  const PointColumns& columns_;
  LabelledCloud& cloud_;
  bool has_bytes_of_color_ = false;
  std::uint8_t channel_type_ = 0; ///< of colors that are not bytes
  std::vector<Target> targets_;
  std::int64_t color_offset_ = -1;
};

} // namespace

std::string
fieldNameOf(const std::string& column)
{
  std::string small = column;
  std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  // The unit in brackets: "X [m]", "y(m)".
  const std::size_t bracket = small.find_first_of("[(");
  std::string plain = small.substr(0, bracket);
  plain.erase(plain.find_last_not_of(' ') + 1);
  if (const auto known = knownColumns().find(plain); known != knownColumns().end())
    return known->second;
  std::string name = column;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c <= ' '; }, '_');
  return name;
}

bool
namesCoordinates(const std::vector<std::string>& names)
{
  for (const char* const axis : {"x", "y", "z"})
    if (std::count(names.begin(), names.end(), axis) != 1)
      return false;
  return true;
}

void
setFields(PointColumns columns, LabelledCloud& cloud)
{
  const std::string wanted = "; x, y and z are needed";
  if (columns.values.size() < 3)
    throw CIDException(sentence(
        cloud.name, ": has ", countOf(columns.values.size(), "column"), wanted));
  const bool is_named = !columns.names.empty();
  if (!is_named)
    columns.names = usualNames(columns);
  if (!namesCoordinates(columns.names))
    throw CIDException(sentence(
        cloud.name, ": has the columns ", listed(columns.names, "and"), wanted));
  for (const std::string& name : columns.names)
    if (std::count(columns.names.begin(), columns.names.end(), name) > 1)
      throw CIDException(sentence(
          cloud.name, ": two columns are named '", name, "'; names must differ"));
  if (!is_named)
    cloud.remarks.push_back("its columns have no names; by their order they are " +
                            listed(columns.names, "and"));
  FieldMaking(columns, cloud).make();
}

} // namespace pcl_cid
