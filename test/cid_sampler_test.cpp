/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * CIDSampler: settings, input of every kind, and agreement with the core.
 */

#include "clouds.h"
#include "oracle.h"

#include "scan/isolated_points.h"
#include "scan/lab_color.h"
#include "scan/local_spacing.h"

#include <pcl_cid/cid_sampler.h>

#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <tuple>

#include <pcl/search/brute_force.h>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using Sampler = CIDSampler<pcl::PointXYZ>;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

Sampler
samplerFor(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud, int seeds)
{
  Sampler sampler;
  sampler.setInputCloud(cloud);
  sampler.setNumberOfSeeds(seeds);
  sampler.setNumberOfSamples(30);
  return sampler;
}

/** The settings of samplerFor(). */
const SeedProposalOptions as_sampled = [] {
  SeedProposalOptions options;
  options.samples = 30;
  return options;
}();

pcl::Indices
sampled(Sampler& sampler)
{
  pcl::Indices seeds;
  sampler.sample(seeds);
  return seeds;
}

TEST(CIDSampler, AgreesWithTheOracle)
{
  for (const NamedPoints& cloud : randomClouds()) {
    Sampler sampler = samplerFor(toCloud(cloud.points), 7);
    sampler.setPaperSettings();
    const pcl::Indices seeds = sampled(sampler);
    EXPECT_EQ(seeds.size(), 7u);
    EXPECT_EQ(sampler.getProposal().seeds, seeds);
    expectAgreesWithAlgorithm1(
        sampler.getProposal(), cloud.points, cloud.points, as_sampled);
    expectTraversalInvariants(sampler.getProposal(), cloud.points.size());
  }
}

TEST(CIDSampler, DegenerateCloudsGiveASeedForEachDistinctPoint)
{
  for (const NamedPoints& cloud : degenerateClouds()) {
    Sampler sampler = samplerFor(toCloud(cloud.points), 300);
    // With M - 1 intervals no more than the line has, samples could fall on its points
    // only, and Eq. 2 would call distinct points equal.
    sampler.setNumberOfSamples(100);
    sampler.setIsolatedNeighbors(0); // what is huge stands apart from what is tiny
    testing::internal::CaptureStderr();
    const pcl::Indices seeds = sampled(sampler);
    const std::string warning = testing::internal::GetCapturedStderr();
    std::set<std::tuple<float, float, float>> distinct;
    for (const Eigen::Vector3f& p : cloud.points)
      distinct.emplace(p.x(), p.y(), p.z());
    EXPECT_EQ(seeds.size(), distinct.size()) << cloud.name;
    EXPECT_NE(warning.find("instead of 300"), std::string::npos) << cloud.name;
    expectTraversalInvariants(sampler.getProposal(), cloud.points.size());
  }
}

TEST(CIDSampler, InvalidPointsAreSkippedWhateverIsDenseClaims)
{
  Points points = twoBoxes(200, 71);
  const auto clean = toCloud(points);
  Sampler on_clean = samplerFor(clean, 8);
  on_clean.setStartIndex(0);
  const pcl::Indices expected = sampled(on_clean);

  auto dirty = toCloud({});
  pcl::Indices place;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 3 == 0)
      dirty->emplace_back(nan, 1.0f, 2.0f);
    if (i % 7 == 0)
      dirty->emplace_back(0.0f, -infinity, 0.0f);
    place.push_back(static_cast<pcl::index_t>(dirty->size()));
    dirty->push_back((*clean)[i]);
  }
  dirty->is_dense = true;
  Sampler on_dirty = samplerFor(dirty, 8);
  on_dirty.setStartIndex(place[0]);
  const pcl::Indices found = sampled(on_dirty);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    EXPECT_EQ(found[k], place[static_cast<std::size_t>(expected[k])]);
  for (std::size_t i = 0; i < dirty->size(); ++i) {
    const bool finite = (*dirty)[i].getVector3fMap().allFinite();
    EXPECT_EQ(on_dirty.getProposal().group[i] >= 0, finite);
    EXPECT_EQ(std::isnan(on_dirty.getProposal().cid[i]), !finite);
  }
}

