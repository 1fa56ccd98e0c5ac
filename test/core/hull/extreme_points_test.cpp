/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points that hulls need: as extreme as all of them, and few.
 */

#include "clouds.h"
#include "hulls.h"
#include "portable_draw.h"

#include <pcl_cid/core/extreme_points.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using Block = ExtremePoints::Block;

constexpr std::size_t many = 20000;

Eigen::Vector3d
drawnPlace(RandomGenerator& generator)
{
  const double x = drawUnit(generator) - 0.5;
  const double y = drawUnit(generator) - 0.5;
  const double z = drawUnit(generator) - 0.5;
  return {x, y, z};
}

/** Points in a cube of 1 m, as a function of what was drawn puts them. */
template <typename Put>
Block
drawn(const Put& put, std::size_t count = many)
{
  RandomGenerator generator(7);
  Block points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(put(drawnPlace(generator)));
  return points;
}

/** In the order of x, as a scanner may go. */
Block
swept(Block points)
{
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() < b.x();
  });
  return points;
}

struct NamedBlock {
  std::string name;
  Block points;
  std::size_t most; ///< that may be kept
};

std::vector<NamedBlock>
blocks()
{
  using V = Eigen::Vector3d;
  const auto same = [](const V& p) { return p; };
  const auto quantized = [](const V& p) -> V {
    return (p * 50.0).array().round() / 50.0;
  };
  const auto flat = [&](const V& p) -> V {
    return {quantized(p).x(), quantized(p).y(), 0.0};
  };
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, V(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  const auto plate = [&](double thickness) {
    return drawn(
        [&](const V& p) -> V { return turn * V(p.x(), p.y(), thickness * p.z()); });
  };
  return {
      {"plate of 1e-5", plate(1e-5), 700},
      {"plate of 2e-6", plate(2e-6), 700},
      {"plate of 1e-6", plate(1e-6), 700},
      {"plate of 1e-8", plate(1e-8), 700},
      {"plate of 1e-11", plate(1e-11), 700},
      {"plate of 1e-12", plate(1e-12), 700},
      {"cube", drawn(same), 700},
      {"swept cube", swept(drawn(same)), 700},
      {"grid", drawn(quantized), 60},
      {"turned grid", drawn([&](const V& p) -> V { return turn * quantized(p); }), 60},
      {"wall", drawn(flat), 10},
      {"turned wall",
       swept(drawn([&](const V& p) -> V { return turn * flat(p); })),
       60},
      {"noisy wall",
       drawn([&](const V& p) -> V {
         return {p.x(), p.y(), 0.001 * p.z()};
       }),
       700},
      {"line", drawn([&](const V& p) -> V { return turn.col(0) * p.x(); }), 8},
      {"place", drawn([](const V&) { return V(1.0, 2.0, 3.0); }), 8},
      {"two places",
       drawn([](const V& p) { return p.x() < 0.0 ? V(1, 2, 3) : V(1, 2, 4); }),
       16},
      {"sphere", drawn([](const V& p) -> V { return p.normalized(); }, 3000), 3000},
      {"far off",
       drawn([&](const V& p) -> V { return V(456000.0, 5.4e6, 300.0) + quantized(p); }),
       200},
      {"thin air", drawn([](const V& p) -> V { return 1e-6 * p; }), 700},
      {"region", drawn([](const V& p) -> V { return 1e5 * p; }), 700}};
}

/** How far points reach, from the first of them. */
double
reachOf(const Block& points,
        const Eigen::Vector3d& origin,
        const Eigen::Vector3d& direction)
{
  double most = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& p : points)
    most = std::max(most, direction.dot(p - origin));
  return most;
}

Block
extremesOf(const Block& points, std::size_t block, unsigned int threads = 1)
{
  ExtremePoints extremes(1, threads);
  for (std::size_t i = 0; i < points.size(); i += block) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(i);
    const Block shown(
        begin, begin + static_cast<std::ptrdiff_t>(std::min(block, points.size() - i)));
    extremes.add(shown, std::vector<int>(shown.size(), 0));
  }
  return extremes.of(0);
}

TEST(ExtremePoints, ReachAsFarAsAllInEveryDirection)
{
  for (const NamedBlock& cloud : blocks()) {
    const Block kept = extremesOf(cloud.points, 4096);
    const double tolerance = 1e-6 * diagonalOf(cloud.points);
    RandomGenerator generator(3);
    for (int k = 0; k < 300; ++k) {
      const Eigen::Vector3d direction = k < 3
                                            ? Eigen::Vector3d(Eigen::Vector3d::Unit(k))
                                            : drawnPlace(generator).normalized();
      EXPECT_NEAR(reachOf(kept, cloud.points[0], direction),
                  reachOf(cloud.points, cloud.points[0], direction),
                  tolerance)
          << cloud.name;
    }
    for (const Eigen::Vector3d& p : kept)
      EXPECT_NE(std::find(cloud.points.begin(), cloud.points.end(), p),
                cloud.points.end())
          << cloud.name;
    EXPECT_LE(kept.size(), cloud.most) << cloud.name;
  }
}

/** The sharpest directions: those of the faces of the hull of what was kept. */
TEST(ExtremePoints, HaveAHullThatHoldsAll)
{
  for (const NamedBlock& cloud : blocks()) {
    if (cloud.name == "sphere" || cloud.name == "far off")
      continue; // slow, and no floats
    Points kept;
    for (const Eigen::Vector3d& p : extremesOf(cloud.points, 5000))
      kept.push_back(p.cast<float>());
    const ConvexPart part = partOf(kept);
    double most = 0.0;
    for (const Eigen::Vector3d& p : cloud.points)
      most = std::max(most, excess(part.hull, p));
    EXPECT_LE(most, hull_tolerance * diagonalOf(part.hull.vertices)) << cloud.name;
  }
}

TEST(ExtremePoints, AreTheSameForAllBlocksAndThreads)
{
  RandomGenerator generator(11);
  Block points;
  std::vector<int> part;
  for (std::size_t i = 0; i < many; ++i) {
    points.push_back(drawnPlace(generator));
    part.push_back(static_cast<int>(drawBelow(generator, 6)) - 1);
    if (part.back() < 0)
      points.back().x() = std::numeric_limits<double>::quiet_NaN();
  }
  const auto shown = [&](std::size_t block, unsigned int threads) {
    ExtremePoints extremes(6, threads);
    for (std::size_t i = 0; i < many; i += block) {
      const auto end = std::min(i + block, many);
      extremes.add(Block(points.data() + i, points.data() + end),
                   std::vector<int>(part.data() + i, part.data() + end));
    }
    std::vector<Block> kept;
    for (std::size_t k = 0; k < 6; ++k)
      kept.push_back(extremes.of(k));
    return kept;
  };
  const std::vector<Block> expected = shown(many, 1);
  EXPECT_TRUE(expected[5].empty());
  EXPECT_FALSE(expected[0].empty());
  EXPECT_EQ(shown(997, 1), expected);
  EXPECT_EQ(shown(many, 2), expected);
  EXPECT_EQ(shown(3000, 3), expected);
  EXPECT_EQ(shown(1, 8), expected);
}

TEST(ExtremePoints, RefusesPartsThatAreNone)
{
  ExtremePoints extremes(2);
  EXPECT_THROW(extremes.add({{0, 0, 0}}, {2}), CIDException);
  EXPECT_THROW(extremes.add({{0, 0, 0}}, {0, 1}), CIDException);
  EXPECT_THROW(extremes.of(2), CIDException);
  EXPECT_TRUE(extremes.of(1).empty());
}

} // namespace
} // namespace pcl_cid::test
