/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Boundaries mended: against the literal energy and all labelings of small clouds.
 */

#include "boundary/boundary_points.h"
#include "boundary/label_costs.h"
#include "clouds.h"
#include "literal_energy.h"
#include "prepared_points.h"
#include "scan/working_set.h"

#include <pcl_cid/core/concavity.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** Proposed seeds with labels in turn: many of each label, side by side. */
struct LabelledGrouping {
  LabelledGrouping(const PreparedScan::ConstPtr& scan,
                   std::size_t seeds,
                   std::uint32_t labels)
  : grouping(scan)
  {
    grouping.propose(seeds);
    for (std::uint32_t k = 0; k < grouping.numberOfSeeds(); ++k)
      label_of_seed.push_back(1 + k % labels);
  }

  Labels
  propagated() const
  {
    Labels labels;
    for (const pcl::index_t seed : grouping.groups())
      labels.push_back(seed < 0 ? 0 : label_of_seed[static_cast<std::size_t>(seed)]);
    return labels;
  }

  Labels
  cleaned(const CleaningSettings& settings = {}, unsigned int threads = 1) const
  {
    return cleanBoundaries(grouping, label_of_seed, settings, onThreads(threads));
  }

  Grouping grouping;
  Labels label_of_seed;
};

/** Weighted by spacing, and with colors in broad stripes. */
PreparedScan::ConstPtr
preparedWithCosts(const Points& points)
{
  RawScan scan = rawScan(points);
  for (const Eigen::Vector3f& p : scan.points.points)
    scan.colors.push_back(p.x() > 0.5f ? ColorRGB{200, 10, 10} : ColorRGB{10, 90, 200});
  PreparationSettings settings = plainSettings();
  settings.density = DensityWeight::on;
  settings.color = 0.001f;
  return std::make_shared<const PreparedScan>(std::move(scan), settings);
}

/** The labelings of one expansion move. */
std::vector<Labels>
movesTo(std::uint32_t alpha, const std::vector<Labels>& options, const Labels& labels)
{
  std::vector<Labels> moves;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    moves.push_back({labels[i]});
    if (alpha != labels[i] &&
        std::count(options[i].begin(), options[i].end(), alpha) > 0)
      moves.back().push_back(alpha);
  }
  return moves;
}

/** \return whether the cloud was small enough to look at all labelings */
bool
expectLowEnergy(const LabelledGrouping& labelled,
                std::uint32_t labels,
                const CleaningSettings& settings)
{
  const Labels start = labelled.propagated();
  const LiteralEnergy energy(
      labelled.grouping, labelled.label_of_seed, start, settings);
  if (energy.freePoints() == 0 || energy.freePoints() > (labels == 2 ? 12u : 9u))
    return false;
  const Labels cleaned = labelled.cleaned(settings);
  for (std::size_t i = 0; i < cleaned.size(); ++i) {
    const Labels& options = energy.options()[i];
    EXPECT_TRUE(std::count(options.begin(), options.end(), cleaned[i])) << i;
  }
  const double reached = energy.of(cleaned);
  const double least = leastEnergy(energy, energy.options());
  EXPECT_LE(reached, energy.of(start) + energy.tolerance());
  EXPECT_LE(reached, (labels == 2 ? 1.0 : 2.0) * least + energy.tolerance());
  for (std::uint32_t alpha = 1; alpha <= labels; ++alpha)
    EXPECT_GE(leastEnergy(energy, movesTo(alpha, energy.options(), cleaned)),
              reached - energy.tolerance());
  return true;
}

class SmallClouds : public testing::TestWithParam<std::uint32_t> {};

TEST_P(SmallClouds, HaveTheLeastEnergyOrNearlySo)
{
  const std::uint32_t labels = GetParam();
  int looked_at = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed)
    for (const float reach : {0.3f, 0.6f, 1.0f, 1.6f}) {
      SCOPED_TRACE(testing::Message() << "cloud " << seed << ", reach " << reach);
      const Points points = seed % 2 == 0 ? randomCube(25, seed) : twoBoxes(30, seed);
      const PreparedScan::ConstPtr scan =
          seed % 3 == 0 ? preparedWithCosts(points) : prepared(points);
      CleaningSettings settings;
      settings.reach = reach;
      settings.pull = seed % 5 == 0 ? 0.1f : 0.01f;
      settings.normal_scale = seed % 4 == 0 ? 1.0f : 0.1f;
      looked_at += expectLowEnergy({scan, 5, labels}, labels, settings);
    }
  EXPECT_GE(looked_at, 20);
}

INSTANTIATE_TEST_SUITE_P(Labels, SmallClouds, testing::Values(2u, 3u));

