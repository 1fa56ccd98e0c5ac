/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan is prepared once, and grouped once, however many verbs and objects follow.
 */

#include "base/random.h"
#include "clouds.h"
#include "field/build_count.h"
#include "oracle.h"
#include "prepared_points.h"

#include <pcl_cid/cid_convex_abstraction.h>
#include <pcl_cid/cid_label_propagation.h>
#include <pcl_cid/cid_sampler.h>
#include <pcl_cid/core/hull_tightness.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <pcl/search/brute_force.h>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Sampler = CIDSampler<pcl::PointXYZ>;
using Propagation = CIDLabelPropagation<pcl::PointXYZ>;
using Abstraction = CIDConvexAbstraction<pcl::PointXYZ>;

/** Fields that are built from now on. */
class FieldCount {
public:
  std::size_t
  now() const
  {
    return fieldsBuilt() - before_;
  }

private:
  std::size_t before_ = fieldsBuilt();
};

template <typename Object>
Object
objectFor(const Cloud::ConstPtr& cloud)
{
  Object object;
  object.setInputCloud(cloud);
  object.setNumberOfSeeds(12);
  object.setNumberOfSamples(30);
  return object;
}

SeedProposal
proposalOf(Sampler& sampler)
{
  pcl::Indices seeds;
  sampler.sample(seeds);
  EXPECT_EQ(seeds, sampler.getProposal().seeds);
  return sampler.getProposal();
}

std::vector<std::uint32_t>
labelsOf(Propagation& propagation)
{
  std::vector<std::uint32_t> labels;
  propagation.segment(labels);
  return labels;
}

std::vector<ConvexPart>
partsOf(Abstraction& abstraction)
{
  std::vector<ConvexPart> parts;
  abstraction.reconstruct(parts);
  return parts;
}

void
expectSameParts(const std::vector<ConvexPart>& a, const std::vector<ConvexPart>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].indices, b[k].indices);
    EXPECT_EQ(a[k].hull.vertices, b[k].hull.vertices);
    EXPECT_EQ(a[k].hull.triangles, b[k].hull.triangles);
  }
}

TEST(OnePreparation, FromSeedsToTightness)
{
  const Cloud::Ptr cloud = toCloud(twoBoxes(900, 201));
  const FieldCount fields;
  Sampler sampler = objectFor<Sampler>(cloud);
  const SeedProposal proposal = proposalOf(sampler);
  EXPECT_EQ(fields.now(), 1u);
  const Grouping::ConstPtr grouping = sampler.getGrouping();
  EXPECT_EQ(grouping->comparisons(), 12u);

  Propagation propagation;
  propagation.setInputCloud(cloud);
  propagation.setGrouping(grouping);
  const std::vector<std::uint32_t> numbered = labelsOf(propagation);
  const std::vector<std::uint32_t> labels = {3, 3, 3, 3, 9, 9, 9, 9, 1, 2, 4, 5};
  propagation.setSeeds(proposal.seeds, labels);
  const std::vector<std::uint32_t> given = labelsOf(propagation);
  EXPECT_EQ(propagation.getGrouping(), grouping);

  Abstraction abstraction;
  abstraction.setGrouping(grouping); // no input: the scan is enough
  abstraction.setNumberOfParts(4);
  const std::vector<ConvexPart> parts = partsOf(abstraction);
  EXPECT_EQ(abstraction.getGrouping(), grouping);

  TightnessOptions options;
  options.box_samples = 5000;
  const TightnessMeter meter(abstraction.getPreparedScan(), options);
  const Tightness tightness = meter.measure(parts);
  EXPECT_EQ(fields.now(), 1u) << "one field for all of it";
  EXPECT_EQ(grouping->comparisons(), 12u) << "and Algorithm 1 once";

  // All of it as if each had been on its own.
  Propagation own_propagation = objectFor<Propagation>(cloud);
  EXPECT_EQ(labelsOf(own_propagation), numbered);
  own_propagation.setSeeds(proposal.seeds, labels);
  EXPECT_EQ(labelsOf(own_propagation), given);
  Abstraction own_abstraction = objectFor<Abstraction>(cloud);
  own_abstraction.setNumberOfParts(4);
  expectSameParts(partsOf(own_abstraction), parts);
  const PointSet points = rawScan(twoBoxes(900, 201)).points;
  const Tightness own = TightnessMeter(points, options).measure(parts);
  EXPECT_EQ(own.volume, tightness.volume);
  EXPECT_EQ(own.free_volume, tightness.free_volume);
  EXPECT_EQ(own.all.max_concavity, tightness.all.max_concavity);
  EXPECT_EQ(own.all.mean_concavity, tightness.all.mean_concavity);
  EXPECT_EQ(own.all.free_share, tightness.all.free_share);
  EXPECT_EQ(fields.now(), 4u);
}

