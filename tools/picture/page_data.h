/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Data in a page: elements that the browser neither shows nor runs.
 */

#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace pcl_cid::tools {

/** \brief JSON as it stands in a page, so that no text in it can end its element. Names
 *  of files may hold any bytes; what is not UTF-8 is mended. */
std::string
textInPage(const nlohmann::ordered_json& json);

/** \brief JSON as an element.
 *  \param[in] id of the element */
std::string
dataElement(const std::string& id, const nlohmann::ordered_json& json);

/** \brief Bytes as an element, in base64. */
std::string
dataElement(const std::string& id, const std::string& bytes);

/** \brief How many bytes of a page so many bytes take. */
std::size_t
sizeInBase64(std::size_t bytes);

/** \brief Numbers as they lie in memory. */
template <typename Number>
std::string
bytesOf(const std::vector<Number>& numbers)
{
  return {reinterpret_cast<const char*>(numbers.data()),
          numbers.size() * sizeof(Number)};
}

} // namespace pcl_cid::tools
