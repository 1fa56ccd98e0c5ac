/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The page from a folder, for who works on it.
 */

#include "page_folder.h"

#include "content_type.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

namespace pcl_cid::studio {
namespace {

namespace fs = std::filesystem;

/** Whether a path is made of names: of none that is empty or begins with a dot. */
bool
isPlain(std::string_view path)
{
  return !path.empty() && path.front() == '/' && path.back() != '/' &&
         path.find("//") == std::string_view::npos &&
         path.find("/.") == std::string_view::npos &&
         path.find('\0') == std::string_view::npos;
}

bool
isWithin(const fs::path& file, const fs::path& folder)
{
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
         folder.end();
}

std::optional<std::string>
readFile(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad())
    return std::nullopt;
  return text;
}

} // namespace

PageFolder::PageFolder(const fs::path& folder) : folder_(fs::canonical(folder))
{
  if (!fs::is_directory(folder_))
    throw fs::filesystem_error(
        "", folder, std::make_error_code(std::errc::not_a_directory));
}

std::optional<Resource>
PageFolder::find(std::string_view path) const
{
  if (path == "/")
    path = "/index.html";
  if (!isPlain(path))
    return std::nullopt;
  std::error_code error;
  const fs::path file = fs::canonical(folder_ / path.substr(1), error);
  if (error || !isWithin(file, folder_) || !fs::is_regular_file(file, error))
    return std::nullopt;
  auto text = readFile(file);
  if (!text)
    return std::nullopt;
  return textResource(std::move(*text), contentType(path));
}

} // namespace pcl_cid::studio
