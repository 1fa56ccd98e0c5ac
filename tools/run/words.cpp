/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Numbers and lists as the tools print them.
 */

#include "words.h"

#include <cctype>
#include <cstdio>
#include <filesystem>

namespace pcl_cid::tools {
namespace {

std::string
printed(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

} // namespace

std::string
alternatives(const std::vector<std::string>& words)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
  return text;
}

std::string
extensionOf(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& letter : extension)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return extension;
}

std::vector<std::string>
withoutDots(std::vector<std::string> extensions)
{
  for (std::string& extension : extensions)
    extension.erase(0, 1);
  return extensions;
}

std::string
shortNumber(double value)
{
  return printed("%.4g", value);
}

std::string
percent(double share)
{
  return printed("%.2f %%", 100.0 * share);
}

} // namespace pcl_cid::tools