TEST(OnePreparation, OfSuccessiveVerbs)
{
  const FieldCount fields;
  Abstraction abstraction = objectFor<Abstraction>(toCloud(twoBoxes(700, 202)));
  std::vector<pcl::PointIndices> segmented;
  abstraction.segment(segmented);
  const std::vector<ConvexPart> parts = partsOf(abstraction);
  std::vector<ConvexPart> cut;
  abstraction.reconstruct(abstraction.getMergeTree().cutAtParts(5), cut);
  EXPECT_EQ(cut.size(), 5u);
  abstraction.setNumberOfMerges(3);
  abstraction.setPadding(0.01);
  abstraction.setMinPoints(2);
  EXPECT_EQ(partsOf(abstraction).size(), 9u);
  EXPECT_EQ(abstraction.getGrouping()->comparisons(), 12u);
  EXPECT_EQ(fields.now(), 1u);

  Propagation propagation = objectFor<Propagation>(toCloud(twoBoxes(700, 202)));
  const std::vector<std::uint32_t> labels = labelsOf(propagation);
  EXPECT_EQ(labelsOf(propagation), labels);
  pcl::PointCloud<pcl::PointXYZL> cloud;
  propagation.segment(cloud);
  EXPECT_EQ(propagation.getGrouping()->comparisons(), 12u);
  EXPECT_EQ(fields.now(), 2u);
}

TEST(OnePreparation, MoreSeedsGoOn)
{
  const Cloud::Ptr cloud = toCloud(twoBoxes(700, 203));
  const FieldCount fields;
  Abstraction abstraction = objectFor<Abstraction>(cloud);
  partsOf(abstraction);
  const Grouping::ConstPtr twelve = abstraction.getGrouping();
  abstraction.setNumberOfSeeds(20);
  const std::vector<ConvexPart> parts = partsOf(abstraction);
  EXPECT_EQ(abstraction.getGrouping()->comparisons(), 20u) << "eight new ones";
  EXPECT_EQ(twelve->numberOfSeeds(), 12u) << "what was handed out stays as it is";
  EXPECT_EQ(abstraction.getMergeTree().numberOfGroups(), 20u);
  EXPECT_EQ(fields.now(), 1u);
  Abstraction fresh = objectFor<Abstraction>(cloud);
  fresh.setNumberOfSeeds(20);
  expectSameParts(partsOf(fresh), parts);
}

