/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Doubt against its definition, pair by pair.
 */

#include "clouds.h"
#include "prepared_points.h"
#include "random_actions.h"
#include "sanitizers.h"

#include "cid/pair_cost.h"
#include "cid/working_points.h"

#include <pcl_cid/core/concavity.h>
#include <pcl_cid/core/label_doubt.h>
#include <pcl_cid/exceptions.h>

#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

constexpr int samples_on_segment = 100;

PreparedScan::ConstPtr
scanWithCosts(const Points& points)
{
  PreparationSettings settings = plainSettings();
  settings.connected = true;
  settings.normals = 0.03f;
  return prepared(points, settings);
}

/** Every third point, the last ones first. */
pcl::Indices
somePoints(std::size_t size)
{
  pcl::Indices points;
  for (std::size_t i = size; i-- > 0;)
    if (i % 3 == 0)
      points.push_back(static_cast<pcl::index_t>(i));
  return points;
}

float
costOf(const PreparedScan& scan, pcl::index_t seed, pcl::index_t point)
{
  const auto q = static_cast<std::size_t>(scan.workingIndex(seed, "seed"));
  const auto p = static_cast<std::size_t>(scan.workingIndex(point, "point"));
  const Points& points = scan.working().points();
  return scan.working().costs().between(q, p).of(
      pointCID(scan.field(), points[q], points[p], samples_on_segment));
}

float
marginOf(const LabelSession& session, pcl::index_t point)
{
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinite = std::numeric_limits<float>::infinity();
  const std::vector<SessionSeed> seeds = session.seeds();
  const pcl::index_t group = session.groups()[static_cast<std::size_t>(point)];
  if (group < 0 || session.isPainted(point) ||
      !seeds[static_cast<std::size_t>(group)].label)
    return none;
  float own = infinite;
  float other = infinite;
  for (const SessionSeed& seed : seeds)
    if (seed.label) {
      const bool is_own = seed.label == seeds[static_cast<std::size_t>(group)].label;
      float& nearest = is_own ? own : other;
      nearest = std::min(nearest, costOf(session.scan(), seed.point, point));
    }
  return other < infinite ? other - own : none;
}

TEST(LabelDoubt, IsWhatAllPairsSay)
{
  for (const NamedPoints& cloud : allClouds()) {
    SCOPED_TRACE(cloud.name);
    const PreparedScan::ConstPtr scan = scanWithCosts(cloud.points);
    const pcl::Indices points = somePoints(cloud.points.size());
    LabelSession session(scan);
    LabelDoubt doubt(scan, samples_on_segment, points);
    std::mt19937_64 random(5);
    for (int round = 0; round < (is_sanitized ? 2 : 5); ++round) {
      doRandomActions(6, random(), session);
      for (const unsigned int threads : {1u, 3u}) {
        const std::vector<float> margins = doubt.margins(session, onThreads(threads));
        ASSERT_EQ(margins.size(), points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
          const float expected = marginOf(session, points[i]);
          EXPECT_TRUE(margins[i] == expected ||
                      (std::isnan(margins[i]) && std::isnan(expected)))
              << "point " << points[i] << ": " << margins[i] << ", not " << expected;
        }
      }
    }
  }
}

TEST(LabelDoubt, FindsTheLargestAreaThatHangsTogether)
{
  // Two rows of points, far apart, 10 and 6 of them.
  Points points;
  pcl::Indices all;
  for (int i = 0; i < 16; ++i) {
    const float x = 0.1f * static_cast<float>(i);
    points.emplace_back(i < 10 ? x : x + 50.0f, 0.0f, 0.0f);
    all.push_back(i);
  }
  const LabelDoubt doubt(prepared(points), samples_on_segment, all);
  std::vector<float> margins(16, 1.0f);
  EXPECT_FALSE(doubt.area(margins, 0.5f));
  margins[3] = margins[4] = 0.1f;
  for (std::size_t i = 10; i < 16; ++i)
    margins[i] = 0.2f;
  margins[9] = std::numeric_limits<float>::quiet_NaN();
  std::optional<DoubtfulArea> area = doubt.area(margins, 0.5f);
  ASSERT_TRUE(area);
  EXPECT_EQ(area->points, (pcl::Indices{10, 11, 12, 13, 14, 15}));
  area = doubt.area(margins, 0.5f, 1);
  ASSERT_TRUE(area);
  EXPECT_EQ(area->points, (pcl::Indices{3, 4}));
  EXPECT_FALSE(doubt.area(margins, 0.5f, 2));
  area = doubt.area(margins, 0.15f);
  ASSERT_TRUE(area);
  EXPECT_EQ(area->points, (pcl::Indices{3, 4}));
}

TEST(LabelDoubt, RefusesWhatItCannotTell)
{
  const PreparedScan::ConstPtr scan = prepared(twoBoxes(60, 7));
  EXPECT_THROW(LabelDoubt(nullptr, samples_on_segment, {0}), CIDException);
  EXPECT_THROW(LabelDoubt(scan, samples_on_segment, {}), CIDException);
  EXPECT_THROW(LabelDoubt(scan, samples_on_segment, {0, 0}), CIDException);
  EXPECT_THROW(LabelDoubt(scan, samples_on_segment, {60}), CIDException);
  EXPECT_THROW(LabelDoubt(scan, 1, {0}), CIDException);
  LabelDoubt doubt(scan, samples_on_segment, {0, 1});
  EXPECT_THROW(doubt.margins(LabelSession(prepared(twoBoxes(60, 7)))), CIDException);
  EXPECT_THROW(doubt.area({1.0f}, 0.5f), CIDException);
}

} // namespace
} // namespace pcl_cid::test
