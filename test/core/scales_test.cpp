/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A cloud in another unit: the same result, from the smallest scale to the largest.
 */

#include "clouds.h"
#include "hulls.h"
#include "oracle.h"
#include "prepared_points.h"
#include "seeds_on_points.h"

#include <pcl_cid/core/concavity.h>
#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

Points
scaled(const Points& points, int exponent)
{
  Points scaled = points;
  for (Eigen::Vector3f& p : scaled)
    p = p.unaryExpr([&](float v) { return std::ldexp(v, exponent); });
  return scaled;
}

std::vector<float>
scaled(std::vector<float> values, int exponent)
{
  for (float& value : values)
    value = std::ldexp(value, exponent);
  return values;
}

struct Result {
  pcl::Indices seeds;
  std::vector<pcl::index_t> groups;
  std::vector<float> cids;
  std::vector<float> coverages;
  std::vector<MergeStep> merges;
};

/** Seeds that are proposed, one that is given, and the merges. */
Result
resultOf(const Points& points,
         const Points& surface,
         const PreparationSettings& settings)
{
  RawScan scan = rawScan(points);
  scan.surface = surface;
  for (Eigen::Vector3f& p : scan.surface)
    p = scan.points.frame.toLocal(p.cast<double>()).cast<float>();
  GroupingSettings grouping_settings;
  grouping_settings.keep_cid = true;
  Grouping grouping(std::make_shared<const PreparedScan>(std::move(scan), settings),
                    grouping_settings);
  grouping.propose(9);
  const pcl::Indices proposed = grouping.seeds();
  pcl::index_t given = 0;
  while (std::count(proposed.begin(), proposed.end(), given) > 0)
    ++given;
  grouping.addSeeds({given});
  const SeedProposal proposal = grouping.proposal();
  return {proposal.seeds,
          proposal.group,
          proposal.cid,
          proposal.coverage,
          mergeGroups(grouping).steps()};
}

void
expectScaled(const Result& scaled_one, const Result& one, int exponent)
{
  EXPECT_EQ(scaled_one.seeds, one.seeds);
  EXPECT_EQ(scaled_one.groups, one.groups);
  EXPECT_EQ(scaled_one.cids, scaled(one.cids, exponent));
  EXPECT_EQ(scaled_one.coverages, scaled(one.coverages, exponent));
  ASSERT_EQ(scaled_one.merges.size(), one.merges.size());
  for (std::size_t n = 0; n < one.merges.size(); ++n) {
    EXPECT_EQ(scaled_one.merges[n].first, one.merges[n].first);
    EXPECT_EQ(scaled_one.merges[n].second, one.merges[n].second);
    EXPECT_EQ(scaled_one.merges[n].height, std::ldexp(one.merges[n].height, exponent));
  }
}

std::vector<int>
exponents()
{
  std::vector<int> exponents;
  for (int e = -33; e <= 45; e += 3)
    exponents.push_back(e);
  return exponents;
}

PreparationSettings
unitless()
{
  PreparationSettings settings = plainSettings();
  settings.density = DensityWeight::on;
  settings.isolated_neighbors = 6;
  return settings;
}

class Scales : public testing::TestWithParam<int> {};

TEST_P(Scales, ChangeNothingButTheUnit)
{
  const int e = GetParam();
  for (const NamedPoints& cloud : randomClouds()) {
    SCOPED_TRACE(cloud.name);
    Points above = cloud.points;
    for (Eigen::Vector3f& p : above)
      p.z() += 0.25f;
    for (const PreparationSettings& settings : {plainSettings(), unitless()})
      for (const Points& surface : {Points(), above})
        expectScaled(resultOf(scaled(cloud.points, e), scaled(surface, e), settings),
                     resultOf(cloud.points, surface, settings),
                     e);
  }
}

INSTANTIATE_TEST_SUITE_P(PowersOfTwo, Scales, testing::ValuesIn(exponents()));

std::string
refusal(const Points& points, const Points& surface = {})
{
  RawScan scan = rawScan(points);
  scan.surface = surface;
  try {
    const PreparedScan made(std::move(scan), plainSettings());
  }
  catch (const CIDException& exception) {
    return exception.what();
  }
  return "";
}