TEST(OnePreparation, FewerSeedsAndOtherGroupsNeedNoField)
{
  using Change = std::function<void(Sampler&)>;
  const std::vector<Change> changes = {
      [](Sampler& s) { s.setNumberOfSeeds(5); },
      [](Sampler& s) { s.setNumberOfSamples(17); },
      [](Sampler& s) { s.setSeedingRule(SeedingRule::soft); },
      [](Sampler& s) { s.setNumberOfSeeds(9); },
      [](Sampler& s) { s.setCoverage(0.4f); },
      [](Sampler& s) { s.setNumberOfThreads(3); },
      [](Sampler& s) { s.setNumberOfSeeds(60); },
      [](Sampler& s) { s.setCoverage(0.6f); },
      [](Sampler& s) { s.setCoverage(0.3f); },
      [](Sampler& s) { s.setSeedingRule(SeedingRule::farthest); },
      [](Sampler& s) { s.setProgressCallback([](double) { return true; }); },
      [](Sampler& s) { s.setCoverage(0.0f); },
      [](Sampler& s) { s.setNumberOfSeeds(3); }};
  const Cloud::Ptr cloud = toCloud(twoBoxes(500, 204));
  Sampler sampler = objectFor<Sampler>(cloud);
  proposalOf(sampler);
  const PreparedScan::ConstPtr scan = sampler.getPreparedScan();
  for (std::size_t n = 0; n < changes.size(); ++n) {
    SCOPED_TRACE(n);
    const FieldCount fields;
    changes[n](sampler);
    const SeedProposal found = proposalOf(sampler);
    EXPECT_EQ(fields.now(), 0u);
    EXPECT_EQ(sampler.getPreparedScan(), scan);
    Sampler fresh = objectFor<Sampler>(cloud);
    for (std::size_t k = 0; k <= n; ++k)
      changes[k](fresh);
    expectSameProposal(found, proposalOf(fresh));
  }
}

/** Whatever was sampled and extended before, a sample is that of a new object. */
TEST(OnePreparation, SampleAfterAnyExtensionIsThatOfANewObject)
{
  const Cloud::Ptr cloud = toCloud(twoBoxes(400, 205));
  RandomGenerator generator(4);
  Sampler sampler = objectFor<Sampler>(cloud);
  proposalOf(sampler);
  const FieldCount fields;
  for (int n = 0; n < 60; ++n) {
    sampler.setNumberOfSeeds(1 + static_cast<int>(drawBelow(generator, 25)));
    sampler.setCoverage(drawBelow(generator, 2) == 0
                            ? 0.0f
                            : 0.1f * static_cast<float>(drawBelow(generator, 9)));
    if (drawBelow(generator, 2) == 0) {
      pcl::Indices seeds;
      sampler.extend(1 + static_cast<int>(drawBelow(generator, 30)), seeds);
      continue;
    }
    const SeedProposal found = proposalOf(sampler);
    Sampler fresh = objectFor<Sampler>(nullptr);
    fresh.setPreparedScan(sampler.getPreparedScan());
    fresh.setNumberOfSeeds(sampler.getNumberOfSeeds());
    fresh.setCoverage(sampler.getCoverage());
    expectSameProposal(found, proposalOf(fresh));
  }
  EXPECT_EQ(fields.now(), 0u);
}

