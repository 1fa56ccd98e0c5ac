/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What tests of scenes have in common: attributes of XML, and what is in folders.
 */

#pragma once

#include "tool_process.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace pcl_cid::test {

/** \brief Every value of an attribute in an XML text, in order. */
inline std::vector<std::string>
attributes(const std::string& xml, const std::string& name)
{
  const std::string begin = " " + name + "=\"";
  std::vector<std::string> values;
  for (std::size_t at = xml.find(begin); at != std::string::npos;
       at = xml.find(begin, at + 1)) {
    const std::size_t from = at + begin.size();
    values.push_back(xml.substr(from, xml.find('"', from) - from));
  }
  return values;
}

class SceneTest : public ToolTest {
protected:
  /** \brief Names in a folder, sorted. */
  std::vector<std::string>
  namesIn(const std::string& folder) const
  {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(file(folder)))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }
};

} // namespace pcl_cid::test
