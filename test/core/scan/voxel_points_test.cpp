/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One point of each voxel, and which of them each point follows: equal to brute force.
 */

#include <pcl_cid/core/voxel_points.h>
#include <pcl_cid/exceptions.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using Block = VoxelPoints::Block;
using WideVector = Eigen::Matrix<long double, 3, 1>;

constexpr double nan_of_voxels = std::numeric_limits<double>::quiet_NaN();

struct VoxelCase {
  std::string name;
  Block points;
  double size;
};

Eigen::Vector3d
uniformIn(std::mt19937_64& random, const Eigen::Vector3d& sizes)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  return {sizes.x() * unit(random), sizes.y() * unit(random), sizes.z() * unit(random)};
}

Block
uniformPoints(std::size_t count, const Eigen::Vector3d& sizes, unsigned int seed)
{
  std::mt19937_64 random(seed);
  Block points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(uniformIn(random, sizes));
  return points;
}

/** All but one point of each voxel in one corner of it, so that the nearest chosen one
 * is often in another voxel, and now and then two voxels away. */
Block
pointsInCorners(std::size_t count, unsigned int seed)
{
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<int> voxel(0, 3);
  std::uniform_int_distribution<int> one_of(0, 19);
  Block points;
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Vector3d p(voxel(random), voxel(random), voxel(random));
    p += one_of(random) == 0 ? Eigen::Vector3d::Constant(0.999)
                             : uniformIn(random, Eigen::Vector3d::Constant(0.02));
    points.push_back(p);
  }
  return points;
}

Block
moved(Block points, const Eigen::Vector3d& by)
{
  for (Eigen::Vector3d& p : points)
    p += by;
  return points;
}

/** Points on a lattice that voxels divide evenly: all in their corners and at equal
 *  distances. */
Block
latticePoints(double step)
{
  Block points;
  for (int x = -6; x < 6; ++x)
    for (int y = -6; y < 6; ++y)
      for (int z = 0; z < 4; ++z)
        points.emplace_back(step * x, step * y, step * z);
  return points;
}

Block
withDuplicatesAndInvalid(Block points)
{
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; i += 3)
    points.push_back(points[i]);
  for (std::size_t i = 0; i < points.size(); i += 7)
    points[i][static_cast<int>(i % 3)] =
        i % 2 == 0 ? nan_of_voxels : std::numeric_limits<double>::infinity();
  return points;
}

std::vector<VoxelCase>
voxelCases()
{
  const Eigen::Vector3d utm(356789.123, 5812345.678, 87.5);
  return {
      {"random", uniformPoints(3000, {1, 2, 0.5}, 1), 0.11},
      {"plane", uniformPoints(3000, {3, 3, 0}, 2), 0.2},
      {"line", uniformPoints(500, {5, 0, 0}, 3), 0.13},
      {"corners", pointsInCorners(3000, 4), 1.0},
      {"one voxel", uniformPoints(500, {1, 1, 1}, 5), 7.0},
      {"one point", {{-0.3, 2.0, 9.0}}, 0.1},
      {"every point a voxel", uniformPoints(700, {10, 10, 10}, 6), 0.01},
      {"UTM", moved(pointsInCorners(2000, 7), utm), 0.5},
      {"huge", moved(uniformPoints(900, {1e13, 1e13, 1e13}, 8), {1e14, 0, 0}), 1e12},
      {"tiny", uniformPoints(900, {1e-9, 1e-9, 1e-9}, 9), 2e-10},
      {"lattice", latticePoints(0.25), 0.5},
      {"lattice of tenths", latticePoints(0.1), 0.2},
      {"around zero",
       moved(uniformPoints(2000, {1, 1, 1}, 10), {-0.5, -0.5, -0.5}),
       0.2},
      {"invalid", withDuplicatesAndInvalid(uniformPoints(1500, {1, 1, 1}, 11)), 0.25},
      {"nothing finite", Block(20, Eigen::Vector3d::Constant(nan_of_voxels)), 0.1}};
}

/** Call take for consecutive blocks of a size. */
template <typename Take>
void
inBlocks(const Block& points, std::size_t size, const Take& take)
{
  for (std::size_t i = 0; i < points.size(); i += size)
    take(Block(points.begin() + static_cast<std::ptrdiff_t>(i),
               points.begin() +
                   static_cast<std::ptrdiff_t>(std::min(i + size, points.size()))));
}

struct Thinned {
  pcl::Indices source;
  pcl::Indices numbers; ///< of the voxels, as finish() gives them
  pcl::Indices follows;
  /** For each voxel number the last point that choose() said is the best. */
  std::map<pcl::index_t, pcl::index_t> best;
};

