/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Superpoints and predictions, as ScanNet's tools read them.
 */

#include <pcl_cid/io/scannet_export.h>

#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace pcl_cid::test {
namespace {

using Labels = std::vector<std::uint32_t>;

Labels
segmentsOf(const pcl::Indices& group)
{
  std::ostringstream stream;
  writeSuperpoints(stream, "scene \xFF \"1\"", group);
  const nlohmann::json json = nlohmann::json::parse(stream.str());
  EXPECT_EQ(json["sceneId"], "scene \xEF\xBF\xBD \"1\"");
  EXPECT_TRUE(json["params"].is_object());
  return json["segIndices"].get<Labels>();
}

TEST(Superpoints, AreTheGroups)
{
  EXPECT_EQ(segmentsOf({0, 2, 1, 1}), (Labels{0, 2, 1, 1}));
  EXPECT_EQ(segmentsOf({}), Labels{});
}

TEST(Superpoints, GiveUngroupedPointsASegmentOfTheirOwn)
{
  EXPECT_EQ(segmentsOf({-1, 2, 0, -1, 1}), (Labels{3, 2, 0, 3, 1}));
  EXPECT_EQ(segmentsOf({-1, -1}), (Labels{0, 0}));
}

TEST(PredictedInstances, HaveTheClassOfTheTrueInstance)
{
  // Instance 4 has two points of class 5 and one of 7; the prediction of it lies on
  // others, which does not matter.
  const auto instances = instancesWithTrueClass(
      {4, 4, 0, 9, 9, 9}, {1, 4, 4, 4, 9, 1}, {3, 5, 7, 5, 6, 3});
  ASSERT_EQ(instances.size(), 2u);
  EXPECT_EQ(instances[0].label, 4u);
  EXPECT_EQ(instances[0].semantic, 5u);
  EXPECT_EQ(instances[0].confidence, 1.0);
  EXPECT_EQ(instances[1].label, 9u);
  EXPECT_EQ(instances[1].semantic, 6u);
}

TEST(PredictedInstances, HaveTheClassThatTheEvaluationGivesTheTruth)
{
  const auto classOf = [](const Labels& true_classes) {
    return instancesWithTrueClass({1, 1, 1, 1}, {1, 1, 1, 1}, true_classes)
        .at(0)
        .semantic;
  };
  EXPECT_EQ(classOf({8, 3, 3, 8}), 3u);
  const std::vector<Labels> some = {
      {8, 3, 3, 8}, {8, 3, 3, 3}, {0, 0, 0, 8}, {0, 0, 8, 8}, {0, 8, 8, 8}};
  for (const Labels& classes : some)
    EXPECT_EQ(
        classOf(classes),
        overlapsOf({{1, 1, 1, 1}, {}}, {{1, 1, 1, 1}, classes}).truths[0].semantic);
  // A label that is nowhere in truth.
  EXPECT_EQ(instancesWithTrueClass({6}, {1}, {3}).at(0).semantic, 0u);
}

TEST(PredictedInstances, NeedOneOfEachForEachPoint)
{
  EXPECT_THROW(instancesWithTrueClass({1}, {1, 1}, {1}), CIDException);
  EXPECT_THROW(instancesWithTrueClass({1}, {1}, {1, 1}), CIDException);
}

/** Layout: http://kaldir.vc.in.tum.de/scannet_benchmark/documentation */
TEST(Predictions, NameMaskClassAndConfidence)
{
  std::ostringstream stream;
  writePredictions(stream, "scene0707_00", {{{7, 33, 10}, 1.0}, {{2, 5, 10}, 0.7234}});
  EXPECT_EQ(stream.str(),
            "pred_mask/scene0707_00_000.txt 33 1\n"
            "pred_mask/scene0707_00_001.txt 5 0.7234\n");
}

TEST(Masks, HaveALineForEachPoint)
{
  std::ostringstream stream;
  writeMask(stream, {3, 0, 4, 3}, 3);
  EXPECT_EQ(stream.str(), "1\n0\n0\n1\n");
}

TEST(Masks, AreKnownByTheirNames)
{
  for (const std::size_t number : {0u, 7u, 999u, 1000u})
    EXPECT_TRUE(isMaskFileName(maskFileName("scene0000_00", number), "scene0000_00"));
  EXPECT_EQ(maskFileName("scene0000_00", 12), "scene0000_00_012.txt");
  for (const char* const other : {"scene0000_01_000.txt",
                                  "scene0000_00_00.txt",
                                  "scene0000_00_0000.txt",
                                  "scene0000_00_000.png",
                                  "scene0000_00_+01.txt",
                                  "scene0000_00.txt",
                                  "scene0000_00_.txt",
                                  ".txt",
                                  ""})
    EXPECT_FALSE(isMaskFileName(other, "scene0000_00")) << other;
}

} // namespace
} // namespace pcl_cid::test
