/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Fields of what a page says.
 */

#pragma once

#include <pcl_cid/exceptions.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace pcl_cid::studio {

/** \throws CIDException when it is missing or no whole number of 32 bits */
inline std::uint32_t
numberIn(const nlohmann::json& header, const char* name)
{
  const auto found = header.find(name);
  if (found == header.end() || !found->is_number_unsigned() ||
      found->get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
    throw CIDException("'" + std::string(name) +
                       "' must be a whole number, 0 to 4294967295");
  return found->get<std::uint32_t>();
}

/** \brief Nothing where it is null or missing. */
inline std::optional<std::uint32_t>
optionalNumberIn(const nlohmann::json& header, const char* name)
{
  const auto found = header.find(name);
  if (found == header.end() || found->is_null())
    return std::nullopt;
  return numberIn(header, name);
}

/** \throws CIDException when it is missing or no text */
inline std::string
textIn(const nlohmann::json& header, const char* name)
{
  const auto found = header.find(name);
  if (found == header.end() || !found->is_string())
    throw CIDException("'" + std::string(name) + "' must be a text");
  return found->get<std::string>();
}

/** \brief The same with a value for where it is missing. */
inline std::string
textIn(const nlohmann::json& header, const char* name, const char* otherwise)
{
  return header.contains(name) ? textIn(header, name) : otherwise;
}

/** \throws CIDException when it is neither true nor false */
inline bool
truthIn(const nlohmann::json& header, const char* name)
{
  const auto found = header.find(name);
  if (found == header.end() || !found->is_boolean())
    throw CIDException("'" + std::string(name) + "' must be true or false");
  return found->get<bool>();
}

/** \throws CIDException when it is missing or no list */
inline const nlohmann::json&
listIn(const nlohmann::json& header, const char* name)
{
  const auto found = header.find(name);
  if (found == header.end() || !found->is_array())
    throw CIDException("'" + std::string(name) + "' must be a list");
  return *found;
}

} // namespace pcl_cid::studio
