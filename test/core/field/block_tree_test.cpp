/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Every point in one block, boxes that hold their points, and exact searches.
 */

#include "field/block_tree.h"

#include "clouds.h"

#include <limits>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

BlockTree
treeOf(const Points& points, int threads = 2)
{
  Progress silent({});
  return BlockTree(points, threads, silent);
}

std::vector<NamedPoints>
smallAndLargeClouds()
{
  std::vector<NamedPoints> clouds = allClouds();
  clouds.push_back({"large", twoBoxes(20011, 121)});
  return clouds;
}

class BlockTreeOfClouds : public testing::TestWithParam<NamedPoints> {};

TEST_P(BlockTreeOfClouds, HoldsEveryPointOnceInSmallBlocks)
{
  const Points& points = GetParam().points;
  const BlockTree tree = treeOf(points);
  std::vector<int> times(points.size(), 0);
  for (std::size_t b = 0; b < tree.size(); ++b) {
    const PointBlock& block = tree.block(b);
    ASSERT_GE(block.count, 1);
    ASSERT_LE(block.count, PointBlock::capacity);
    for (int row = 0; row < PointBlock::capacity; ++row) {
      const auto i = static_cast<std::size_t>(block.index[row]);
      EXPECT_EQ(block.point(row), points[i]);
      times[i] += row < block.count;
      EXPECT_EQ(
          tree.position(static_cast<std::int32_t>(b) * PointBlock::capacity + row),
          points[i]);
    }
  }
  EXPECT_EQ(times, std::vector<int>(points.size(), 1));
}

TEST(BlockTree, HasAsFewBlocksAsPossibleEquallyFilledForEverySize)
{
  for (std::size_t size = 1; size <= 300; ++size) {
    const BlockTree tree = treeOf(randomCube(size, 123));
    ASSERT_EQ(tree.size(),
              (size + PointBlock::capacity - 1) / std::size_t{PointBlock::capacity});
    for (std::size_t b = 0; b < tree.size(); ++b) {
      const auto count = static_cast<std::size_t>(tree.block(b).count);
      EXPECT_GE(count, size / tree.size());
      EXPECT_LE(count, size / tree.size() + 1);
    }
  }
}

TEST(BlockTree, SplitsLongRangesAtTheMedian)
{
  Points points = randomCube(600001, 124); // longer than what is split in one go
  for (Eigen::Vector3f& p : points)
    p.x() *= 3.0f;
  const BlockTree tree = treeOf(points);
  EXPECT_LE(tree.box(2).high.x(), tree.box(3).low.x());
}

TEST_P(BlockTreeOfClouds, BoxesHoldWhatIsBelowThem)
{
  const BlockTree tree = treeOf(GetParam().points);
  for (std::size_t b = 0; b < tree.size(); ++b)
    for (int row = 0; row < tree.block(b).count; ++row)
      for (std::size_t node = tree.nodeOfBlock(b); node > 0; node /= 2) {
        const Eigen::Vector3f p = tree.block(b).point(row);
        const PointBox& box = tree.box(node);
        EXPECT_EQ(box.squaredDistance(padded(p)), 0.0f);
        EXPECT_LE((p - box.center()).norm(), box.radius());
      }
}

TEST_P(BlockTreeOfClouds, SearchesEqualBruteForceToTheBit)
{
  const Points& points = GetParam().points;
  const BlockTree tree = treeOf(points);
  for (const Eigen::Vector3f& u : randomCube(300, 122)) {
    const Eigen::Vector3f x = 5.0f * u - Eigen::Vector3f::Constant(2.0f);
    float nearest = infinity;
    for (std::size_t b = 0; b < tree.size(); ++b)
      nearest = std::min(nearest, tree.block(b).squaredDistances(x).minCoeff());
    BlockTree::Nearest found;
    tree.descend(1, padded(x), found);
    EXPECT_EQ(found.squared_distance, nearest);
    const Eigen::Vector3f d = x - tree.position(found.slot);
    EXPECT_EQ((d.x() * d.x() + d.y() * d.y()) + d.z() * d.z(), nearest);
  }
}

TEST_P(BlockTreeOfClouds, IsTheSameForEveryNumberOfThreads)
{
  const BlockTree serial = treeOf(GetParam().points, 1);
  for (const int threads : {2, 3, 8}) {
    const BlockTree parallel = treeOf(GetParam().points, threads);
    ASSERT_EQ(parallel.size(), serial.size());
    for (std::size_t b = 0; b < serial.size(); ++b)
      EXPECT_TRUE((parallel.block(b).index == serial.block(b).index).all());
  }
}

INSTANTIATE_TEST_SUITE_P(Clouds,
                         BlockTreeOfClouds,
                         testing::ValuesIn(smallAndLargeClouds()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace pcl_cid::test