/** Boundary points by looking at all pairs. */
TEST(BoundaryPoints, AreThoseOfASearchOfAllPairs)
{
  std::mt19937_64 random(7);
  for (const NamedPoints& cloud : allClouds()) {
    SCOPED_TRACE(cloud.name);
    const PreparedScan::ConstPtr scan = prepared(cloud.points);
    const Points& points = scan->working().points();
    Labels labels;
    std::vector<bool> fixed;
    for (std::size_t i = 0; i < points.size(); ++i) {
      labels.push_back(points[i].x() > points[0].x()
                           ? static_cast<std::uint32_t>(random() % 3)
                           : 2u);
      fixed.push_back(random() % 10 == 0);
    }
    const float reach = 0.1f;
    Progress progress{{}};
    std::vector<Labels> near(points.size());
    for (const BoundaryPoint& each : findBoundaryPoints(
             scan->working(), labels, fixed, reach, 2, progress, {0.0, 1.0})) {
      EXPECT_TRUE(near[each.point].empty()) << "given twice";
      near[each.point] = each.labels;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::vector<bool> found(3, false);
      found[labels[i]] = true;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const Eigen::Vector3f d = points[i] - points[k];
        if ((d.x() * d.x() + d.y() * d.y()) + d.z() * d.z() <= reach * reach)
          found[labels[k]] = true;
      }
      Labels expected;
      if (found[1] && found[2] && labels[i] != 0 && !fixed[i])
        expected = {1, 2};
      ASSERT_EQ(near[i], expected) << i;
    }
  }
}

/** The library's own CID of all pairs, to the bit. */
TEST(LabelCosts, AreThoseOfAllPairs)
{
  constexpr float most_loss = 0.05f;
  for (const auto& scan :
       {prepared(twoBoxes(400, 1)), preparedWithCosts(randomCube(300, 2))}) {
    const LabelledGrouping labelled(scan, 12, 4);
    const WorkingPoints& points = scan->working();
    std::vector<BoundaryPoint> boundary;
    for (std::size_t i = 0; i < points.size(); ++i)
      boundary.push_back({i, {1, 2, 3, 4}});
    Progress progress{{}};
    const auto choices = labelCosts(labelled.grouping,
                                    labelled.label_of_seed,
                                    labelled.grouping.groups(),
                                    boundary,
                                    most_loss,
                                    2,
                                    progress,
                                    {0.0, 1.0});
    const pcl::Indices seeds = labelled.grouping.seeds();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (std::count(seeds.begin(), seeds.end(), static_cast<pcl::index_t>(i)))
        continue; // with itself, whatever it costs
      std::vector<float> smallest(5, std::numeric_limits<float>::infinity());
      for (std::size_t s = 0; s < seeds.size(); ++s) {
        const auto q = static_cast<std::size_t>(seeds[s]);
        float& least = smallest[labelled.label_of_seed[s]];
        least = std::min(least,
                         points.costs().between(q, i).of(
                             pointCID(points.field(),
                                      points.points()[q],
                                      points.points()[i],
                                      labelled.grouping.settings().samples)));
      }
      const double best = double{*std::min_element(smallest.begin(), smallest.end())};
      ASSERT_EQ(choices[i].size(), 4u);
      for (const LabelEnergy::Choice& choice : choices[i])
        ASSERT_EQ(choice.cost,
                  wholeUnits(std::min(double{smallest[choice.label]} - best,
                                      double{most_loss})))
            << i;
    }
  }
}

TEST(CleanBoundaries, IsTheSameOnAllThreads)
{
  for (const auto& scan :
       {prepared(twoBoxes(4000, 1)), preparedWithCosts(randomCube(3000, 2))}) {
    const LabelledGrouping labelled(scan, 20, 6);
    const Labels cleaned = labelled.cleaned();
    EXPECT_NE(cleaned, labelled.propagated());
    for (const unsigned int threads : {2u, 3u, 8u})
      EXPECT_EQ(labelled.cleaned({}, threads), cleaned);
  }
}

class CleaningOfClouds : public testing::TestWithParam<NamedPoints> {};

TEST_P(CleaningOfClouds, KeepsWhatIsFixed)
{
  const PreparedScan::ConstPtr scan = prepared(GetParam().points);
  const LabelledGrouping labelled(scan, 10, 3);
  const Labels start = labelled.propagated();
  const Labels cleaned = labelled.cleaned();
  ASSERT_EQ(cleaned.size(), start.size());
  const pcl::Indices seeds = labelled.grouping.seeds();
  for (std::size_t s = 0; s < seeds.size(); ++s)
    EXPECT_EQ(cleaned[static_cast<std::size_t>(seeds[s])], labelled.label_of_seed[s]);
  CleaningSettings settings;
  settings.pull = 0.0f;
  EXPECT_EQ(labelled.cleaned(settings), start) << "every point has its best label";
  settings = {};
  settings.most_cycles = 0;
  EXPECT_EQ(labelled.cleaned(settings), start);
}

