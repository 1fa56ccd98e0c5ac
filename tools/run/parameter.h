/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A setting as it was used, for the report: name and value by its row in the table.
 */

#pragma once

#include <pcl_cid/core/settings.h>
#include <pcl_cid/io/report.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <variant>

namespace pcl_cid::tools {

/** \brief A number. */
template <typename Value, typename Number>
Report::Parameter
parameter(const NumberSetting<Value>& row, Number value)
{
  static_assert(std::is_arithmetic_v<Number>);
  if constexpr (std::is_same_v<Number, float>)
    return {row.name, asWritten(value)};
  else if constexpr (std::is_floating_point_v<Number>)
    return {row.name, double{value}};
  else if constexpr (std::is_same_v<Number, std::uint64_t>)
    return {row.name, value};
  else
    return {row.name, std::int64_t{value}};
}

/** \brief A number that may have been left out. */
template <typename Value, typename Number>
Report::Parameter
parameter(const NumberSetting<Value>& row, const std::optional<Number>& value)
{
  if (!value)
    return {row.name, std::monostate()};
  return parameter(row, *value);
}

/** \brief One of a few words. */
template <typename Value, std::size_t Count>
Report::Parameter
parameter(const ChoiceSetting<Value, Count>& row, Value value)
{
  return {row.name, std::string(row.wordOf(value))};
}

} // namespace pcl_cid::tools
