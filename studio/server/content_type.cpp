/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which kind of file a name says it is.
 */

#include "content_type.h"

namespace pcl_cid::studio {
namespace {

struct Row {
  std::string_view extension;
  const char* type;
};

constexpr Row rows[] = {
    {".css", "text/css; charset=utf-8"},
    {".html", "text/html; charset=utf-8"},
    {".ico", "image/x-icon"},
    {".js", "text/javascript; charset=utf-8"},
    {".json", "application/json"},
    {".map", "application/json"},
    {".png", "image/png"},
    {".svg", "image/svg+xml"},
    {".txt", "text/plain; charset=utf-8"},
    {".woff2", "font/woff2"},
};

} // namespace

std::string
contentType(std::string_view path)
{
  const std::size_t dot = path.find_last_of("./");
  const auto extension = path.substr(dot == std::string_view::npos ? path.size() : dot);
  for (const Row& row : rows)
    if (row.extension == extension)
      return row.type;
  return "application/octet-stream";
}

} // namespace pcl_cid::studio
