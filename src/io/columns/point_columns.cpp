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

std::uint8_t
realType(const ColumnSurvey& survey, std::size_t column)
{
  return survey.fitsFloat(column) ? pcl::PCLPointField::FLOAT32
                                  : pcl::PCLPointField::FLOAT64;
}

/** The type of a column whose name says nothing about it. */
std::uint8_t
plainType(const ColumnSurvey& survey, std::size_t column)
{
  using Signed = std::numeric_limits<std::int32_t>;
  using Unsigned = std::numeric_limits<std::uint32_t>;
  if (survey.isWhole(column, 0.0, Unsigned::max()))
    return pcl::PCLPointField::UINT32;
  if (survey.isWhole(column, Signed::min(), Signed::max()))
    return pcl::PCLPointField::INT32;
  return realType(survey, column);
}

/** Makes fields of columns, one after the other. */
class FieldMaking {
public:
  FieldMaking(const std::vector<std::string>& names,
              const ColumnSurvey& survey,
              LabelledCloud& cloud)
  : names_(names), survey_(survey), cloud_(cloud)
  {
  }

  std::vector<ColumnTarget>
  make()
  {
    has_bytes_of_color_ = hasWholeColors(255.0) && !areShares();
    channel_type_ = hasWholeColors(65535.0) && !areShares()
                        ? pcl::PCLPointField::UINT16
                        : pcl::PCLPointField::FLOAT32;
    const std::uint8_t coordinates = coordinateType();
    for (std::size_t k = 0; k < names_.size(); ++k)
      addColumn(k, coordinates);
    return std::move(targets_);
  }

private:
  std::size_t
  find(const std::string& name) const
  {
    const auto found = std::find(names_.begin(), names_.end(), name);
    return static_cast<std::size_t>(found - names_.begin());
  }

  /** One type for all three: the widest that one of them needs. */
  std::uint8_t
  coordinateType() const
  {
    for (const char* const axis : {"x", "y", "z"})
      if (!survey_.fitsFloat(find(axis)))
        return pcl::PCLPointField::FLOAT64;
    return pcl::PCLPointField::FLOAT32;
  }

  /** Whether there are all three channels, of whole numbers up to \a most. */
  bool
  hasWholeColors(double most) const
  {
    return std::all_of(std::begin(channels), std::end(channels), [&](const char* name) {
      return find(name) < names_.size() && survey_.isWhole(find(name), 0.0, most);
    });
  }

  /** Whether no channel is above 1, so that 1 is white. */
  bool
  areShares() const
  {
    return std::none_of(
        std::begin(channels), std::end(channels), [&](const char* name) {
          return survey_.isAboveOne(find(name));
        });
  }

