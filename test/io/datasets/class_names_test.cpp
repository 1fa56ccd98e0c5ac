/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The class tables agree with the sample scan, with ScanNet's benchmark, and with
 * themselves.
 */

#include "room_scene.h"

#include <pcl_cid/io/class_names.h>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

TEST(ClassNames, OfS3DISAreThoseOfTheSampleScan)
{
  const std::vector<std::string>& names = roomClassNames(); // with "none"
  ASSERT_EQ(s3disClasses().size() + 1, names.size());
  for (std::size_t i = 1; i < names.size(); ++i)
    EXPECT_EQ(classNumber(s3disClasses(), names[i]), i) << names[i];
}

TEST(ClassNames, AreFoundByNumberAndByName)
{
  for (const SemanticClasses* const classes : {&s3disClasses(),
                                               &nyu40Classes(),
                                               &scannetBenchmarkClasses(),
                                               &semanticKittiClasses()}) {
    std::uint32_t last = 0;
    for (const SemanticClass& each : *classes) {
      EXPECT_GT(each.number, last);
      EXPECT_EQ(classNumber(*classes, each.name), each.number);
      EXPECT_EQ(className(*classes, each.number), each.name);
      last = each.number;
    }
    EXPECT_FALSE(className(*classes, 0));
    EXPECT_FALSE(className(*classes, last + 1));
    EXPECT_FALSE(classNumber(*classes, "stairs"));
  }
}

/** Numbers and names as the benchmark's page lists them. */
TEST(ClassNames, OfScanNetAreThoseOfItsBenchmark)
{
  const std::vector<std::pair<std::uint32_t, std::string>> benchmark{
      {3, "cabinet"},
      {4, "bed"},
      {5, "chair"},
      {6, "sofa"},
      {7, "table"},
      {8, "door"},
      {9, "window"},
      {10, "bookshelf"},
      {11, "picture"},
      {12, "counter"},
      {14, "desk"},
      {16, "curtain"},
      {24, "refrigerator"},
      {28, "shower curtain"},
      {33, "toilet"},
      {34, "sink"},
      {36, "bathtub"},
      {39, "otherfurniture"}};
  ASSERT_EQ(scannetBenchmarkClasses().size(), benchmark.size());
  for (std::size_t i = 0; i < benchmark.size(); ++i) {
    EXPECT_EQ(scannetBenchmarkClasses()[i].number, benchmark[i].first);
    EXPECT_EQ(scannetBenchmarkClasses()[i].name, benchmark[i].second);
  }
  EXPECT_EQ(nyu40Classes().size(), 40u);
  EXPECT_EQ(classNumber(nyu40Classes(), "wall"), 1u);
  EXPECT_EQ(classNumber(nyu40Classes(), "floor"), 2u);
}

TEST(ClassNames, OfSemanticKittiAreThoseOfItsTools)
{
  const SemanticClasses& classes = semanticKittiClasses();
  EXPECT_EQ(classes.size(), 33u);
  for (const auto& [number, name] : SemanticClasses{{1, "outlier"},
                                                    {10, "car"},
                                                    {30, "person"},
                                                    {40, "road"},
                                                    {50, "building"},
                                                    {99, "other-object"},
                                                    {252, "moving-car"},
                                                    {259, "moving-other-vehicle"}})
    EXPECT_EQ(classNumber(classes, name), number);
}

} // namespace
} // namespace pcl_cid::test
