/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_segment as the tests run it.
 */

#pragma once

#include "tool_process.h"

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {

/** \brief Runs of pcl_cid_segment, and what they wrote. */
class SegmentTool : public ToolTest {
protected:
  static std::vector<std::uint32_t>
  labelsIn(const std::string& path)
  {
    return valuesOf<std::uint32_t>(readCloud(path).fields, "label");
  }

  nlohmann::json
  report() const
  {
    return nlohmann::json::parse(readText(file("report.json")));
  }
};

} // namespace pcl_cid::test
