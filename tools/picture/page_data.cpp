/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Data in a page: elements that the browser neither shows nor runs.
 */

#include "page_data.h"

#include <boost/algorithm/string/replace.hpp>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

namespace pcl_cid::tools {
namespace {

using Json = nlohmann::ordered_json;

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
              "browsers take numbers as they lie in memory");

std::string
element(const std::string& id, const std::string& type, const std::string& content)
{
  return "<script type=\"" + type + "\" id=\"" + id + "\">" + content + "</script>\n";
}

} // namespace

std::string
textInPage(const nlohmann::ordered_json& json)
{
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  // In JSON it stands in strings only, where this is the same.
  boost::replace_all(text, "<", "\\u003c");
  return text;
}

std::string
dataElement(const std::string& id, const nlohmann::ordered_json& json)
{
  return element(id, "application/json", textInPage(json));
}

std::string
dataElement(const std::string& id, const std::string& bytes)
{
  using namespace boost::archive::iterators;
  using Base64 = base64_from_binary<transform_width<const char*, 6, 8>>;
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  const std::string whole = bytes + std::string(padding, '\0'); // it reads threes
  std::string text(Base64(whole.data()), Base64(whole.data() + whole.size()));
  text.replace(text.size() - padding, padding, padding, '=');
  return element(id, "application/octet-stream", text);
}

std::size_t
sizeInBase64(std::size_t bytes)
{
  return (bytes + 2) / 3 * 4;
}

} // namespace pcl_cid::tools
