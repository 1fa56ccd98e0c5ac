/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Reports and merge trees as JSON.
 */

#include "cloud_files.h"

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/smooth_patches.h>
#include <pcl_cid/io/report.h>
#include <pcl_cid/version.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

TEST(ReportTest, HoldsWhatWasPutIn)
{
  const CloudPoints points = pointsOf(deskScan());
  SeedProposal proposal;
  proposal.seeds = {3, 100};
  proposal.coverage = {2.0f, 0.5f};
  proposal.group.assign(points.points->size(), 1);
  proposal.group[0] = 0;
  proposal.group[7] = -1;
  Report report;
  report.tool = "a tool";
  report.input = "a \"file\"\xFF.pcd"; // not UTF-8
  report.remarks = {"line 3 is left out"};
  report.parameters = {{"seeds", std::int64_t{2}},
                       {"coverage", std::monostate()},
                       {"radius", 0.25},
                       {"random_seed", std::uint64_t{18446744073709551615u}},
                       {"labels", std::string("seeds.csv")},
                       {"quiet", true}};
  report.seed_labels = {7, 0};
  report.steps = {{"load", 0.5}, {"save", 1.5}};
  describeProposal(proposal, points, report);
  const nlohmann::json json = nlohmann::json::parse(toJson(report));
  EXPECT_EQ(json["tool"], "a tool");
  EXPECT_EQ(json["version"], PCL_CID_VERSION);
  EXPECT_EQ(json["remarks"], (std::vector<std::string>{"line 3 is left out"}));
  EXPECT_EQ(json["parameters"]["seeds"], 2);
  EXPECT_TRUE(json["parameters"]["coverage"].is_null());
  EXPECT_EQ(json["parameters"]["radius"], 0.25);
  EXPECT_EQ(json["parameters"]["random_seed"], 18446744073709551615u);
  EXPECT_EQ(json["parameters"]["quiet"], true);
  EXPECT_EQ(json["points"]["in"], 1200);
  EXPECT_EQ(json["points"]["finite"], points.finite);
  EXPECT_EQ(json["points"]["grouped"], 1199);
  ASSERT_EQ(json["seeds"].size(), 2u);
  EXPECT_EQ(json["seeds"][0]["points"], 1);
  EXPECT_EQ(json["seeds"][1]["points"], 1198);
  EXPECT_EQ(json["seeds"][1]["index"], 100);
  EXPECT_EQ(json["seeds"][1]["label"], 0);
  EXPECT_EQ(json["seeds"][1]["coverage"], 0.5);
  EXPECT_EQ(json["seeds"][0]["position"][0], (*points.points)[3].x);
  EXPECT_EQ(json["seconds"]["save"], 1.5);
  EXPECT_GT(json["peak_memory_bytes"], 1000000);
  EXPECT_FALSE(json.contains("parts"));
  EXPECT_FALSE(json.contains("score"));
  EXPECT_FALSE(json.contains("density"));
}

TEST(ReportTest, HoldsPatchesInThePlaceOfSeeds)
{
  const CloudPoints points = pointsOf(deskScan());
  Report report;
  report.seeds = {3};
  report.coverage = {0.5f};
  report.seed_positions.resize(1);
  RawScan scan;
  pcl::Indices all;
  Points positions;
  for (std::size_t i = 0; i < points.points->size(); ++i)
    if ((*points.points)[i].getVector3fMap().allFinite()) {
      all.push_back(static_cast<pcl::index_t>(i));
      positions.push_back((*points.points)[i].getVector3fMap());
    }
  scan.cloud_size = points.points->size();
  scan.points = PointSet(std::move(positions), std::move(all));
  const SmoothPatches patches(
      std::make_shared<const PreparedScan>(std::move(scan), PreparationSettings()), 4);
  describePatches(patches, points, report);
  const nlohmann::json json = nlohmann::json::parse(toJson(report));
  EXPECT_TRUE(json["seeds"].empty());
  EXPECT_EQ(json["points"]["grouped"], points.finite);
  ASSERT_EQ(json["patches"].size(), patches.numberOfPatches());
  std::vector<std::size_t> sizes(patches.numberOfPatches(), 0);
  for (const pcl::index_t patch : patches.groups())
    if (patch >= 0)
      ++sizes[static_cast<std::size_t>(patch)];
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    EXPECT_EQ(json["patches"][k]["points"], sizes[k]);
    EXPECT_EQ(json["patches"][k]["grown"], patches.grownSizes()[k]);
  }
}

