/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_evaluate as the tests run it.
 */

#pragma once

#include "tool_process.h"

#include <algorithm>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {

/** \brief Runs of pcl_cid_evaluate on small scans that are written here. */
class EvaluateTool : public ToolTest {
protected:
  using Arguments = std::vector<std::string>;

  /** Write points on a line, with fields: one row of values for each point. */
  void
  writeScan(const std::string& name,
            const std::string& fields,
            const std::vector<std::string>& rows) const
  {
    const auto columns = std::count(fields.begin(), fields.end(), ' ') + 1;
    std::string sizes;
    std::string types;
    for (long column = 0; column < columns; ++column) {
      sizes += " 4";
      types += " U";
    }
    std::string text = "FIELDS x y z " + fields + "\nSIZE 4 4 4" + sizes +
                       "\nTYPE F F F" + types + "\nPOINTS " +
                       std::to_string(rows.size()) + "\nDATA ascii\n";
    for (std::size_t i = 0; i < rows.size(); ++i)
      text += std::to_string(i) + " 0.5 -2 " + rows[i] + "\n";
    writeText(file(name), text);
  }

  /** A truth of two chairs (1: 4 points, 2: 2 points) and a table (3: 2 points), and
   *  labels of seeds on chair 1 and the table. */
  void
  writeChairsAndTable(const std::string& prediction, const std::string& truth) const
  {
    writeScan(truth,
              "label semantic",
              {"1 9", "1 9", "1 9", "1 9", "2 9", "2 9", "3 8", "3 8"});
    writeScan(prediction, "label", {"1", "1", "1", "3", "1", "1", "3", "3"});
  }

  ToolRun
  evaluate(const Arguments& arguments) const
  {
    return run("pcl_cid_evaluate", arguments);
  }

  /** A run that must succeed; its report. */
  nlohmann::json
  reportOf(Arguments arguments) const
  {
    arguments.insert(arguments.end(), {"--report", file("report.json")});
    const ToolRun done = evaluate(arguments);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_EQ(done.err, "");
    return nlohmann::json::parse(readText(file("report.json")));
  }

  static nlohmann::json
  classIn(const nlohmann::json& report, const std::string& name)
  {
    for (const nlohmann::json& row : report["classes"])
      if (row["name"] == name)
        return row;
    return nullptr;
  }

  /** A run must fail with one line that says so, and leave all files as they are. */
  void
  expectRefused(const Arguments& arguments, const Arguments& complaints, int code = 1)
  {
    const Arguments before = folder_.names();
    const ToolRun done = evaluate(arguments);
    EXPECT_EQ(done.exit_code, code) << done.out << done.err;
    EXPECT_EQ(linesOf(done.err), 1u) << done.err;
    EXPECT_EQ(done.err.rfind("pcl_cid_evaluate: ", 0), 0u) << done.err;
    for (const std::string& complaint : complaints)
      EXPECT_NE(done.err.find(complaint), std::string::npos) << done.err;
    EXPECT_EQ(folder_.names(), before);
  }
};

} // namespace pcl_cid::test