  /** \param[in] coordinates the type of x, y and z */
  void
  addColumn(std::size_t k, std::uint8_t coordinates)
  {
    const std::string& name = names_[k];
    const auto channel = std::find(std::begin(channels), std::end(channels), name);
    const bool is_color = channel != std::end(channels);
    if (is_color && has_bytes_of_color_)
      return addByteOfColor(channel - std::begin(channels));
    const bool is_coordinate = name == "x" || name == "y" || name == "z";
    const bool is_real = name == "intensity" || name.rfind("normal_", 0) == 0;
    const std::uint8_t datatype = is_coordinate ? coordinates
                                  : is_real     ? realType(survey_, k)
                                  : is_color    ? channel_type_
                                                : plainType(survey_, k);
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

  const std::vector<std::string>& names_;
  const ColumnSurvey& survey_;
  LabelledCloud& cloud_;
  bool has_bytes_of_color_ = false;
  std::uint8_t channel_type_ = 0; ///< of colors that are not bytes
  std::vector<ColumnTarget> targets_;
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

ColumnSurvey::ColumnSurvey(std::size_t columns, bool are_of_pts, std::size_t points)
: columns_(columns)
, has_intensity_(are_of_pts && columns > 3)
, triple_(has_intensity_ ? 4 : 3)
, stride_(strideOfSample(points))
{
}

void
ColumnSurvey::Column::take(double value, bool is_sampled)
{
  are_whole = are_whole && std::floor(value) == value;
  least = value < least ? value : least;
  most = value > most ? value : most;
  if (!std::isfinite(value))
    return;
  const double error = std::abs(value - static_cast<double>(static_cast<float>(value)));
  float_error = std::max(float_error, error);
  if (is_sampled)
    sample.push_back(value);
}

void
ColumnSurvey::takeTriple(const Eigen::Vector3d& values)
{
  constexpr double tolerance = 0.01;
  are_unit_ = are_unit_ && std::abs(values.norm() - 1.0) < tolerance;
  are_shares_ = are_shares_ && values.minCoeff() >= 0.0 && values.maxCoeff() <= 1.0;
  are_bytes_ = are_bytes_ && values.minCoeff() >= 0.0 && values.maxCoeff() <= 255.0 &&
               values == values.array().floor().matrix();
}

bool
ColumnSurvey::isWhole(std::size_t column, double least, double most) const
{
  const Column& values = columns_[column];
  return values.are_whole && values.least >= least && values.most <= most;
}

bool
ColumnSurvey::isAboveOne(std::size_t column) const
{
  return columns_[column].most > 1.0;
}

bool
ColumnSurvey::fitsFloat(std::size_t column) const
{
  constexpr double small_share = 1e-6;
  const Column& values = columns_[column];
  return values.float_error == 0.0 ||
         values.float_error <= small_share * bulkOfSample(values.sample).extent;
}

std::vector<std::string>
ColumnSurvey::usualNames() const
{
  std::vector<std::string> names{"x", "y", "z"};
  const auto add = [&](std::initializer_list<const char*> more) {
    names.insert(names.end(), more.begin(), more.end());
  };
  const std::size_t count = columns_.size();
  if (has_intensity_)
    add({"intensity"});
  const bool are_normals = are_unit_;
  if (triple_ + 3 <= count && !are_normals && (are_bytes_ || are_shares_))
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

std::vector<ColumnTarget>
defineFields(std::vector<std::string> names,
             const ColumnSurvey& survey,
             LabelledCloud& cloud)
{
  const std::string wanted = "; x, y and z are needed";
  if (survey.columns() < 3)
    throw CIDException(
        sentence(cloud.name, ": has ", countOf(survey.columns(), "column"), wanted));
  const bool is_named = !names.empty();
  if (!is_named)
    names = survey.usualNames();
  if (!namesCoordinates(names))
    throw CIDException(
        sentence(cloud.name, ": has the columns ", listed(names, "and"), wanted));
  for (const std::string& name : names)
    if (std::count(names.begin(), names.end(), name) > 1)
      throw CIDException(sentence(
          cloud.name, ": two columns are named '", name, "'; names must differ"));
  if (!is_named)
    cloud.remarks.push_back("its columns have no names; by their order they are " +
                            listed(names, "and"));
  return FieldMaking(names, survey, cloud).make();
}

void
storeColumn(const ColumnTarget& target,
            const double* values,
            std::size_t step,
            std::size_t count,
            const LabelledCloud& cloud,
            std::uint8_t* points)
{
  visitType(target.datatype, [&](auto type) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto converted = static_cast<decltype(type)>(values[i * step]);
      std::memcpy(points + i * cloud.fields.point_step + target.offset,
                  &converted,
                  sizeof(converted));
    }
  });
}

void
setFields(const PointColumns& columns, LabelledCloud& cloud)
{
  cloud.fields.width = columns.width;
  cloud.fields.height = columns.height;
  ColumnSurvey survey(columns.values.size(), columns.are_of_pts, cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    survey.take([&](std::size_t k) { return columns.values[k][i]; });
  const std::vector<ColumnTarget> targets = defineFields(columns.names, survey, cloud);
  cloud.fields.row_step = cloud.fields.point_step * cloud.fields.width;
  cloud.fields.data.assign(cloud.size() * cloud.fields.point_step, 0);
  for (std::size_t k = 0; k < targets.size(); ++k)
    storeColumn(targets[k],
                columns.values[k].data(),
                1,
                cloud.size(),
                cloud,
                cloud.fields.data.data());
}

} // namespace pcl_cid