Thinned
thinned(const VoxelCase& voxel_case, std::size_t block, unsigned int threads)
{
  Thinned result;
  VoxelPoints voxels(voxel_case.size, threads);
  inBlocks(voxel_case.points, block, [&](const Block& b) { voxels.add(b); });
  pcl::index_t shown = 0;
  inBlocks(voxel_case.points, block, [&](const Block& b) {
    for (const pcl::index_t number : voxels.choose(b)) {
      if (number >= 0)
        result.best[number] = shown;
      ++shown;
    }
  });
  result.numbers = voxels.finish();
  result.source = voxels.source();
  EXPECT_EQ(voxels.size(), result.source.size());
  inBlocks(voxel_case.points, block, [&](const Block& b) {
    const pcl::Indices follows = voxels.follow(b);
    result.follows.insert(result.follows.end(), follows.begin(), follows.end());
  });
  return result;
}

using WideCell = std::array<double, 3>;

std::map<WideCell, pcl::Indices>
pointsByVoxel(const VoxelCase& voxel_case)
{
  std::map<WideCell, pcl::Indices> members;
  for (std::size_t i = 0; i < voxel_case.points.size(); ++i) {
    const Eigen::Vector3d& p = voxel_case.points[i];
    if (p.allFinite())
      members[{std::floor(p.x() / voxel_case.size),
               std::floor(p.y() / voxel_case.size),
               std::floor(p.z() / voxel_case.size)}]
          .push_back(static_cast<pcl::index_t>(i));
  }
  return members;
}

WideVector
wide(const VoxelCase& voxel_case, pcl::index_t i)
{
  return voxel_case.points[static_cast<std::size_t>(i)].cast<long double>();
}

/** The chosen point of a voxel: as near to the mean as any, but for rounding, and the
 *  first of those that coincide with it. */
void
expectNearestToMean(const VoxelCase& voxel_case,
                    const pcl::Indices& members,
                    pcl::index_t chosen)
{
  WideVector mean = WideVector::Zero();
  for (const pcl::index_t i : members)
    mean += (wide(voxel_case, i) - wide(voxel_case, members.front()));
  mean = mean / static_cast<long double>(members.size()) +
         wide(voxel_case, members.front());
  const long double distance = (wide(voxel_case, chosen) - mean).norm();
  const long double rounding = 1e-12L * voxel_case.size + 4e-16L * mean.norm();
  for (const pcl::index_t i : members) {
    EXPECT_LE(distance, (wide(voxel_case, i) - mean).norm() + rounding);
    if (wide(voxel_case, i) == wide(voxel_case, chosen)) {
      EXPECT_LE(chosen, i);
    }
  }
}

/** The nearest of the chosen points, the first one at equal distance; its position. */
pcl::index_t
nearestByBruteForce(const VoxelCase& voxel_case,
                    const pcl::Indices& source,
                    const Eigen::Vector3d& p)
{
  pcl::index_t best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < source.size(); ++k) {
    const Eigen::Vector3d& q = voxel_case.points[static_cast<std::size_t>(source[k])];
    if ((p - q).squaredNorm() < least) {
      least = (p - q).squaredNorm();
      best = static_cast<pcl::index_t>(k);
    }
  }
  return best;
}

class VoxelsOf : public testing::TestWithParam<std::size_t> {
protected:
  const VoxelCase case_ = voxelCases()[GetParam()];
};

TEST_P(VoxelsOf, HaveOnePointEachTheOneNearestToTheirMean)
{
  SCOPED_TRACE(case_.name);
  const Thinned result = thinned(case_, 100, 2);
  const auto members = pointsByVoxel(case_);
  ASSERT_EQ(result.source.size(), members.size());
  EXPECT_TRUE(std::is_sorted(result.source.begin(), result.source.end()));
  for (const auto& [cell, indices] : members) {
    std::size_t chosen_in_voxel = 0;
    for (const pcl::index_t i : indices)
      if (std::binary_search(result.source.begin(), result.source.end(), i)) {
        ++chosen_in_voxel;
        expectNearestToMean(case_, indices, i);
      }
    EXPECT_EQ(chosen_in_voxel, 1u);
  }
}

TEST_P(VoxelsOf, SayWhichPointsWereChosen)
{
  SCOPED_TRACE(case_.name);
  const Thinned result = thinned(case_, 64, 1);
  ASSERT_EQ(result.numbers.size(), result.source.size());
  for (std::size_t k = 0; k < result.source.size(); ++k)
    EXPECT_EQ(result.best.at(result.numbers[k]), result.source[k]);
}