/** Each setting of the preparation, and each input. */
TEST(OnePreparation, AnotherSettingOfThePreparationPreparesAgain)
{
  const Points points = twoBoxes(400, 206);
  const Cloud::Ptr cloud = toCloud(points);
  const Cloud::Ptr surface = toCloud(twoBoxes(300, 207));
  auto colors = std::make_shared<std::vector<ColorRGB>>();
  for (std::size_t i = 0; i < points.size(); ++i)
    colors->push_back({static_cast<std::uint8_t>(i % 200), 40, 90});
  auto half = pcl::make_shared<pcl::Indices>();
  for (pcl::index_t i = 0; i < 400; i += 2)
    half->push_back(i);
  using Change = std::function<void(Sampler&)>;
  const struct {
    std::string name;
    Change change;
  } changes[] = {{"start_index", [](Sampler& s) { s.setStartIndex(6); }},
                 {"reset of start_index", [](Sampler& s) { s.resetStartIndex(); }},
                 {"random_seed", [](Sampler& s) { s.setRandomSeed(5); }},
                 {"density", [](Sampler& s) { s.setDensityWeight(DensityWeight::on); }},
                 {"density_power", [](Sampler& s) { s.setDensityPower(0.5f); }},
                 {"isolated_neighbors", [](Sampler& s) { s.setIsolatedNeighbors(7); }},
                 {"colors", [&](Sampler& s) { s.setColors(colors); }},
                 {"color", [](Sampler& s) { s.setColorWeight(0.01f); }},
                 {"blind_spot", [](Sampler& s) { s.setFillBlindSpot(false); }},
                 {"search method",
                  [](Sampler& s) {
                    s.setSearchMethod(
                        pcl::make_shared<pcl::search::BruteForce<pcl::PointXYZ>>());
                  }},
                 {"memory budget", [](Sampler& s) { s.setMemoryBudget(1000); }},
                 {"candidates", [&](Sampler& s) { s.setSeedCandidates(half); }},
                 {"indices", [&](Sampler& s) { s.setIndices(half); }},
                 {"subsample", [](Sampler& s) { s.setSubsample(150); }},
                 {"no subsample", [](Sampler& s) { s.setSubsample(0); }},
                 {"search surface", [&](Sampler& s) { s.setSearchSurface(surface); }},
                 {"no search surface", [](Sampler& s) { s.setSearchSurface(nullptr); }},
                 {"input", [&](Sampler& s) { s.setInputCloud(cloud); }}};
  Sampler sampler = objectFor<Sampler>(cloud);
  proposalOf(sampler);
  for (std::size_t n = 0; n < std::size(changes); ++n) {
    SCOPED_TRACE(changes[n].name);
    const FieldCount fields;
    changes[n].change(sampler);
    EXPECT_FALSE(sampler.getPreparedScan());
    EXPECT_FALSE(sampler.getGrouping());
    EXPECT_TRUE(sampler.getProposal().seeds.empty());
    const SeedProposal found = proposalOf(sampler);
    EXPECT_EQ(fields.now(), 1u);
    EXPECT_EQ(sampler.getGrouping()->comparisons(), 12u);
    Sampler fresh = objectFor<Sampler>(cloud);
    for (std::size_t k = 0; k <= n; ++k)
      changes[k].change(fresh);
    const SeedProposal expected = proposalOf(fresh);
    EXPECT_EQ(found.seeds, expected.seeds);
    EXPECT_EQ(found.group, expected.group);
    EXPECT_EQ(found.coverage, expected.coverage);
    for (std::size_t i = 0; i < 400; ++i)
      if (found.group[i] >= 0) {
        EXPECT_EQ(found.cid[i], expected.cid[i]);
      }
  }
}

TEST(OnePreparation, RefusedSettingsPrepareNothing)
{
  Sampler sampler = objectFor<Sampler>(toCloud(twoBoxes(300, 208)));
  const SeedProposal before = proposalOf(sampler);
  const FieldCount fields;
  EXPECT_THROW(sampler.setSubsample(-1), CIDException);
  EXPECT_THROW(sampler.setStartIndex(-1), CIDException);
  EXPECT_THROW(sampler.setDensityPower(9.0f), CIDException);
  EXPECT_THROW(sampler.setIsolatedNeighbors(9), CIDException);
  EXPECT_THROW(sampler.setColorWeight(-1.0f), CIDException);
  EXPECT_THROW(sampler.setPreparedScan(nullptr), CIDException);
  EXPECT_EQ(sampler.getProposal().seeds, before.seeds);
  expectSameProposal(proposalOf(sampler), before);
  EXPECT_EQ(fields.now(), 0u);
}

