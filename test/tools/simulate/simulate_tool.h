/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_simulate as a process, on the desk scan with its truth.
 */

#pragma once

#include "tool_process.h"

#include <pcl_cid/io/labelled_cloud.h>

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {

using Arguments = std::vector<std::string>;
using Json = nlohmann::json;

/** \brief Runs of pcl_cid_simulate, and what they wrote. */
class SimulateTool : public ToolTest {
protected:
  SimulateTool()
  {
    LabelledCloud cloud = deskScan();
    setLabels(deskLabels(), LabelType::U4, cloud);
    saveCloud(truth_, cloud, pcd_binary);
  }

  ToolRun
  simulate(const Arguments& arguments) const
  {
    return run("pcl_cid_simulate", arguments);
  }

  /** A run that must succeed; what it wrote. */
  std::string
  writtenBy(Arguments arguments,
            const std::string& option,
            const std::string& name) const
  {
    arguments.insert(arguments.end(), {option, file(name), "--quiet"});
    const ToolRun done = simulate(arguments);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_EQ(done.out, "");
    return readText(file(name));
  }

  Json
  reportOf(const Arguments& arguments) const
  {
    return Json::parse(writtenBy(arguments, "--report", "report.json"));
  }

  /** A run must fail with one line that says so, and leave all files as they are. */
  void
  expectRefused(const Arguments& arguments, const Arguments& complaints, int code) const
  {
    const Arguments before = folder_.names();
    const ToolRun done = simulate(arguments);
    EXPECT_EQ(done.exit_code, code) << done.out << done.err;
    EXPECT_EQ(linesOf(done.err), 1u) << done.err;
    EXPECT_EQ(done.err.rfind("pcl_cid_simulate: ", 0), 0u) << done.err;
    for (const std::string& complaint : complaints)
      EXPECT_NE(done.err.find(complaint), std::string::npos) << done.err;
    EXPECT_EQ(folder_.names(), before);
  }

  std::string truth_ = file("truth.pcd");
};

} // namespace pcl_cid::test
