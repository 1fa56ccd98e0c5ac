/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_segment --session: the labels that the session had.
 */

#include "random_actions.h"
#include "segment_tool.h"

#include <pcl_cid/cid_label_propagation.h>
#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/session_file.h>

#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {
namespace {

class SessionLabels : public SegmentTool {
protected:
  /** A session with settings of its own, on the desk scan. */
  void
  SetUp() override
  {
    SessionSettings settings;
    settings.preparation.normals = 0.05f;
    settings.preparation.density = DensityWeight::off;
    settings.grouping.samples = 40;
    CIDLabelPropagation<pcl::PointXYZ> parameters;
    parameters.setNormalWeight(0.05f);
    parameters.setDensityWeight(DensityWeight::off);
    parameters.setNumberOfSamples(40);
    parameters.setInputCloud(pointsOf(readCloud(scan_)).points);
    const PreparedScan::ConstPtr prepared = parameters.prepare();
    LabelSession session(prepared, parameters.getGroupingSettings());
    SessionFile file(session_, identityOf(readCloud(scan_)), settings);
    for (const LabelAction& action : doRandomActions(300, 3, session))
      file.append(action);
    labels_ = session.labels();
    cleaned_ = session.cleanedLabels();
  }

  ToolRun
  replay(std::vector<std::string> more, const std::string& output = "out.pcd") const
  {
    more.insert(more.begin(), {scan_, file(output), "--session", session_});
    return run("pcl_cid_segment", more);
  }

  std::string session_ = folder_.file("scan.session");
  std::vector<std::uint32_t> labels_;
  std::vector<std::uint32_t> cleaned_;
};

TEST_F(SessionLabels, AreThoseThatTheSessionHad)
{
  for (const char* threads : {"1", "3"}) {
    const ToolRun replayed = replay({"--threads", threads});
    ASSERT_EQ(replayed.exit_code, 0) << replayed.err;
    EXPECT_EQ(labelsIn(file("out.pcd")), labels_);
  }
  ASSERT_EQ(replay({"--clean-up", "on", "--report", file("r.json")}).exit_code, 0);
  EXPECT_EQ(labelsIn(file("out.pcd")), cleaned_);
  const auto report = nlohmann::json::parse(readText(file("r.json")));
  EXPECT_EQ(report.at("parameters").at("normals"), 0.05);
  EXPECT_EQ(report.at("parameters").at("session"), session_);
}

TEST_F(SessionLabels, AreThoseOfEachOfSeveralScans)
{
  std::filesystem::copy_file(scan_, file("copy.pcd"));
  std::filesystem::copy_file(session_, file("copy.session"));
  const ToolRun done = run("pcl_cid_segment",
                           {scan_,
                            file("copy.pcd"),
                            "--output-dir",
                            file("many"),
                            "--session",
                            file("{}.session")});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(labelsIn(file("many/scan.pcd")), labels_);
  EXPECT_EQ(labelsIn(file("many/copy.pcd")), labels_);
}

TEST_F(SessionLabels, AreRefusedWhereTheyDoNotBelong)
{
  const std::string before = readText(session_);
  const ToolRun option = replay({"--normals", "0.1"});
  EXPECT_EQ(option.exit_code, 2);
  EXPECT_NE(option.err.find("--session and --normals exclude each other"),
            std::string::npos);
  const ToolRun over = replay({}, "scan.session");
  EXPECT_EQ(over.exit_code, 2) << "OUTPUT must be a cloud";

  LabelledCloud other = readCloud(scan_);
  other.fields.data[other.fields.fields[0].offset] ^= 1; // the last bit of the first x
  const std::string changed = file("changed.pcd");
  std::ofstream stream(changed, std::ios::binary);
  writeCloud(stream, other, other.layout);
  stream.close();
  const ToolRun foreign =
      run("pcl_cid_segment", {changed, file("out.pcd"), "--session", session_});
  EXPECT_EQ(foreign.exit_code, 1);
  EXPECT_NE(foreign.err.find("other coordinates"), std::string::npos) << foreign.err;
  const ToolRun missing =
      run("pcl_cid_segment", {scan_, file("out.pcd"), "--session", file("no.session")});
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_NE(missing.err.find("there is no session"), std::string::npos) << missing.err;
  EXPECT_EQ(readText(session_), before);
}

} // namespace
} // namespace pcl_cid::test
