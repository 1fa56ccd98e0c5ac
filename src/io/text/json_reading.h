/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Members of a JSON file, with messages that say where.
 */

#pragma once

#include "base/sentence.h"
#include "file_reading.h"

#include <pcl_cid/exceptions.h>

#include <cstdint>
#include <limits>
#include <string>

#include <nlohmann/json.hpp>

namespace pcl_cid {

/** \brief A JSON file, which must have the shape that its reader expects. */
class JsonReading {
public:
  explicit JsonReading(const std::string& path) : path_(path)
  {
    const std::string text = textOf(path);
    try {
      root_ = nlohmann::json::parse(text, requireShallow);
    }
    catch (const nlohmann::json::parse_error& error) {
      throw CIDException(
          sentence(path, ": offset ", error.byte - 1, ": is no valid JSON"));
    }
    catch (const CIDException& error) {
      throw CIDException(path + ": " + error.what());
    }
    catch (const nlohmann::json::exception& error) {
      throw CIDException(path + ": is no JSON that can be read: " + error.what());
    }
  }

  const nlohmann::json&
  root() const
  {
    return root_;
  }

  /** \brief A member of an object.
   *  \param[in] where the object stands, for messages: "segGroups[3]", empty for the
   *  file itself */
  const nlohmann::json&
  member(const nlohmann::json& object,
         const std::string& where,
         const std::string& key) const
  {
    if (!object.is_object() || object.count(key) == 0)
      fail(where, "has no member '" + key + "'");
    return object[key];
  }

  const nlohmann::json&
  array(const nlohmann::json& object,
        const std::string& where,
        const std::string& key) const
  {
    const nlohmann::json& value = member(object, where, key);
    if (!value.is_array())
      fail(inside(where, key), "is " + shown(value) + "; it must be an array");
    return value;
  }

  std::string
  text(const nlohmann::json& object,
       const std::string& where,
       const std::string& key) const
  {
    const nlohmann::json& value = member(object, where, key);
    if (!value.is_string())
      fail(inside(where, key), "is " + shown(value) + "; it must be a text");
    return value.get<std::string>();
  }

  /** \param[in] where the number itself stands
   *  \return less than the largest of its type */
  std::uint32_t
  wholeNumber(const nlohmann::json& value, const std::string& where) const
  {
    constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max() - 1;
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > most)
      fail(where,
           sentence("is ", shown(value), "; it must be a whole number, 0 to ", most));
    return value.get<std::uint32_t>();
  }

  [[noreturn]] void
  fail(const std::string& where, const std::string& reason) const
  {
    throw CIDException(path_ + ": " + where + (where.empty() ? "" : " ") + reason);
  }

private:
  /** Deep ones are no scans, and what walks through them calls itself as deep. */
  static bool
  requireShallow(int depth, nlohmann::json::parse_event_t, const nlohmann::json&)
  {
    constexpr int deepest = 64;
    if (depth > deepest)
      throw CIDException(
          sentence("is no JSON that can be read: it is nested more than ",
                   deepest,
                   " levels deep"));
    return true;
  }

  static std::string
  inside(const std::string& where, const std::string& key)
  {
    return where.empty() ? key : where + "." + key;
  }

  static std::string
  shown(const nlohmann::json& value)
  {
    constexpr std::size_t most = 32;
    return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)
        .substr(0, most);
  }

  std::string path_;
  nlohmann::json root_;
};

} // namespace pcl_cid