TEST_P(VoxelsOf, AreFollowedByTheNearestAsByBruteForce)
{
  SCOPED_TRACE(case_.name);
  const Thinned result = thinned(case_, 100, 2);
  ASSERT_EQ(result.follows.size(), case_.points.size());
  for (std::size_t i = 0; i < case_.points.size(); ++i)
    ASSERT_EQ(result.follows[i],
              case_.points[i].allFinite()
                  ? nearestByBruteForce(case_, result.source, case_.points[i])
                  : -1)
        << "point " << i;
}

TEST_P(VoxelsOf, DoNotDependOnBlocksAndThreads)
{
  SCOPED_TRACE(case_.name);
  const Thinned expected = thinned(case_, case_.points.size(), 1);
  for (const std::size_t block : {1u, 7u, 1000u})
    for (const unsigned int threads : {1u, 3u}) {
      const Thinned result = thinned(case_, block, threads);
      EXPECT_EQ(result.source, expected.source);
      EXPECT_EQ(result.follows, expected.follows);
    }
}

INSTANTIATE_TEST_SUITE_P(All,
                         VoxelsOf,
                         testing::Range(std::size_t{0}, voxelCases().size()));

/** Two points are equally far from their mean, wherever they are. */
TEST(VoxelPoints, OfTwoPointsTheFirstIsChosen)
{
  for (const Eigen::Vector3d& origin :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(512345.67, 5412345.67, 123.4)}) {
    std::mt19937_64 generator(11);
    std::uniform_real_distribution<double> draw(0.01, 0.99);
    Block points;
    pcl::Indices first_ones;
    for (int voxel = 0; voxel < 2000; ++voxel)
      for (const bool is_first : {true, false}) {
        if (is_first)
          first_ones.push_back(2 * voxel);
        const Eigen::Vector3d in_voxel(
            draw(generator), draw(generator), draw(generator));
        const Eigen::Vector3d cell = (origin / 0.02).array().floor();
        points.emplace_back(0.02 * (cell + Eigen::Vector3d(voxel, 0, 0) + in_voxel));
      }
    EXPECT_EQ(thinned({"pairs", points, 0.02}, 64, 1).source, first_ones);
  }
}

TEST(VoxelPoints, MayBeFollowedFromTwoVoxelsAway)
{
  for (const int side : {-1, 1})
    for (int axis = 0; axis < 3; ++axis) {
      Block points(9, Eigen::Vector3d::Constant(side * 0.01));
      points.emplace_back(Eigen::Vector3d::Constant(side * 0.99));
      points.push_back(points.back());
      points.back()[axis] = side * 2.01;
      const Thinned result = thinned({"two voxels away", points, 1.0}, 4, 1);
      EXPECT_EQ(result.source, (pcl::Indices{0, 10}));
      EXPECT_EQ(result.follows, (pcl::Indices{0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1}));
    }
}

TEST(VoxelPoints, RefuseSizesThatAreNone)
{
  for (const double size : {0.0, -1.0, 1e-16, nan_of_voxels})
    EXPECT_THROW(VoxelPoints{size}, CIDException) << size;
}

TEST(VoxelPoints, RefuseVoxelsTooSmallForThePoints)
{
  VoxelPoints far(1e-3);
  EXPECT_THROW(far.add({{0, 0, 0}, {0, 2e6, 0}}), CIDException);
  VoxelPoints coarse(1e-5);
  EXPECT_THROW(coarse.add({{1e14, 0, 0}}), CIDException);
}

TEST(VoxelPoints, RefuseAnotherScanTheNextTime)
{
  VoxelPoints voxels(1.0);
  voxels.add({{0.5, 0.5, 0.5}, {3.5, 0.5, 0.5}});
  EXPECT_THROW(voxels.choose({{7.5, 0.5, 0.5}}), CIDException);
  VoxelPoints short_of_one(1.0);
  short_of_one.add({{0.5, 0.5, 0.5}, {3.5, 0.5, 0.5}});
  short_of_one.choose({{0.5, 0.5, 0.5}});
  EXPECT_THROW(short_of_one.finish(), CIDException);
  EXPECT_THROW(short_of_one.add({{0.5, 0.5, 0.5}}), CIDException);
  EXPECT_THROW(short_of_one.follow({{0.5, 0.5, 0.5}}), CIDException);
  VoxelPoints done(1.0);
  done.add({{0.5, 0.5, 0.5}});
  done.choose({{0.5, 0.5, 0.5}});
  done.finish();
  EXPECT_THROW(done.follow({{2.5, 0.5, 0.5}}), CIDException);
  EXPECT_THROW(done.choose({{0.5, 0.5, 0.5}}), CIDException);
  EXPECT_THROW(done.add({{0.5, 0.5, 0.5}}), CIDException);
  EXPECT_THROW(done.finish(), CIDException);
}

} // namespace
} // namespace pcl_cid::test
