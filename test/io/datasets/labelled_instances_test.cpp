/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Labels and instances that belong together, and those that don't.
 */

#include <pcl_cid/io/labelled_instances.h>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

std::string
complaintOf(const LabelledInstances& scan, std::size_t points)
{
  try {
    requireConsistent(scan, points, "a.pcd");
  }
  catch (const CIDException& error) {
    return error.what();
  }
  return "none";
}

TEST(LabelledInstances, AreTakenInAnyOrderAndWithoutPoints)
{
  EXPECT_EQ(complaintOf({}, 0), "none");
  EXPECT_EQ(complaintOf({{0, 0}, {}}, 2), "none");
  EXPECT_EQ(
      complaintOf(
          {{7, 0, 4294967295}, {{4294967295, "", ""}, {7, "", ""}, {1, "", ""}}}, 3),
      "none");
}

TEST(LabelledInstances, AreRefusedWhenTheyDoNotBelongTogether)
{
  EXPECT_EQ(
      complaintOf({{0}, {}}, 2),
      "a.pcd: has 2 points, but there are labels for 1; there must be one for each");
  EXPECT_EQ(
      complaintOf({{0, 3}, {{2, "chair", ""}}}, 2),
      "a.pcd: point 1 has the label 3, which is of no instance; it must be that of "
      "one, or 0");
  EXPECT_EQ(complaintOf({{2}, {{2, "chair", ""}, {3, "", ""}, {2, "table", ""}}}, 1),
            "a.pcd: two instances have the label 2; each must have its own");
  EXPECT_EQ(
      complaintOf({{0}, {{0, "chair", ""}}}, 1),
      "a.pcd: instance 0 ('chair') has the label 0, which means none; the label of "
      "an instance must be at least 1");
}

} // namespace
} // namespace pcl_cid::test
