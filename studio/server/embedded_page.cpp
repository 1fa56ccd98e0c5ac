/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The page in the program itself.
 */

#include "embedded_page.h"

#include "content_type.h"

#include <algorithm>

namespace pcl_cid::studio {

std::optional<Resource>
EmbeddedPage::find(std::string_view path) const
{
  if (path == "/")
    path = "/index.html";
  const EmbeddedFile* const file = std::find_if(
      begin_, end_, [&](const EmbeddedFile& one) { return one.path == path; });
  if (file == end_)
    return std::nullopt;
  const auto size = static_cast<std::size_t>(file->end - file->begin);
  return Resource{contentType(path), file->is_gzip, {file->begin, size}, nullptr};
}

} // namespace pcl_cid::studio