TEST(CIDSampler, IndicesSelectThePointsInAnyOrder)
{
  const Points points = twoBoxes(300, 72);
  Points half;
  auto indices = pcl::make_shared<pcl::Indices>();
  for (pcl::index_t i = 298; i >= 0; i -= 2) {
    indices->push_back(i);
    indices->push_back(i); // twice counts once
  }
  for (std::size_t i = 0; i < points.size(); i += 2)
    half.push_back(points[i]);
  Sampler of_indices = samplerFor(toCloud(points), 9);
  of_indices.setIndices(indices);
  of_indices.setStartIndex(0);
  Sampler of_half = samplerFor(toCloud(half), 9);
  of_half.setStartIndex(0);
  const pcl::Indices found = sampled(of_indices);
  const pcl::Indices expected = sampled(of_half);
  for (std::size_t k = 0; k < found.size(); ++k)
    EXPECT_EQ(found[k], 2 * expected[k]);
  for (std::size_t i = 1; i < points.size(); i += 2)
    EXPECT_EQ(of_indices.getProposal().group[i], -1);
}

TEST(CIDSampler, SearchSurfaceIsWhatDistancesAreMeasuredTo)
{
  const Points surface = twoBoxes(400, 73);
  const Points points(surface.begin(), surface.begin() + 150);
  Sampler sampler = samplerFor(toCloud(points), 6);
  sampler.setPaperSettings();
  sampler.setSearchSurface(toCloud(surface));
  sampled(sampler);
  expectAgreesWithAlgorithm1(sampler.getProposal(), surface, points, as_sampled);
}

TEST(CIDSampler, SearchMethodChangesNothing)
{
  const auto cloud = toCloud(twoBoxes(200, 74));
  Sampler with_tree = samplerFor(cloud, 8);
  Sampler with_brute_force = samplerFor(cloud, 8);
  with_brute_force.setSearchMethod(
      pcl::make_shared<pcl::search::BruteForce<pcl::PointXYZ>>());
  EXPECT_EQ(sampled(with_tree), sampled(with_brute_force));
  EXPECT_EQ(with_tree.getProposal().cid, with_brute_force.getProposal().cid);
}

TEST(CIDSampler, RandomSeedDecidesTheStartAndIsRepeatable)
{
  const auto cloud = toCloud(twoBoxes(500, 75));
  std::set<pcl::index_t> starts;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Sampler sampler = samplerFor(cloud, 4);
    sampler.setRandomSeed(seed);
    const pcl::Indices first = sampled(sampler);
    EXPECT_EQ(first, sampled(sampler));
    starts.insert(first.front());
  }
  EXPECT_GT(starts.size(), 5u);
}

TEST(CIDSampler, SameBytesForEveryNumberOfThreads)
{
  const auto cloud = toCloud(twoBoxes(600, 76));
  for (const int subsample : {0, 200}) {
    Sampler serial = samplerFor(cloud, 10);
    serial.setSubsample(subsample);
    serial.setNumberOfThreads(1);
    const pcl::Indices expected = sampled(serial);
    for (const unsigned int threads : {2u, 3u, 8u}) {
      Sampler parallel = samplerFor(cloud, 10);
      parallel.setSubsample(subsample);
      parallel.setNumberOfThreads(threads);
      EXPECT_EQ(sampled(parallel), expected);
      EXPECT_EQ(parallel.getProposal().group, serial.getProposal().group);
    }
  }
}

TEST(CIDSampler, SubsampleGroupsEveryPoint)
{
  const auto cloud = toCloud(twoBoxes(1000, 77));
  Sampler sampler = samplerFor(cloud, 6);
  sampler.setSubsample(120);
  sampler.setStartIndex(17);
  EXPECT_EQ(sampled(sampler).front(), 17);
  for (const pcl::index_t group : sampler.getProposal().group)
    EXPECT_GE(group, 0);
}

TEST(CIDSampler, CandidatesAloneBecomeSeeds)
{
  Sampler sampler = samplerFor(toCloud(twoBoxes(300, 78)), 10);
  auto candidates = pcl::make_shared<pcl::Indices>();
  for (pcl::index_t i = 1; i < 300; i += 5)
    candidates->push_back(i);
  sampler.setSeedCandidates(candidates);
  for (const pcl::index_t seed : sampled(sampler))
    EXPECT_EQ(seed % 5, 1);
  sampler.setSeedCandidates(pcl::make_shared<pcl::Indices>(1, 4711));
  EXPECT_THROW(sampled(sampler), CIDException);
}