TEST(ReportTest, HoldsWhatWasDecidedAboutTheDensity)
{
  Report report;
  report.density = DensityDecision{true, 2.5f, 17};
  const nlohmann::json json = nlohmann::json::parse(toJson(report))["density"];
  EXPECT_EQ(json["weighted"], true);
  EXPECT_EQ(json["spread"], 2.5);
  EXPECT_EQ(json["isolated_points"], 17);
}

TEST(ReportTest, HoldsTheBlindSpot)
{
  Report report;
  EXPECT_FALSE(nlohmann::json::parse(toJson(report)).contains("blind_spot"));
  report.blind_spot = FilledBlindSpot{{1.0, 2.0, -3.0}, 0.5f, 17};
  const nlohmann::json json = nlohmann::json::parse(toJson(report))["blind_spot"];
  EXPECT_EQ(json["centre"], (std::vector<double>{1.0, 2.0, -3.0}));
  EXPECT_EQ(json["radius"], 0.5);
  EXPECT_EQ(json["points"], 17);
}

TEST(ReportTest, HoldsTheFiguresOfHulls)
{
  ConvexPart part;
  part.indices = {1, 2, 3};
  part.trimmed = {7, 9};
  part.hull.vertices.resize(4);
  part.hull.triangles.resize(4);
  part.volume = 1.5;
  part.area = 2.5;
  part.thickness = 0.005;
  part.thickened = true;
  const std::vector<ConvexPart> parts{part};
  Report report;
  report.parts = &parts;
  const nlohmann::json whole = nlohmann::json::parse(toJson(report));
  EXPECT_FALSE(whole.contains("remarks"));
  const nlohmann::json json = whole["parts"];
  ASSERT_EQ(json.size(), 1u);
  EXPECT_EQ(json[0],
            (nlohmann::json{{"points", 3},
                            {"trimmed", {7, 9}},
                            {"vertices", 4},
                            {"triangles", 4},
                            {"volume", 1.5},
                            {"area", 2.5},
                            {"thickness", 0.005},
                            {"thickened", true},
                            {"boxed", false}}));
}

TEST(ReportTest, HoldsMergeTrees)
{
  const MergeTree tree({5, 3, 2}, {{0, 2, 0.25, 7}, {0, 1, 1.5, 10}});
  const nlohmann::json json = nlohmann::json::parse(toJson(tree));
  EXPECT_EQ(json["group_sizes"], (std::vector<int>{5, 3, 2}));
  ASSERT_EQ(json["steps"].size(), 2u);
  EXPECT_EQ(json["steps"][0]["first"], 0);
  EXPECT_EQ(json["steps"][0]["second"], 2);
  EXPECT_EQ(json["steps"][0]["height"], 0.25);
  EXPECT_EQ(json["steps"][1]["size"], 10);
}

TEST(LabelScoreTest, CountsFinitePointsAndThoseWithATrueLabel)
{
  const CloudPoints points = pointsOf(deskScan());
  std::vector<std::uint32_t> truth = deskLabels();
  std::vector<std::uint32_t> labels(truth.size(), 2);
  std::size_t twos = 0;
  for (const std::uint32_t label : truth)
    twos += label == 2 ? 1 : 0;
  const LabelScore score = scoreLabels("truth", labels, truth, points);
  EXPECT_EQ(score.points, points.finite);
  EXPECT_EQ(score.right, twos);
  EXPECT_EQ(score.labelled_points, points.finite);
  EXPECT_DOUBLE_EQ(score.share(),
                   static_cast<double>(twos) / static_cast<double>(points.finite));

  for (std::uint32_t& label : truth)
    label = label == 1 ? 0 : label;
  const LabelScore other = scoreLabels("truth", labels, truth, points);
  EXPECT_LT(other.labelled_points, points.finite);
  EXPECT_EQ(other.right_labelled, twos);
  EXPECT_GT(other.shareOfLabelled(), other.share());
  EXPECT_EQ(LabelScore().share(), 0.0);
}

} // namespace
} // namespace pcl_cid::test
