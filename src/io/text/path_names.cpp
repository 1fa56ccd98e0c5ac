/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Names of files and folders.
 */

#include "path_names.h"

#include <cctype>
#include <filesystem>

namespace pcl_cid {

namespace fs = std::filesystem;

std::string
lastName(const std::string& path)
{
  const fs::path whole = fs::absolute(path).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

std::string
extensionOf(const std::string& path)
{
  std::string extension = fs::path(path).extension().string();
  for (char& letter : extension)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return extension;
}

std::string
listed(const std::vector<std::string>& words, const std::string& conjunction)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0                 ? ""
             : i + 1 < words.size() ? ", "
                                    : " " + conjunction + " ") +
            words[i];
  return text;
}

} // namespace pcl_cid