TEST(CIDSampler, MillimetresAndUtmGiveTheSameSeedsAsMetresAtTheOrigin)
{
  Points points = twoBoxes(400, 79);
  for (Eigen::Vector3f& p : points)
    p = (64.0f * p).array().round() / 8.0f; // an eighth of a metre survives UTM
  Points millimetres = points, utm = points;
  for (Eigen::Vector3f& p : millimetres)
    p *= 1024.0f; // a power of two, so nothing is rounded
  for (Eigen::Vector3f& p : utm)
    p += Eigen::Vector3f(524288.0f, 1048576.0f, 256.0f);
  Sampler metres = samplerFor(toCloud(points), 12);
  Sampler in_millimetres = samplerFor(toCloud(millimetres), 12);
  Sampler at_utm = samplerFor(toCloud(utm), 12);
  const pcl::Indices expected = sampled(metres);
  EXPECT_EQ(sampled(in_millimetres), expected);
  EXPECT_EQ(sampled(at_utm), expected);
  EXPECT_EQ(at_utm.getProposal().cid, metres.getProposal().cid);
}

TEST(CIDSampler, EachSetterRefusesABadValueAndKeepsTheOldOne)
{
  Sampler sampler;
  for (const int seeds : {0, -1})
    EXPECT_THROW(sampler.setNumberOfSeeds(seeds), CIDException);
  for (const int samples : {1, 0, -5, (1 << 20) + 1})
    EXPECT_THROW(sampler.setNumberOfSamples(samples), CIDException);
  for (const float coverage : {-0.1f, nan, infinity})
    EXPECT_THROW(sampler.setCoverage(coverage), CIDException);
  EXPECT_THROW(sampler.setSubsample(-1), CIDException);
  EXPECT_THROW(sampler.setNumberOfThreads(1025), CIDException);
  EXPECT_THROW(sampler.setStartIndex(-1), CIDException);
  for (const float power : {-0.5f, 4.5f, nan})
    EXPECT_THROW(sampler.setDensityPower(power), CIDException);
  for (const int neighbors : {-1, 9})
    EXPECT_THROW(sampler.setIsolatedNeighbors(neighbors), CIDException);
  for (const float weight : {-0.1f, nan, infinity})
    EXPECT_THROW(sampler.setColorWeight(weight), CIDException);
  EXPECT_EQ(sampler.getNumberOfThreads(), 0u);
  EXPECT_EQ(sampler.getDensityWeight(), DensityWeight::automatic);
  EXPECT_EQ(sampler.getDensityPower(), 1.0f);
  EXPECT_EQ(sampler.getIsolatedNeighbors(), 4);
  EXPECT_EQ(sampler.getSeedingRule(), SeedingRule::farthest);
  EXPECT_EQ(sampler.getColorWeight(), 0.0f);
  EXPECT_TRUE(sampler.getFillBlindSpot());
  EXPECT_EQ(sampler.getNumberOfSeeds(), 100);
  EXPECT_EQ(sampler.getNumberOfSamples(), 100);
  EXPECT_EQ(sampler.getCoverage(), 0.0f);
  EXPECT_EQ(sampler.getSubsample(), 0);
  EXPECT_FALSE(sampler.getStartIndex());
  try {
    sampler.setNumberOfSeeds(-3);
  }
  catch (const pcl::PCLException& error) {
    EXPECT_NE(
        std::string(error.what())
            .find("the number of seeds is -3; it must be a whole number, at least "
                  "1"),
        std::string::npos)
        << error.what();
  }
}

TEST(CIDSampler, RefusesUnusableInputAndLeavesOutputsEmpty)
{
  const auto expectRefused = [](Sampler& sampler, const char* what) {
    pcl::Indices seeds = {1, 2, 3};
    EXPECT_THROW(sampler.sample(seeds), CIDException) << what;
    EXPECT_TRUE(seeds.empty()) << what;
    EXPECT_TRUE(sampler.getProposal().seeds.empty()) << what;
  };
  Sampler sampler;
  expectRefused(sampler, "no input");
  sampler = samplerFor(toCloud({}), 3);
  expectRefused(sampler, "empty input");
  sampler = samplerFor(toCloud({{nan, 0, 0}, {0, infinity, 0}}), 3);
  expectRefused(sampler, "no finite point");
  sampler = samplerFor(toCloud({{1e30f, 0, 0}, {0, 0, 0}}), 3);
  expectRefused(sampler, "too large to square");
  const auto cloud = toCloud(randomCube(20, 80));
  sampler = samplerFor(cloud, 3);
  sampler.setStartIndex(20);
  expectRefused(sampler, "start out of range");
  sampler = samplerFor(cloud, 3);
  sampler.setIndices(pcl::make_shared<pcl::Indices>(1, 20));
  expectRefused(sampler, "index out of range");
  sampler = samplerFor(cloud, 3);
  sampler.setIndices(pcl::make_shared<pcl::Indices>());
  expectRefused(sampler, "no index");
  sampler = samplerFor(cloud, 3);
  sampler.setSearchSurface(toCloud({{nan, nan, nan}}));
  expectRefused(sampler, "no finite surface point");
}