TEST(OnePreparation, SetScanGivesWhatItsOwnPreparationGives)
{
  const Cloud::Ptr cloud = toCloud(twoBoxes(500, 209));
  Sampler sampler = objectFor<Sampler>(cloud);
  sampler.setSubsample(200);
  sampler.setRandomSeed(11);
  sampler.setDensityWeight(DensityWeight::on);
  sampler.setStartIndex(77);
  const SeedProposal expected = proposalOf(sampler);
  const FieldCount fields;
  Sampler other;
  other.setPreparedScan(sampler.getPreparedScan());
  other.setNumberOfSeeds(12);
  other.setNumberOfSamples(30);
  expectSameProposal(proposalOf(other), expected);
  EXPECT_EQ(other.getSubsample(), 200);
  EXPECT_EQ(other.getRandomSeed(), 11u);
  EXPECT_EQ(other.getDensityWeight(), DensityWeight::on);
  EXPECT_EQ(other.getStartIndex(), 77);
  EXPECT_TRUE(other.getDensityDecision().weighted);
  Abstraction abstraction;
  abstraction.setPreparedScan(sampler.getPreparedScan());
  abstraction.setNumberOfSeeds(12);
  abstraction.setNumberOfSamples(30);
  partsOf(abstraction);
  EXPECT_EQ(abstraction.getProposal().group, expected.group);
  EXPECT_EQ(fields.now(), 0u);

  other.setRandomSeed(12); // now there is nothing to prepare
  pcl::Indices seeds;
  EXPECT_THROW(other.sample(seeds), CIDException);
}

TEST(OnePreparation, InputMustBeTheOneThatWasPrepared)
{
  const Cloud::Ptr cloud = toCloud(twoBoxes(200, 210));
  Sampler sampler = objectFor<Sampler>(cloud);
  proposalOf(sampler);
  Propagation propagation;
  propagation.setInputCloud(toCloud(twoBoxes(199, 210)));
  propagation.setGrouping(sampler.getGrouping());
  pcl::PointCloud<pcl::PointXYZL> out;
  try {
    propagation.segment(out);
    ADD_FAILURE() << "not refused";
  }
  catch (const CIDException& error) {
    EXPECT_NE(std::string(error.what())
                  .find("the input cloud has 199 points; it must be "
                        "the one that was prepared, which has 200"),
              std::string::npos)
        << error.what();
  }
  EXPECT_TRUE(out.empty());
  EXPECT_EQ(labelsOf(propagation).size(), 200u) << "labels need no input";
  Propagation without_input;
  without_input.setGrouping(sampler.getGrouping());
  EXPECT_THROW(without_input.segment(out), CIDException);
  EXPECT_THROW(without_input.setGrouping(nullptr), CIDException);
  EXPECT_THROW(Abstraction().setGrouping(nullptr), CIDException);
  EXPECT_THROW(TightnessMeter(PreparedScan::ConstPtr(), TightnessOptions()),
               CIDException);
}

TEST(OnePreparation, CopiesOfAnObjectGoTheirOwnWays)
{
  Sampler sampler = objectFor<Sampler>(toCloud(twoBoxes(300, 211)));
  const SeedProposal twelve = proposalOf(sampler);
  const FieldCount fields;
  Sampler copy = sampler;
  pcl::Indices seeds;
  copy.extend(20, seeds);
  EXPECT_EQ(sampler.getGrouping()->numberOfSeeds(), 12u);
  expectSameProposal(proposalOf(sampler), twelve);
  sampler.extend(20, seeds);
  expectSameProposal(sampler.getProposal(), copy.getProposal());
  EXPECT_EQ(fields.now(), 0u);
}

TEST(OnePreparation, CancelledVerbKeepsWhatWasPrepared)
{
  Sampler sampler = objectFor<Sampler>(toCloud(twoBoxes(2000, 212)));
  const SeedProposal before = proposalOf(sampler);
  const FieldCount fields;
  sampler.setNumberOfSeeds(30);
  sampler.setProgressCallback([](double) { return false; });
  pcl::Indices seeds;
  EXPECT_THROW(sampler.sample(seeds), CIDCancelled);
  EXPECT_TRUE(sampler.getProposal().seeds.empty());
  sampler.setProgressCallback({});
  sampler.setNumberOfSeeds(12);
  expectSameProposal(proposalOf(sampler), before);
  EXPECT_EQ(sampler.getGrouping()->comparisons(), 12u);
  EXPECT_EQ(fields.now(), 0u);
}

} // namespace
} // namespace pcl_cid::test
