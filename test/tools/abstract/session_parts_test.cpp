/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_abstract --session: the parts that were chosen by hand.
 */

#include "tool_process.h"

#include <pcl_cid/cid_label_propagation.h>
#include <pcl_cid/core/part_session.h>
#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/session_file.h>

#include <algorithm>
#include <filesystem>

#include <nlohmann/json.hpp>

namespace pcl_cid::test {
namespace {

class SessionParts : public ToolTest {
protected:
  /** The default settings, as those of a tool without options. */
  PartSession
  partSession() const
  {
    CIDLabelPropagation<pcl::PointXYZ> parameters;
    parameters.setInputCloud(pointsOf(readCloud(scan_)).points);
    return PartSession(parameters.prepare(), parameters.getGroupingSettings());
  }

  /** Write a session, in which actions on labels may stand between. */
  void
  record(const std::vector<PartAction>& actions) const
  {
    SessionFile file(session_, identityOf(readCloud(scan_)), {});
    file.append(LabelAction{action::Propose{3}});
    for (const PartAction& action : actions)
      file.append(action);
  }

  ToolRun
  runWith(std::vector<std::string> more) const
  {
    more.insert(more.begin(),
                {scan_, file("hulls.ply"), "--session", session_, "--verify"});
    return run("pcl_cid_abstract", more);
  }

  nlohmann::json
  report() const
  {
    return nlohmann::json::parse(readText(file("report.json")));
  }

  std::string session_ = folder_.file("scan.session");
};

TEST_F(SessionParts, OfACutAreThoseThatTheToolFindsItself)
{
  record({part_action::Decompose{24}, part_action::Cut{9}});
  const std::vector<std::string> outputs{
      "--urdf", file("scene.urdf"), "--labels", file("labels.pcd")};
  ASSERT_EQ(runWith(outputs).exit_code, 0);
  const std::string hulls = readText(file("hulls.ply"));
  const std::string labels = readText(file("labels.pcd"));
  const std::string scene = readText(file("scene.urdf"));
  std::vector<std::string> more{"--seeds", "24", "--parts", "9", "--merging", "cid"};
  more.insert(more.end(), outputs.begin(), outputs.end());
  more.insert(more.begin(), {scan_, file("hulls.ply")});
  ASSERT_EQ(run("pcl_cid_abstract", more).exit_code, 0);
  EXPECT_EQ(readText(file("hulls.ply")), hulls);
  EXPECT_EQ(readText(file("labels.pcd")), labels);
  EXPECT_EQ(readText(file("scene.urdf")), scene);
}

TEST_F(SessionParts, AreThoseThatWereChosen)
{
  PartSession session = partSession();
  std::vector<PartAction> actions{part_action::Decompose{24}, part_action::Cut{6}};
  for (const PartAction& action : actions)
    session.apply(action);
  std::vector<ChosenPart> parts = session.parts();
  std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    return a.size > b.size;
  });
  actions.push_back(part_action::Drop{parts[0].number()});
  actions.push_back(part_action::Exact{parts[1].number(), true});
  actions.push_back(part_action::Join{parts[2].number(), parts[3].number()});
  record(actions);
  for (const char* threads : {"1", "3"}) {
    SCOPED_TRACE(threads);
    const ToolRun made = runWith({"--max-vertices",
                                  "8",
                                  "--labels",
                                  file("labels.pcd"),
                                  "--report",
                                  file("report.json"),
                                  "--threads",
                                  threads});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const nlohmann::json written = report()["parts"];
    ASSERT_EQ(written.size(), 4u); // 6 - 1 dropped - 1 joined
    std::size_t joined = 0;
    for (const nlohmann::json& part : written) {
      const bool is_exact = part["points"] == parts[1].size;
      EXPECT_EQ(part["vertices"] > 8, is_exact);
      joined += part["points"] == parts[2].size + parts[3].size ? 1 : 0;
    }
    EXPECT_EQ(joined, 1u);
    const auto labels =
        valuesOf<std::uint32_t>(readCloud(file("labels.pcd")).fields, "label");
    const auto in_no_part = std::count(labels.begin(), labels.end(), 0u);
    const nlohmann::json points = report()["points"];
    EXPECT_EQ(points["dropped"], parts[0].size);
    EXPECT_EQ(in_no_part,
              points["in"].get<std::ptrdiff_t>() - points["finite"].get<int>() +
                  static_cast<std::ptrdiff_t>(parts[0].size));
  }
}

TEST_F(SessionParts, AreThoseOfEachOfSeveralScans)
{
  record({part_action::Decompose{24}, part_action::Cut{6}});
  std::filesystem::copy_file(scan_, file("copy.pcd"));
  std::filesystem::copy_file(session_, file("copy.session"));
  const ToolRun done = run("pcl_cid_abstract",
                           {scan_,
                            file("copy.pcd"),
                            "--output-dir",
                            file("many"),
                            "--mesh-format",
                            "ply",
                            "--session",
                            file("{}.session")});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  ASSERT_EQ(runWith({}).exit_code, 0);
  EXPECT_EQ(readText(file("many/scan.ply")), readText(file("hulls.ply")));
  EXPECT_EQ(readText(file("many/copy.ply")), readText(file("hulls.ply")));
}

TEST_F(SessionParts, ExactHullsAreNotSimplified)
{
  const auto partsWith = [&](const std::vector<std::string>& options) {
    std::vector<std::string> all{"--report", file("report.json")};
    all.insert(all.end(), options.begin(), options.end());
    EXPECT_EQ(runWith(all).exit_code, 0);
    return report()["parts"];
  };
  const std::vector<PartAction> cut{part_action::Decompose{24}, part_action::Cut{16}};
  record(cut);
  const nlohmann::json whole = partsWith({});
  const nlohmann::json simple = partsWith({"--max-vertices", "auto"});
  std::size_t simplified = 0; // a part that is
  while (simplified < whole.size() &&
         simple[simplified]["vertices"] == whole[simplified]["vertices"])
    ++simplified;
  ASSERT_LT(simplified, whole.size()) << "no hull is simplified, exact or not";

  PartSession session = partSession();
  for (const PartAction& action : cut)
    session.apply(action);
  std::filesystem::remove(session_);
  record(
      {cut[0], cut[1], part_action::Exact{session.parts()[simplified].number(), true}});
  const nlohmann::json mixed = partsWith({"--max-vertices", "auto"});
  for (std::size_t k = 0; k < whole.size(); ++k)
    EXPECT_EQ(mixed[k]["vertices"], (k == simplified ? whole : simple)[k]["vertices"]);
}

TEST_F(SessionParts, AreRefusedWhereThereAreNone)
{
  const auto expectError = [&](const std::string& sentence) {
    const ToolRun made = runWith({});
    EXPECT_EQ(made.exit_code, 1);
    EXPECT_NE(made.err.find(sentence), std::string::npos) << made.err;
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"scan.pcd", "scan.session"}));
    std::filesystem::remove(session_);
  };
  record({});
  expectError("there are no parts yet");
  record({part_action::Decompose{4}, part_action::Cut{1}, part_action::Drop{0}});
  expectError("all parts are dropped");
  record({part_action::Decompose{4}, part_action::Drop{17}});
  expectError("scan.session: line 4: there is no part 17");
  record({part_action::Decompose{4}});
  EXPECT_EQ(runWith({"--parts", "3"}).exit_code, 2);
  EXPECT_EQ(runWith({"--normals", "0.1"}).exit_code, 2);
}

} // namespace
} // namespace pcl_cid::test