TEST(CIDSampler, ExtendedEqualsOneRun)
{
  const auto cloud = toCloud(twoBoxes(900, 84));
  for (const int subsample : {0, 300}) {
    Sampler at_once = samplerFor(cloud, 25);
    at_once.setSubsample(subsample);
    const pcl::Indices expected = sampled(at_once);
    Sampler in_steps = samplerFor(cloud, 10);
    in_steps.setSubsample(subsample);
    pcl::Indices seeds;
    EXPECT_THROW(in_steps.extend(25, seeds), CIDException) << "nothing to extend";
    in_steps.sample(seeds);
    in_steps.extend(18, seeds);
    EXPECT_EQ(seeds.size(), 18u);
    in_steps.extend(25, seeds);
    EXPECT_EQ(seeds, expected);
    EXPECT_EQ(in_steps.getProposal().group, at_once.getProposal().group);
    in_steps.setInputCloud(toCloud(twoBoxes(900, 85)));
    EXPECT_THROW(in_steps.extend(30, seeds), CIDException) << "another cloud";
  }
}

/** Two boxes, stray points far from them, and everything switched on. */
Sampler
samplerWithAllOn()
{
  Points points = twoBoxes(600, 21);
  for (int i = 0; i < 3; ++i)
    points.emplace_back(20.0f + 10.0f * static_cast<float>(i), 0.0f, 0.0f);
  auto colors = std::make_shared<std::vector<ColorRGB>>();
  for (std::size_t i = 0; i < points.size(); ++i)
    colors->push_back({static_cast<std::uint8_t>(i % 2 == 0 ? 200 : 0), 40, 90});
  Sampler sampler = samplerFor(toCloud(points), 12);
  sampler.setDensityWeight(DensityWeight::on);
  sampler.setDensityPower(0.5f);
  sampler.setSeedingRule(SeedingRule::soft);
  sampler.setColors(colors);
  sampler.setColorWeight(0.001f);
  return sampler;
}

TEST(CIDSampler, AllForRawScansIsWhatTheCoreMakesOfIt)
{
  Sampler sampler = samplerWithAllOn();
  sampler.setNormalWeight(0.0f);
  sampler.setConnectedGroups(false);
  sampler.setSeedingRule(SeedingRule::farthest);
  sampler.setStartIndex(7);
  const pcl::Indices seeds = sampled(sampler);
  Points points;
  for (const pcl::PointXYZ& p : *sampler.getInputCloud())
    points.push_back(p.getVector3fMap());
  const NearestNeighbors neighbors(points, {});
  PairCosts costs;
  costs.spacing = localSpacing(neighbors, 0.5f);
  costs.cues = {{Cue::Property::color, smoothLab(*sampler.getColors(), neighbors)}};
  for (Eigen::Vector3f& color : costs.cues.front().values)
    color *= 0.001f;
  SeedProposalOptions options = as_sampled;
  options.seeds = 12;
  options.costs = &costs;
  options.isolated = isolatedPoints(points, neighbors, sampler.getIsolatedNeighbors());
  EXPECT_EQ(options.isolated, (pcl::Indices{600, 601, 602}));
  const SeedProposal expected = proposeSeeds(DistanceField(points), points, 7, options);
  EXPECT_EQ(seeds, expected.seeds);
  EXPECT_EQ(sampler.getProposal().group, expected.group);
  EXPECT_EQ(sampler.getProposal().cid, expected.cid);
  EXPECT_TRUE(sampler.getDensityDecision().weighted);
  EXPECT_EQ(sampler.getDensityDecision().isolated_points, 3u);
}

