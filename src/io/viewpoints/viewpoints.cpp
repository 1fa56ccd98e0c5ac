/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Where the sensors of a scan stood: positions as JSON or as a table of text.
 */

#include "base/sentence.h"
#include "text/delimited_text.h"
#include "text/file_reading.h"
#include "text/json_reading.h"
#include "text/numbers.h"

#include <pcl_cid/exceptions.h>
#include <pcl_cid/io/viewpoints.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace pcl_cid {
namespace {

using Positions = std::vector<Eigen::Vector3d>;

constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};

constexpr const char* what_a_coordinate_is = "it must be a number, -1e15 to 1e15";

/** Whether a coordinate is finite and as near as those of a scan must be. */
bool
isWithinReach(double coordinate)
{
  constexpr double farthest = 1e15;
  return std::abs(coordinate) <= farthest;
}

/** Positions as a program writes them. */
class JsonPositions {
public:
  explicit JsonPositions(const std::string& path) : json_(path) {}

  Positions
  all() const
  {
    const auto [name, list] = namedList();
    Positions positions;
    for (std::size_t i = 0; i < list.size(); ++i)
      positions.push_back(position(list[i], name + "[" + std::to_string(i) + "]"));
    return positions;
  }

private:
  using Json = nlohmann::json;

  /** The positions, and what messages call them. */
  struct NamedList {
    std::string name;
    const Json& list;
  };

  NamedList
  namedList() const
  {
    const Json& root = json_.root();
    if (root.is_array())
      return {"viewpoints", root};
    for (const char* const key : {"sensor_positions", "viewpoints"})
      if (root.count(key) != 0)
        return {key, json_.array(root, "", key)};
    json_.fail("",
               "has no member 'sensor_positions' and no member 'viewpoints'; one of "
               "them must be an array of positions");
  }

  Eigen::Vector3d
  position(const Json& value, const std::string& where) const
  {
    if (value.is_object() && value.count("position") != 0)
      return coordinates(value["position"], where + ".position");
    return coordinates(value, where);
  }

  Eigen::Vector3d
  coordinates(const Json& value, const std::string& where) const
  {
    const std::string shape = "it must be [x, y, z] or {\"x\": x, \"y\": y, \"z\": z}";
    if (!value.is_array() && !value.is_object())
      json_.fail(where, "is no position; " + shape);
    if (value.is_array() && value.size() != axis_names.size())
      json_.fail(where, "has " + countOf(value.size(), "value") + "; " + shape);
    Eigen::Vector3d position;
    for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
      const std::string name = axis_names[axis];
      const Json& coordinate =
          value.is_array() ? value[axis] : json_.member(value, where, name);
      if (!coordinate.is_number() || !isWithinReach(coordinate.get<double>()))
        json_.fail(where,
                   "has no usable coordinate " + name + "; " + what_a_coordinate_is);
      position[static_cast<Eigen::Index>(axis)] = coordinate.get<double>();
    }
    return position;
  }

  JsonReading json_;
};

/** Positions as a spreadsheet writes them. */
class TextPositions {
public:
  TextPositions(const std::string& text, const std::string& path)
  : path_(path), table_(readTextTable(text, path))
  {
  }

  Positions
  all() const
  {
    if (table_.rows.empty())
      return {};
    const std::optional<Columns> named = columnsOf(table_.rows.front());
    if (!named)
      requireThreeValues();
    const Columns columns = named.value_or(Columns{0, 1, 2});
    Positions positions;
    for (auto row = table_.rows.begin() + (named ? 1 : 0); row != table_.rows.end();
         ++row)
      positions.push_back(position(*row, columns));
    return positions;
  }

private:
  /** Where x, y and z stand in a row. */
  using Columns = std::array<std::size_t, 3>;

  template <typename... Parts>
  [[noreturn]] void
  fail(const TextRow& row, const Parts&... parts) const
  {
    throw CIDException(sentence(path_, ": line ", row.line, ": ", parts...));
  }

  /** \return none when the row is no header */
  static std::optional<Columns>
  columnsOf(const TextRow& row)
  {
    Columns columns{};
    for (std::size_t axis = 0; axis < columns.size(); ++axis) {
      const auto found =
          std::find(row.cells.begin(), row.cells.end(), axis_names[axis]);
      if (found == row.cells.end())
        return std::nullopt;
      columns[axis] = static_cast<std::size_t>(found - row.cells.begin());
    }
    return columns;
  }

  /** Without a header nobody knows which three of more are meant. */
  void
  requireThreeValues() const
  {
    for (const TextRow& row : table_.rows)
      if (row.cells.size() != axis_names.size())
        fail(row,
             "has ",
             countOf(row.cells.size(), "value"),
             "; it must have three: x, y and z, separated by commas, semicolons or "
             "tabs, or a header must name the columns x, y and z");
  }

  Eigen::Vector3d
  position(const TextRow& row, const Columns& columns) const
  {
    Eigen::Vector3d position;
    for (std::size_t axis = 0; axis < columns.size(); ++axis) {
      const std::string cell =
          columns[axis] < row.cells.size() ? row.cells[columns[axis]] : "";
      const auto value = table_.number<double>(cell);
      if (!value || !isWithinReach(*value))
        fail(row,
             "the ",
             axis_names[axis],
             " is '",
             cell.substr(0, 32),
             "'; ",
             what_a_coordinate_is);
      position[static_cast<Eigen::Index>(axis)] = *value;
    }
    return position;
  }

  std::string path_;
  TextTable table_;
};

/** Whether a text begins as JSON with positions does, and no table. */
bool
beginsAsJson(std::string_view text)
{
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.substr(0, byte_order_mark.size()) == byte_order_mark)
    text.remove_prefix(byte_order_mark.size());
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && (text[begin] == '[' || text[begin] == '{');
}

} // namespace

std::vector<Eigen::Vector3d>
readViewpoints(const std::string& path)
{
  const std::string text = textOf(path);
  Positions positions =
      beginsAsJson(text) ? JsonPositions(path).all() : TextPositions(text, path).all();
  if (positions.empty())
    throw CIDException(path + ": holds no position of a sensor; at least 1 is needed");
  return positions;
}

} // namespace pcl_cid
