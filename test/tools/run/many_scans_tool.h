/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Several scans in one call, and each of them in a call of its own.
 */

#pragma once

#include "tool_process.h"

#include <filesystem>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {

/** \brief Three scans, and a folder each for what one call makes of them and for what
 *  three calls do. */
class ManyScansTest : public ToolTest {
protected:
  using Arguments = std::vector<std::string>;

  ManyScansTest()
  {
    for (const char* const folder : {"scans", "many", "single"})
      std::filesystem::create_directory(file(folder));
    LabelledCloud desk = deskScan();
    saveCloud(file("scans/a.pcd"), desk, pcd_compressed);
    saveCloud(file("scans/b.ply"), threeShelves(0.25), ply_binary);
    saveCloud(file("scans/c.pcd"), threeShelves(0.375), pcd_ascii);
  }

  static LabelledCloud
  threeShelves(float height)
  {
    std::vector<float> coordinates[3];
    for (int i = 0; i < 600; ++i) {
      coordinates[0].push_back(static_cast<float>(i % 20) / 16.0f);
      coordinates[1].push_back(static_cast<float>(i / 20 % 10) / 16.0f);
      coordinates[2].push_back(height * static_cast<float>(i / 200));
    }
    LabelledCloud cloud;
    appendField("x", coordinates[0], cloud.fields);
    appendField("y", coordinates[1], cloud.fields);
    appendField("z", coordinates[2], cloud.fields);
    return cloud;
  }

  /** The scans, in the folder of many outputs. */
  Arguments
  allScans(const Arguments& options) const
  {
    Arguments arguments{file("scans/a.pcd"),
                        file("scans/b.ply"),
                        file("scans/c.pcd"),
                        "--output-dir",
                        file("many"),
                        "--seeds",
                        "7"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return arguments;
  }

  ToolRun
  runAll(const std::string& tool, const Arguments& options) const
  {
    return run(tool, allScans(options));
  }

  /** All files below a folder by their names in it. Reports are without what no two
   *  runs have in common: seconds, memory. */
  std::map<std::string, std::string>
  filesBelow(const std::string& folder) const
  {
    std::map<std::string, std::string> files;
    for (const std::filesystem::directory_entry& entry :
         std::filesystem::recursive_directory_iterator(file(folder))) {
      if (entry.is_directory())
        continue;
      std::string text = readText(entry.path());
      if (entry.path().string().find("_report.json") != std::string::npos) {
        nlohmann::json json = nlohmann::json::parse(text);
        json.erase("seconds");
        json.erase("peak_memory_bytes");
        text = json.dump();
      }
      // Where a report names an output, it may.
      text = std::regex_replace(text, std::regex(file(folder)), "FOLDER");
      files[std::filesystem::relative(entry.path(), file(folder))] = text;
    }
    return files;
  }

  void
  expectSameFiles() const
  {
    const auto many = filesBelow("many");
    const auto single = filesBelow("single");
    for (const auto& [name, text] : single) {
      ASSERT_EQ(many.count(name), 1u) << name;
      EXPECT_TRUE(many.at(name) == text) << name;
    }
    EXPECT_EQ(many.size(), single.size());
  }

  /** Each scan in a call of its own.
   *  \param[in] extension of the outputs; empty: that of the scan */
  void
  runEach(const std::string& tool,
          const std::string& extension,
          const Arguments& options) const
  {
    for (const std::filesystem::path scan :
         {"scans/a.pcd", "scans/b.ply", "scans/c.pcd"}) {
      const std::string name = scan.stem();
      const std::string own = scan.extension();
      Arguments arguments{
          file(scan),
          file("single/" + name + (extension.empty() ? own : extension)),
          "--seeds",
          "7"};
      for (const std::string& option : options)
        arguments.push_back(
            std::regex_replace(std::regex_replace(option, std::regex("\\{\\}"), name),
                               std::regex("/many"),
                               "/single"));
      const ToolRun done = run(tool, arguments);
      ASSERT_EQ(done.exit_code, 0) << done.err;
    }
  }

  void
  expectRefused(const ToolRun& done, int exit_code, const Arguments& complaints) const
  {
    EXPECT_EQ(done.exit_code, exit_code) << done.err;
    EXPECT_EQ(done.out, "");
    EXPECT_EQ(linesOf(done.err), 1u) << done.err;
    for (const std::string& complaint : complaints)
      EXPECT_NE(done.err.find(complaint), std::string::npos) << done.err;
    EXPECT_TRUE(std::filesystem::is_empty(file("many")));
  }

  /** A summary as Python reads it, as JSON. */
  nlohmann::json
  readByPython(const std::string& path) const
  {
    const bool is_json = path.find(".json") != std::string::npos;
    const std::string script =
        is_json ? "import json, sys; print(json.dumps(json.load(open(sys.argv[1]))"
                  "['scans']))"
                : "import csv, json, sys; print(json.dumps(list(csv.DictReader("
                  "open(sys.argv[1], newline=''), strict=True))))";
    const ToolRun read = run("/usr/bin/python3", {"-c", script, path});
    EXPECT_EQ(read.exit_code, 0) << read.err;
    return nlohmann::json::parse(read.out);
  }
};

} // namespace pcl_cid::test