TEST(CIDSampler, IsolatedPointsAreNoSeedsUnlessTheyAreMeant)
{
  Sampler sampler = samplerWithAllOn();
  for (std::uint64_t random_seed = 0; random_seed < 300; ++random_seed) {
    sampler.setNumberOfSeeds(1);
    sampler.setRandomSeed(random_seed);
    ASSERT_LT(sampled(sampler).front(), 600) << "a drawn start";
  }
  sampler.setNumberOfSeeds(30);
  for (const pcl::index_t seed : sampled(sampler))
    EXPECT_LT(seed, 600);
  EXPECT_GE(sampler.getProposal().group[602], 0) << "it belongs to a group";
  sampler.setStartIndex(601);
  EXPECT_EQ(sampled(sampler).front(), 601);
  sampler.resetStartIndex();
  sampler.setSeedCandidates(pcl::make_shared<pcl::Indices>(pcl::Indices{600, 602}));
  EXPECT_EQ(sampled(sampler).size(), 2u) << "there are no others";
}

TEST(CIDSampler, SameBytesForEveryNumberOfThreadsWithAllOn)
{
  Sampler sampler = samplerWithAllOn();
  sampler.setNumberOfThreads(1);
  const pcl::Indices seeds = sampled(sampler);
  const SeedProposal expected = sampler.getProposal();
  for (const unsigned int threads : {2u, 3u, 8u}) {
    sampler.setNumberOfThreads(threads);
    EXPECT_EQ(sampled(sampler), seeds);
    EXPECT_EQ(sampler.getProposal().group, expected.group);
    EXPECT_EQ(sampler.getProposal().cid, expected.cid);
  }
}

TEST(CIDSampler, ExtendedEqualsOneRunWithAllOn)
{
  Sampler in_steps = samplerWithAllOn();
  sampled(in_steps);
  pcl::Indices extended;
  in_steps.extend(20, extended);
  Sampler at_once = samplerWithAllOn();
  at_once.setNumberOfSeeds(20);
  EXPECT_EQ(sampled(at_once), extended);
  EXPECT_EQ(at_once.getProposal().group, in_steps.getProposal().group);
}

TEST(CIDSampler, ExtendRefusesChangedSettings)
{
  using Change = void (*)(Sampler&);
  const Change changes[] = {[](Sampler& s) { s.setDensityWeight(DensityWeight::off); },
                            [](Sampler& s) { s.setDensityPower(2.0f); },
                            [](Sampler& s) { s.setIsolatedNeighbors(0); },
                            [](Sampler& s) { s.setFillBlindSpot(false); },
                            [](Sampler& s) { s.setSeedingRule(SeedingRule::farthest); },
                            [](Sampler& s) { s.setColorWeight(0.0f); }};
  for (const Change change : changes) {
    Sampler sampler = samplerWithAllOn();
    sampled(sampler);
    change(sampler);
    pcl::Indices seeds;
    EXPECT_THROW(sampler.extend(20, seeds), CIDException);
  }
}

TEST(CIDSampler, PaperSettingsAreThoseOfThePaper)
{
  Sampler paper = samplerFor(toCloud(twoBoxes(1500, 22)), 9);
  paper.setDensityWeight(DensityWeight::on);
  paper.setSeedingRule(SeedingRule::soft);
  paper.setColorWeight(0.1f);
  paper.setNormalWeight(0.1f);
  paper.setConnectedGroups(true);
  paper.setSubsample(1000);
  paper.setPaperSettings();
  EXPECT_EQ(paper.getDensityWeight(), DensityWeight::off);
  EXPECT_EQ(paper.getIsolatedNeighbors(), 0);
  EXPECT_EQ(paper.getSeedingRule(), SeedingRule::farthest);
  EXPECT_EQ(paper.getColorWeight(), 0.0f);
  EXPECT_EQ(paper.getNormalWeight(), 0.0f);
  EXPECT_FALSE(paper.getConnectedGroups());
  EXPECT_FALSE(paper.getFillBlindSpot());
  EXPECT_EQ(paper.getSubsample(), 1000);
  sampled(paper);
  EXPECT_FALSE(paper.getDensityDecision().weighted);
}

TEST(CIDSampler, DecidesByTheSpacing)
{
  Points points = twoBoxes(20000, 22);
  Sampler even = samplerFor(toCloud(points), 2);
  sampled(even);
  EXPECT_FALSE(even.getDensityDecision().weighted);
  EXPECT_LT(even.getDensityDecision().spread, uneven_spread);
  for (Eigen::Vector3f& p : points)
    p *= std::exp(p.x()); // sparser and sparser, as seen from the origin
  Sampler uneven = samplerFor(toCloud(points), 2);
  sampled(uneven);
  EXPECT_TRUE(uneven.getDensityDecision().weighted);
  uneven.setDensityWeight(DensityWeight::off);
  sampled(uneven);
  EXPECT_FALSE(uneven.getDensityDecision().weighted);
  uneven.setDensityWeight(DensityWeight::on);
  uneven.setDensityPower(0.0f);
  sampled(uneven);
  EXPECT_FALSE(uneven.getDensityDecision().weighted);
}

