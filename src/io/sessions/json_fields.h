/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Fields of JSON objects, with sentences about those that are wrong.
 */

#pragma once

#include <pcl_cid/exceptions.h>

#include <limits>
#include <string>
#include <type_traits>

#include <nlohmann/json.hpp>

namespace pcl_cid {

/** \throws CIDException when there is no such field */
inline const nlohmann::json&
field(const nlohmann::json& object, const char* name)
{
  const auto found = object.is_object() ? object.find(name) : object.end();
  if (!object.is_object() || found == object.end())
    throw CIDException("'" + std::string(name) + "' is missing");
  return *found;
}

/** \brief A whole number.
 *  \throws CIDException when it is not one, or out of the range of the type */
template <typename Number>
Number
wholeNumber(const nlohmann::json& value, const char* name)
{
  static_assert(std::is_integral_v<Number> && sizeof(Number) <= 8);
  const bool fits =
      value.is_number_unsigned()
          ? value.get<std::uint64_t>() <=
                static_cast<std::uint64_t>(std::numeric_limits<Number>::max())
          : value.is_number_integer() && std::is_signed_v<Number> &&
                value.get<std::int64_t>() >=
                    static_cast<std::int64_t>(std::numeric_limits<Number>::min());
  if (!fits)
    throw CIDException("'" + std::string(name) + "' is " + value.dump() +
                       "; it must be a whole number up to " +
                       std::to_string(std::numeric_limits<Number>::max()));
  return value.get<Number>();
}

template <typename Number>
Number
wholeNumberIn(const nlohmann::json& object, const char* name)
{
  return wholeNumber<Number>(field(object, name), name);
}

/** \throws CIDException when it is missing or not a text */
inline std::string
textIn(const nlohmann::json& object, const char* name)
{
  const nlohmann::json& value = field(object, name);
  if (!value.is_string())
    throw CIDException("'" + std::string(name) + "' is " + value.dump() +
                       "; it must be a text");
  return value.get<std::string>();
}

} // namespace pcl_cid