TEST(Scales, WhatFloatCannotSquareIsRefused)
{
  const Points points = twoBoxes(100, 80);
  for (const int e : {-140, -120, -70, -60, -40})
    EXPECT_NE(refusal(scaled(points, e)).find("from end to end; it must be at least"),
              std::string::npos)
        << e;
  EXPECT_EQ(refusal(scaled(points, -33)), "");
  EXPECT_EQ(refusal(Points(5, points[0])), "");
  EXPECT_EQ(refusal({points[0]}), "");
  EXPECT_EQ(refusal(scaled(points, -60), points), "") << "the surface counts, too";
  EXPECT_NE(refusal(scaled(points, 60)), "");
}

/** Around the origin, where float tells places apart whose squared distance it cannot
 *  hold. */
Points
withATinyCluster(float size, std::uint64_t seed)
{
  Points points = twoBoxes(60, seed);
  for (const Eigen::Vector3f& p : randomCube(60, seed))
    points.push_back(p * size);
  return points;
}

/** Each point goes to the nearest seed, by pointCID() of every pair. */
SeedProposal
byAllPairs(const DistanceField& field, const Points& points, const pcl::Indices& seeds)
{
  SeedProposal proposal;
  for (std::size_t i = 0; i < points.size(); ++i) {
    proposal.group.push_back(-1);
    proposal.cid.push_back(INFINITY);
    for (std::size_t k = 0; k < seeds.size(); ++k) {
      const auto seed = static_cast<std::size_t>(seeds[k]);
      const float cid = pointCID(field, points[seed], points[i], 20);
      if (cid < proposal.cid[i]) {
        proposal.cid[i] = cid;
        proposal.group[i] = static_cast<pcl::index_t>(k);
      }
    }
  }
  for (std::size_t k = 0; k < seeds.size(); ++k)
    proposal.group[static_cast<std::size_t>(seeds[k])] = static_cast<pcl::index_t>(k);
  return proposal;
}

void
expectAgreesWithAllPairs(const Points& surface, const Points& points)
{
  const DistanceField field(surface);
  GroupingOptions options;
  options.samples = 20;
  const pcl::Indices seeds = {61, 5, 63, 70, 71, 72, 82, 93, 104, 119};
  const SeedProposal expected = byAllPairs(field, points, seeds);
  const SeedProposal found = groupBySeeds(field, points, seeds, options);
  EXPECT_EQ(found.group, expected.group);
  EXPECT_EQ(found.cid, expected.cid);
  options.keep_cid = false;
  EXPECT_EQ(groupBySeeds(field, points, seeds, options).group, expected.group);
}

TEST(Scales, TinyClustersOfLargeCloudsAgreeWithAllPairs)
{
  for (int e = -40; e > -150; e -= 5)
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
      SCOPED_TRACE(std::to_string(e) + " " + std::to_string(seed));
      const Points points = withATinyCluster(std::ldexp(1.0f, e), seed);
      expectAgreesWithAllPairs(points, points);
      expectAgreesWithAllPairs({points.begin() + 60, points.end()}, points);
    }
}

/** As a subsample may be, though the whole cloud is refused. */
TEST(Scales, TinyCloudsAgreeWithAllPairs)
{
  for (int e = -54; e > -150; e -= 3)
    for (const std::size_t count : {2u, 40u}) {
      SCOPED_TRACE(std::to_string(e) + " " + std::to_string(count));
      const Points points = scaled(randomCube(count, 81), e);
      const DistanceField field(points);
      SeedProposalOptions options;
      options.seeds = 8;
      options.samples = 16;
      expectSameProposal(proposeSeeds(field, points, 0, options),
                         proposeByAllPairs(field, points, 0, options));
    }
}

TEST(Scales, TinyPartsHaveHulls)
{
  for (const float size : {1e-10f, 1e-16f, 1e-22f, 1e-30f, 1e-40f})
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      Points points;
      for (const Eigen::Vector3f& p : randomCube(1 + 5 * seed, seed))
        points.push_back(p * size);
      for (const double thickness : {1e-3, 1e-15}) {
        ConvexPartOptions options;
        options.min_thickness = thickness;
        expectGuarantees(
            partOf(points, options), points, options, std::to_string(size));
      }
    }
}

} // namespace
} // namespace pcl_cid::test