TEST_P(CleaningOfClouds, HasNothingToDoForOneLabel)
{
  const PreparedScan::ConstPtr scan = prepared(GetParam().points);
  for (const std::size_t seeds : {1u, 5u}) {
    const LabelledGrouping labelled(scan, seeds, 1);
    EXPECT_EQ(labelled.cleaned(), labelled.propagated());
  }
}

INSTANTIATE_TEST_SUITE_P(AllClouds,
                         CleaningOfClouds,
                         testing::ValuesIn(allClouds()),
                         [](const auto& info) { return info.param.name; });

TEST(CleanBoundaries, LeavesLabelZeroAlone)
{
  LabelledGrouping labelled(prepared(twoBoxes(2000, 5)), 20, 4);
  for (std::uint32_t& label : labelled.label_of_seed)
    label -= 1;
  const Labels start = labelled.propagated();
  const Labels cleaned = labelled.cleaned();
  EXPECT_NE(cleaned, start);
  for (std::size_t i = 0; i < start.size(); ++i)
    EXPECT_EQ(cleaned[i] == 0, start[i] == 0) << i;
}

TEST(CleanBoundaries, FollowersFollow)
{
  PreparationSettings settings = plainSettings();
  settings.subsample = 500;
  Points points = twoBoxes(3000, 6);
  points.insert(points.begin(), points.back()); // a duplicate
  const PreparedScan::ConstPtr scan = prepared(points, settings);
  const LabelledGrouping labelled(scan, 20, 5);
  const Labels start = labelled.propagated();
  const Labels cleaned = labelled.cleaned();
  EXPECT_NE(cleaned, start);
  // Whoever follows the same point as another has its label.
  const auto follows = scan->workingSet().carryOn(
      [&] {
        pcl::Indices own(scan->working().size());
        std::iota(own.begin(), own.end(), 0);
        return own;
      }(),
      scan->cloudSize(),
      pcl::index_t{-1});
  std::vector<std::uint32_t> label_of(scan->working().size(), 0);
  for (std::size_t i = 0; i < cleaned.size(); ++i) {
    std::uint32_t& label = label_of[static_cast<std::size_t>(follows[i])];
    EXPECT_TRUE(label == 0 || label == cleaned[i]) << i;
    label = cleaned[i];
  }
}

TEST(CleanBoundaries, RefusesWhatItCannotUse)
{
  const LabelledGrouping labelled(prepared(randomCube(50, 1)), 5, 2);
  EXPECT_THROW(cleanBoundaries(labelled.grouping, {1, 2}), CIDException);
  for (float CleaningSettings::*value : {&CleaningSettings::reach,
                                         &CleaningSettings::most_loss,
                                         &CleaningSettings::pull,
                                         &CleaningSettings::normal_scale,
                                         &CleaningSettings::color_scale}) {
    CleaningSettings settings;
    settings.*value = -1.0f;
    EXPECT_THROW(labelled.cleaned(settings), CIDException);
    settings.*value = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(labelled.cleaned(settings), CIDException);
  }
  CleaningSettings settings;
  settings.most_cycles = -1;
  EXPECT_THROW(labelled.cleaned(settings), CIDException);
}

TEST(CleanBoundaries, WithoutSeedsNothingHasALabel)
{
  const Grouping grouping(prepared(randomCube(50, 1)));
  EXPECT_EQ(cleanBoundaries(grouping, {}), Labels(50, 0));
}

TEST(CleanBoundaries, CanBeCancelledAndTellsHowFarItIs)
{
  const LabelledGrouping labelled(prepared(twoBoxes(3000, 4)), 20, 5);
  double told = 0.0;
  ExecutionOptions execution = onThreads(2);
  execution.progress = [&](double fraction) {
    EXPECT_GE(fraction, told);
    told = fraction;
    return true;
  };
  cleanBoundaries(labelled.grouping, labelled.label_of_seed, {}, execution);
  EXPECT_EQ(told, 1.0);
  execution.progress = [](double) { return false; };
  EXPECT_THROW(
      cleanBoundaries(labelled.grouping, labelled.label_of_seed, {}, execution),
      CIDCancelled);
}

} // namespace
} // namespace pcl_cid::test