TEST(CIDSampler, ColorsComeFromThePointTypeOrAreGiven)
{
  const Points points = twoBoxes(300, 23);
  auto colored = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>>();
  auto colors = std::make_shared<std::vector<ColorRGB>>();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto red = static_cast<std::uint8_t>(points[i].x() > 0.5f ? 250 : 10);
    colored->emplace_back(points[i].x(), points[i].y(), points[i].z(), red, 20, 30);
    colors->push_back({red, 20, 30});
  }
  CIDSampler<pcl::PointXYZRGB> of_type;
  of_type.setInputCloud(colored);
  of_type.setNumberOfSeeds(9);
  of_type.setColorWeight(0.01f);
  pcl::Indices seeds;
  of_type.sample(seeds);

  Sampler given = samplerFor(toCloud(points), 9);
  given.setNumberOfSamples(of_type.getNumberOfSamples());
  given.setColorWeight(0.01f);
  EXPECT_THROW(sampled(given), CIDException) << "PointXYZ has no colors";
  given.setColors(std::make_shared<std::vector<ColorRGB>>(299));
  EXPECT_THROW(sampled(given), CIDException) << "one color too few";
  given.setColors(colors);
  EXPECT_EQ(sampled(given), seeds);
  EXPECT_EQ(given.getProposal().cid, of_type.getProposal().cid);
}

TEST(CIDSampler, LittleMemoryChangesNothing)
{
  const auto cloud = toCloud(twoBoxes(2000, 86));
  Sampler rich = samplerFor(cloud, 12);
  Sampler poor = samplerFor(cloud, 12);
  poor.setMemoryBudget(1000);
  EXPECT_EQ(sampled(poor), sampled(rich));
  EXPECT_EQ(poor.getProposal().cid, rich.getProposal().cid);
}

TEST(CIDSampler, CancelledAndReusable)
{
  Sampler sampler = samplerFor(toCloud(twoBoxes(2000, 81)), 40);
  sampler.setProgressCallback([](double) { return false; });
  pcl::Indices seeds;
  EXPECT_THROW(sampler.sample(seeds), CIDCancelled);
  EXPECT_TRUE(seeds.empty());
  sampler.setProgressCallback({});
  EXPECT_EQ(sampled(sampler).size(), 40u);
}

TEST(CIDSampler, WarnsWhenTheCoverageIsNotReached)
{
  Sampler sampler = samplerFor(toCloud(twoBoxes(300, 82)), 3);
  sampler.setCoverage(1e-3f);
  testing::internal::CaptureStderr();
  sampled(sampler);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("coverage"), std::string::npos);
}

template <typename PointT>
class CIDSamplerOfType : public testing::Test {
};

#ifdef PCL_CID_FEW_POINT_TYPES
using XyzTypes = testing::Types<pcl::PointXYZRGBNormal>;
#else
using XyzTypes = testing::Types<pcl::PointXYZI,
                                pcl::PointXYZRGBA,
                                pcl::PointXYZRGBL,
                                pcl::PointNormal,
                                pcl::PointXYZRGBNormal,
                                pcl::PointWithViewpoint,
                                pcl::PointDEM>;
#endif
TYPED_TEST_SUITE(CIDSamplerOfType, XyzTypes);

TYPED_TEST(CIDSamplerOfType, GivesTheSeedsOfPointXYZ)
{
  const Points points = twoBoxes(150, 83);
  auto cloud = pcl::make_shared<pcl::PointCloud<TypeParam>>();
  for (const Eigen::Vector3f& p : points) {
    TypeParam point;
    point.getVector3fMap() = p;
    cloud->push_back(point);
  }
  Sampler reference = samplerFor(toCloud(points), 6);
  CIDSampler<TypeParam> sampler;
  sampler.setInputCloud(cloud);
  sampler.setNumberOfSeeds(6);
  sampler.setNumberOfSamples(30);
  pcl::Indices seeds;
  sampler.sample(seeds);
  EXPECT_EQ(seeds, sampled(reference));
}

} // namespace
} // namespace pcl_cid::test
