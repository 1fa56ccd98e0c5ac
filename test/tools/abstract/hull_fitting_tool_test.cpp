/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * pcl_cid_abstract --merging hull: options, report, and the bound in --verify.
 */

#include "abstract/error_verification.h"
#include "tool_process.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace pcl_cid::test {
namespace {

class HullFittingTool : public ToolTest {
protected:
  nlohmann::json
  reportOf(const std::vector<std::string>& options) const
  {
    std::vector<std::string> all = {scan_,
                                    file("hulls.obj"),
                                    "--merging",
                                    "hull",
                                    "--verify",
                                    "--report",
                                    file("report.json")};
    all.insert(all.end(), options.begin(), options.end());
    abstract(all);
    return nlohmann::json::parse(readText(file("report.json")));
  }
};

TEST_F(HullFittingTool, MakesSoManyPartsAndSaysWhatTheyRefuse)
{
  const nlohmann::json report = reportOf({"--parts", "6", "--robot-radius", "0.1"});
  EXPECT_EQ(report["parts"].size(), 6u);
  EXPECT_EQ(report["parameters"]["merging"], "hull");
  EXPECT_EQ(report["parameters"]["robot_radius"], 0.1);
  EXPECT_LE(report["places"]["refused"], report["places"]["free"]);
  std::size_t points = 0;
  for (const nlohmann::json& part : report["parts"])
    points += part["points"].get<std::size_t>();
  EXPECT_EQ(points, report["points"]["finite"]);
}

TEST_F(HullFittingTool, KeepsTheBoundAndVerifiesIt)
{
  const nlohmann::json tight = reportOf({"--max-error", "0.3", "--subsample", "150"});
  const nlohmann::json loose = reportOf({"--max-error", "1", "--subsample", "150"});
  EXPECT_GT(tight["parts"].size(), loose["parts"].size());
  EXPECT_EQ(tight["parameters"]["max_error"], 0.3);
}

TEST_F(HullFittingTool, IsTheDefaultWhereNothingIsAboutGroups)
{
  const auto ruleOf = [&](const std::vector<std::string>& options) {
    std::vector<std::string> all = {
        scan_, file("hulls.obj"), "--report", file("report.json")};
    all.insert(all.end(), options.begin(), options.end());
    const ToolRun ran = run("pcl_cid_abstract", all);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return nlohmann::json::parse(readText(file("report.json")))["parameters"]["merging"]
        .get<std::string>();
  };
  EXPECT_EQ(ruleOf({"--parts", "4"}), "hull");
  EXPECT_EQ(ruleOf({"--max-error", "2", "--viewpoints", "cloud"}), "hull");
  EXPECT_EQ(ruleOf({}), "cid");
  EXPECT_EQ(ruleOf({"--parts", "4", "--merging", "cid"}), "cid");
  EXPECT_EQ(ruleOf({"--threshold", "0.1"}), "cid");
  EXPECT_EQ(ruleOf({"--parts", "4", "--seeds", "12"}), "cid");
  EXPECT_EQ(ruleOf({"--parts", "4", "--tree", file("tree.json")}), "cid");
}

TEST_F(HullFittingTool, TheBoundComesBeforeTheNumberOfParts)
{
  const nlohmann::json report =
      reportOf({"--max-error", "0.3", "--parts", "1", "--subsample", "150"});
  EXPECT_GT(report["parts"].size(), 1u);
  ASSERT_EQ(report["remarks"].size(), 1u);
  const std::string remark = report["remarks"][0];
  for (const std::string& part : std::vector<std::string>{
           "0.3 m", std::to_string(report["parts"].size()), "says 1"})
    EXPECT_NE(remark.find(part), std::string::npos) << remark;

  const auto names = folder_.names();
  const ToolRun strict = run("pcl_cid_abstract",
                             {scan_,
                              file("no.obj"),
                              "--max-error",
                              "0.3",
                              "--parts",
                              "1",
                              "--subsample",
                              "150",
                              "--strict"});
  EXPECT_EQ(strict.exit_code, 1);
  EXPECT_NE(strict.err.find("--strict"), std::string::npos) << strict.err;
  EXPECT_EQ(folder_.names(), names);
  EXPECT_EQ(run("pcl_cid_abstract", {scan_, file("no.obj"), "--strict"}).exit_code, 2);
}

TEST_F(HullFittingTool, TakesViewpoints)
{
  writeText(file("viewpoints.json"), "[[0, 0, 1]]");
  const nlohmann::json all = reportOf({"--parts", "4"});
  const nlohmann::json seen =
      reportOf({"--parts", "4", "--viewpoints", file("viewpoints.json")});
  EXPECT_LE(seen["places"]["free"], all["places"]["free"]);
  reportOf({"--parts", "4", "--viewpoints", "cloud"});
}

TEST_F(HullFittingTool, NeverWritesOverTheViewpoints)
{
  const std::string viewpoints = file("viewpoints.json");
  writeText(viewpoints, "[[0, 0, 1]]");
  const ToolRun ran = run("pcl_cid_abstract",
                          {scan_,
                           file("hulls.obj"),
                           "--merging",
                           "hull",
                           "--parts",
                           "3",
                           "--viewpoints",
                           viewpoints,
                           "--report",
                           viewpoints});
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_EQ(readText(viewpoints), "[[0, 0, 1]]");
}

TEST_F(HullFittingTool, RefusesOptionsThatDoNotGoTogether)
{
  const std::vector<std::vector<std::string>> refused = {
      {"--merging", "hull"},
      {"--robot-radius", "0.1"},
      {"--viewpoints", "cloud"},
      {"--merging", "cid", "--parts", "3", "--max-error", "0.1"},
      {"--merging", "cid", "--parts", "3", "--robot-radius", "0.1"},
      {"--seeds", "12", "--parts", "3", "--viewpoints", "cloud"},
      {"--merging", "hull", "--parts", "3", "--seeds", "12"},
      {"--merging", "hull", "--threshold", "0.1"},
      {"--merging", "hull", "--max-error", "0.1", "--merges", "3"},
      {"--merging", "hull", "--parts", "3", "--tree", "tree.json"},
      {"--merging", "hull", "--parts", "3", "--curve", "curve.csv"},
      {"--merging", "hull", "--max-error", "0"},
      {"--merging", "hull", "--parts", "3", "--robot-radius", "-1"},
      {"--merging", "volume", "--parts", "3"}};
  for (const std::vector<std::string>& options : refused) {
    std::vector<std::string> all = {scan_, file("hulls.obj")};
    all.insert(all.end(), options.begin(), options.end());
    EXPECT_EQ(run("pcl_cid_abstract", all).exit_code, 2)
        << options.front() << " ... " << options.back();
  }
}

/** A wall of points, one a centimetre, at x = 0. */
CloudPoints
wallOfPoints()
{
  CloudPoints wall;
  wall.points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (int y = -50; y <= 50; ++y)
    for (int z = -50; z <= 50; ++z)
      wall.points->emplace_back(
          0.0f, 0.01f * static_cast<float>(y), 0.01f * static_cast<float>(z));
  return wall;
}

/** A box before the wall, from x = 0 to here. */
TriangleMesh
boxBeforeWall(double depth)
{
  TriangleMesh box;
  for (int k = 0; k < 8; ++k)
    box.vertices.emplace_back((k & 1) != 0 ? depth : 0.0,
                              (k & 2) != 0 ? 0.2 : -0.2,
                              (k & 4) != 0 ? 0.2 : -0.2);
  box.triangles = {{{0, 2, 1}},
                   {{1, 2, 3}},
                   {{4, 5, 6}},
                   {{5, 7, 6}},
                   {{0, 1, 4}},
                   {{1, 5, 4}},
                   {{2, 6, 3}},
                   {{3, 6, 7}},
                   {{0, 4, 2}},
                   {{2, 4, 6}},
                   {{1, 3, 5}},
                   {{3, 7, 5}}};
  return box;
}

TEST(ErrorVerification, FindsWhatIsFartherThanTheBound)
{
  const CloudPoints wall = wallOfPoints();
  const tools::ErrorVerification verification(wall, 0.1, {});
  EXPECT_FALSE(verification.findTooFar(boxBeforeWall(0.09)));
  EXPECT_TRUE(verification.findTooFar(boxBeforeWall(0.12)));
}

TEST(ErrorVerification, WhatNobodySawIsNoError)
{
  const CloudPoints wall = wallOfPoints();
  const tools::ErrorVerification before(wall, 0.1, {{2.0, 0.0, 0.0}});
  EXPECT_FALSE(before.findTooFar(boxBeforeWall(0.13))); // less than 4/3 of the bound
  EXPECT_TRUE(before.findTooFar(boxBeforeWall(0.3)));
  const tools::ErrorVerification behind(wall, 0.1, {{-2.0, 0.0, 0.0}});
  EXPECT_FALSE(behind.findTooFar(boxBeforeWall(0.3)));
}

} // namespace
} // namespace pcl_cid::test
