/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A grouping after any history equals one from scratch, and all pairs.
 */

#include "base/random.h"
#include "cid/working_points.h"
#include "clouds.h"
#include "grouping/connected_groups.h"
#include "prepared_points.h"
#include "sanitizers.h"
#include "scan/working_set.h"

#include <pcl_cid/core/concavity.h>
#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/grouping.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/** All that a grouping says of its seeds and points. */
struct State {
  pcl::Indices seeds;
  std::vector<pcl::index_t> groups;
  std::vector<float> cids;
  float coverage;
};

State
stateOf(const Grouping& grouping)
{
  return {grouping.seeds(), grouping.groups(), grouping.cids(), grouping.coverage()};
}

bool
sameBits(const std::vector<float>& a, const std::vector<float>& b)
{
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}

void
expectSame(const State& a, const State& b)
{
  EXPECT_EQ(a.seeds, b.seeds);
  EXPECT_EQ(a.groups, b.groups);
  EXPECT_TRUE(sameBits(a.cids, b.cids));
  EXPECT_TRUE(sameBits({a.coverage}, {b.coverage})) << a.coverage << " " << b.coverage;
}

/** The state, and the history that goes with it. */
struct Whole {
  State state;
  std::vector<float> coverages;
  std::size_t comparisons;
};

Whole
wholeOf(const Grouping& grouping)
{
  return {stateOf(grouping), grouping.proposal().coverage, grouping.comparisons()};
}

void
expectSame(const Whole& a, const Whole& b)
{
  expectSame(a.state, b.state);
  EXPECT_TRUE(sameBits(a.coverages, b.coverages));
  EXPECT_EQ(a.comparisons, b.comparisons);
}

Grouping
fromScratch(const Grouping& grouping)
{
  Grouping scratch(grouping.sharedScan(), grouping.settings());
  scratch.addSeeds(grouping.seeds());
  return scratch;
}

/** Coverages are those of the seeds in this order, as far as they are known. */
void
expectCoveragesOf(const std::vector<float>& known, const std::vector<float>& all)
{
  ASSERT_EQ(known.size(), all.size());
  for (std::size_t k = 0; k < all.size(); ++k)
    EXPECT_TRUE(std::isnan(known[k]) || known[k] == all[k]) << k;
  if (!known.empty()) {
    EXPECT_FALSE(std::isnan(known.back()));
  }
}

void
expectEqualsScratch(const Grouping& grouping)
{
  const Grouping scratch = fromScratch(grouping);
  expectSame(stateOf(grouping), stateOf(scratch));
  expectCoveragesOf(grouping.proposal().coverage, scratch.proposal().coverage);
}

/** D_min and its argument by all pairs of points that are worked on and seeds. */
class AllPairs {
public:
  explicit AllPairs(const Grouping& grouping)
  : scan_(grouping.scan())
  , points_(scan_.working().points())
  , samples_(grouping.settings().samples)
  , seeds_(grouping.seeds())
  , group_(points_.size(), -1)
  , cid_(points_.size(), nan)
  {
    for (std::size_t k = 0; k < seeds_.size(); ++k) {
      const auto seed = static_cast<std::size_t>(scan_.workingIndex(seeds_[k], "seed"));
      for (std::size_t i = 0; i < points_.size(); ++i)
        if (const float cost = costOf(seed, i); k == 0 || cost < cid_[i]) {
          cid_[i] = cost;
          group_[i] = static_cast<pcl::index_t>(k);
        }
    }
    for (std::size_t k = 0; k < seeds_.size(); ++k) // whatever it costs
      group_[static_cast<std::size_t>(scan_.workingIndex(seeds_[k], "seed"))] =
          static_cast<pcl::index_t>(k);
    connect();
  }

  State
  state() const
  {
    float coverage = seeds_.empty() ? nan : 0.0f;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (!seeds_.empty() && !isIn(scan_.isolated(), i))
        coverage = std::max(coverage, cid_[i]);
    return {seeds_,
            scan_.workingSet().carryOn(group_, scan_.cloudSize(), pcl::index_t{-1}),
            scan_.workingSet().carryOn(cid_, scan_.cloudSize(), nan),
            coverage};
  }

  /** The next seed by Algorithm 1, an index of the cloud; -1 when there is none. */
  pcl::index_t
  farthest() const
  {
    float largest = -1.0f;
    pcl::index_t farthest = -1;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (mayBecomeSeed(i) && cid_[i] > costOf(i, i) && cid_[i] > largest) {
        largest = cid_[i];
        farthest = scan_.workingSet().cloudIndexOf(static_cast<pcl::index_t>(i));
      }
    return farthest;
  }

private:
  /** By the same function: connected_groups_test.cpp has a literal search for it. */
  void
  connect()
  {
    if (!scan_.graph())
      return;
    Progress silent(nullptr);
    pcl::Indices seeds;
    for (const pcl::index_t seed : seeds_)
      seeds.push_back(scan_.workingIndex(seed, "seed"));
    group_ = ConnectedGroups(*scan_.graph(), scan_.working(), samples_)
                 .connect(seeds, std::move(group_), 1, silent);
  }

  static bool
  isIn(const pcl::Indices& indices, std::size_t i)
  {
    return std::find(indices.begin(), indices.end(), static_cast<pcl::index_t>(i)) !=
           indices.end();
  }

  bool
  mayBecomeSeed(std::size_t i) const
  {
    return !isIn(scan_.isolated(), i) &&
           (scan_.candidates().empty() || isIn(scan_.candidates(), i));
  }

  float
  costOf(std::size_t seed, std::size_t point) const
  {
    return scan_.working()
        .costs()
        .between(seed, point)
        .of(pointCID(scan_.field(), points_[seed], points_[point], samples_));
  }

  const PreparedScan& scan_;
  const Points& points_;
  int samples_;
  pcl::Indices seeds_;
  std::vector<pcl::index_t> group_;
  std::vector<float> cid_;
};

void
expectEqualsAllPairs(const Grouping& grouping)
{
  expectSame(stateOf(grouping), AllPairs(grouping).state());
}

/** Seeds come and go at random; what is done is checked on the way. */
class RandomHistory {
public:
  RandomHistory(const PreparedScan::ConstPtr& scan,
                const GroupingSettings& settings,
                std::uint64_t random_seed)
  : generator_(random_seed), grouping_(scan, settings)
  {
  }

  const Grouping&
  grouping() const
  {
    return grouping_;
  }

  void
  step()
  {
    switch (draw(7)) {
    case 0:
    case 1:
      propose();
      break;
    case 2:
      grouping_.addSeeds(newSeeds(), execution());
      break;
    case 3:
      grouping_.insertSeeds(newSeeds(), draw(seeds() + 1), execution());
      break;
    case 4:
      addAndTakeAwayAgain();
      break;
    case 5:
      takeAwayAndInsertAgain();
      break;
    default:
      grouping_.removeSeeds(someNumbers(), execution());
    }
  }

private:
  std::size_t
  draw(std::size_t count)
  {
    return drawBelow(generator_, count);
  }

  std::size_t
  seeds() const
  {
    return grouping_.numberOfSeeds();
  }

  ExecutionOptions
  execution()
  {
    ExecutionOptions execution = onThreads(draw(2) == 0 ? 1 : 3);
    if (draw(3) == 0) // it works on a copy then
      execution.progress = [](double) { return true; };
    return execution;
  }

  pcl::index_t
  anyPoint()
  {
    const WorkingSet& set = grouping_.scan().workingSet();
    return set.cloudIndexOf(static_cast<pcl::index_t>(draw(set.points().size())));
  }

  pcl::Indices
  newSeeds()
  {
    pcl::Indices seeds;
    pcl::Indices taken = grouping_.seeds();
    for (std::size_t tries = 1 + draw(4); tries > 0; --tries)
      if (const pcl::index_t point = anyPoint();
          std::find(taken.begin(), taken.end(), point) == taken.end()) {
        seeds.push_back(point);
        taken.push_back(point);
      }
    return seeds;
  }

  /** In any order; all of them at times. */
  std::vector<std::size_t>
  someNumbers()
  {
    std::vector<std::size_t> numbers;
    const bool all = draw(10) == 0;
    for (std::size_t k = 0; k < seeds(); ++k)
      if (all || draw(3) == 0)
        numbers.insert(
            numbers.begin() + static_cast<std::ptrdiff_t>(draw(numbers.size() + 1)), k);
    return numbers;
  }

  /** On from here it goes as from scratch. */
  void
  propose()
  {
    const std::size_t wanted = seeds() + 1 + draw(4);
    const float coverage =
        draw(3) == 0 && seeds() > 0 ? 0.7f * grouping_.coverage() : 0;
    Grouping scratch = fromScratch(grouping_);
    const bool is_plain = grouping_.settings().seeding == SeedingRule::farthest;
    const pcl::index_t expected =
        is_plain && seeds() > 0 ? AllPairs(grouping_).farthest() : -1;
    const std::size_t before = seeds();
    const ProposalStop stop = grouping_.propose(wanted, coverage, execution());
    EXPECT_EQ(scratch.propose(wanted, coverage), stop);
    EXPECT_EQ(scratch.seeds(), grouping_.seeds());
    if (expected >= 0 && seeds() > before) {
      EXPECT_EQ(grouping_.seeds()[before], expected);
    }
    if (stop == ProposalStop::seeds) {
      EXPECT_EQ(seeds(), wanted);
    }
    if (stop == ProposalStop::coverage) {
      EXPECT_LE(grouping_.coverage(), coverage);
    }
  }

  void
  addAndTakeAwayAgain()
  {
    const Whole before = wholeOf(grouping_);
    const pcl::Indices added = newSeeds();
    grouping_.addSeeds(added, execution());
    std::vector<std::size_t> numbers;
    for (std::size_t k = before.state.seeds.size(); k < seeds(); ++k)
      numbers.push_back(k);
    grouping_.removeSeeds(numbers, execution());
    expectSame(stateOf(grouping_), before.state);
    EXPECT_TRUE(sameBits(grouping_.proposal().coverage, before.coverages));
  }

  void
  takeAwayAndInsertAgain()
  {
    const State before = stateOf(grouping_);
    std::vector<std::size_t> numbers = someNumbers();
    grouping_.removeSeeds(numbers, execution());
    std::sort(numbers.begin(), numbers.end());
    for (const std::size_t number : numbers)
      grouping_.insertSeeds({before.seeds[number]}, number, execution());
    expectSame(stateOf(grouping_), before);
  }

  RandomGenerator generator_;
  Grouping grouping_;
};

struct NamedScan {
  std::string name;
  PreparedScan::ConstPtr scan;
};

PreparedScan::ConstPtr
weighted(const Points& points)
{
  RawScan scan = rawScan(points);
  for (std::size_t i = 0; i < points.size(); ++i)
    scan.colors.push_back({static_cast<std::uint8_t>(points[i].x() > 0.5f ? 200 : 30),
                           static_cast<std::uint8_t>(i % 7),
                           90});
  PreparationSettings settings = plainSettings();
  settings.density = DensityWeight::on;
  settings.density_power = 0.7f;
  settings.color = 0.002f;
  settings.normals = 0.02f;
  settings.connected = true;
  return std::make_shared<const PreparedScan>(scan, settings);
}

/** Points that hover over a surface of some of them. */
PreparedScan::ConstPtr
aboveASurface(const Points& points)
{
  RawScan scan = rawScan(points);
  for (std::size_t i = 0; i < points.size(); i += 2)
    scan.surface.push_back(scan.points.points[i] + Eigen::Vector3f(0.01f, 0.0f, 0.1f));
  return std::make_shared<const PreparedScan>(scan, plainSettings());
}

/** The farther up, the sparser they are: to itself a point costs more than to the
 * sparser ones. */
PreparedScan::ConstPtr
unevenAboveASurface(const Points& points)
{
  RawScan scan = rawScan(points);
  for (std::size_t i = 0; i < points.size(); i += 2)
    scan.surface.push_back(scan.points.points[i] - Eigen::Vector3f(0.0f, 0.0f, 0.5f));
  for (Eigen::Vector3f& p : scan.points.points)
    p.z() += 2.0f * p.z() * p.z();
  PreparationSettings settings = plainSettings();
  settings.density = DensityWeight::on;
  return std::make_shared<const PreparedScan>(scan, settings);
}

/** Every way in which points can be prepared that makes a difference to a grouping. */
std::vector<NamedScan>
scansOf(const Points& points)
{
  PreparationSettings subsample = plainSettings();
  subsample.subsample = static_cast<int>(points.size() / 2 + 1);
  subsample.required = {0};
  PreparationSettings isolated = plainSettings();
  isolated.isolated_neighbors = 8;
  PreparationSettings candidates = plainSettings();
  auto third = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < points.size(); i += 3)
    third->push_back(static_cast<pcl::index_t>(i));
  candidates.seed_candidates = third;
  candidates.isolated_neighbors = 6;
  return {{"plain", prepared(points)},
          {"weighted", weighted(points)},
          {"above_a_surface", aboveASurface(points)},
          {"uneven_above_a_surface", unevenAboveASurface(points)},
          {"subsample", prepared(points, subsample)},
          {"isolated", prepared(points, isolated)},
          {"candidates", prepared(points, candidates)}};
}

std::vector<NamedPoints>
cloudsAndCrops()
{
  std::vector<NamedPoints> clouds = allClouds();
  for (const char* name : {"office1", "room_scan1", "mosd_learn41"})
    if (const auto scan = loadSharedScan(std::string(name) + ".pcd"))
      clouds.push_back({name, crop(*scan, 300, 23)});
  return clouds;
}

class GroupingHistoryThreads : public testing::TestWithParam<NamedPoints> {};

/** 84 histories of 5 steps for each of 12 clouds make a thousand. */
constexpr std::uint64_t histories = is_sanitized ? 28 : 84;

TEST_P(GroupingHistoryThreads, EqualsScratchAndAllPairs)
{
  const std::vector<NamedScan> scans = scansOf(GetParam().points);
  for (std::uint64_t history = 0; history < histories; ++history) {
    const NamedScan& scan = scans[history % scans.size()];
    SCOPED_TRACE(scan.name + ", history " + std::to_string(history));
    GroupingSettings settings;
    settings.samples = history % 5 == 0 ? 2 : 20;
    settings.keep_cid = history / scans.size() % 2 == 0;
    settings.seeding = history % 4 == 3 ? SeedingRule::soft : SeedingRule::farthest;
    RandomHistory random(scan.scan, settings, history);
    for (int step = 0; step < 5; ++step) {
      random.step();
      expectEqualsScratch(random.grouping());
      if (HasFailure())
        return;
    }
    expectEqualsAllPairs(random.grouping());
  }
}

INSTANTIATE_TEST_SUITE_P(Clouds,
                         GroupingHistoryThreads,
                         testing::ValuesIn(cloudsAndCrops()),
                         [](const auto& info) { return info.param.name; });

/** With hundreds of blocks and of seeds. */
TEST(GroupingThreads, EqualsScratchOnLargerScansAfterALongHistory)
{
  constexpr std::size_t size = is_sanitized ? 2500 : 6000;
  std::vector<NamedPoints> clouds = {{"two_boxes", twoBoxes(size, 61)}};
  for (const char* name : {"office1.pcd", "milk_cartoon_all_small_clorox.pcd"})
    if (const auto scan = loadSharedScan(name))
      clouds.push_back({name, crop(*scan, size, 7)});
  for (const NamedPoints& cloud : clouds)
    for (const PreparedScan::ConstPtr& scan :
         {prepared(cloud.points), weighted(cloud.points)}) {
      SCOPED_TRACE(cloud.name);
      GroupingSettings settings;
      settings.samples = 50;
      Grouping grouping(scan, settings);
      grouping.propose(150);
      std::vector<std::size_t> numbers;
      for (std::size_t k = 3; k < grouping.numberOfSeeds(); k += 7)
        numbers.push_back(k);
      const State before = stateOf(grouping);
      grouping.removeSeeds(numbers, onThreads(3));
      expectEqualsScratch(grouping);
      for (const std::size_t number : numbers)
        grouping.insertSeeds({before.seeds[number]}, number);
      expectSame(stateOf(grouping), before);
      grouping.removeSeeds({0, 1, 2});
      grouping.propose(180);
      pcl::Indices others;
      const pcl::Indices seeds = grouping.seeds();
      for (pcl::index_t i = 0; others.size() < 2; i += 11)
        if (std::find(seeds.begin(), seeds.end(), i) == seeds.end())
          others.push_back(i);
      grouping.insertSeeds(others, 90);
      expectEqualsScratch(grouping);
      EXPECT_EQ(grouping.numberOfSeeds(), 182u);
    }
}

TEST(Grouping, ProposalIsTheStateWithCoverages)
{
  Grouping grouping(prepared(twoBoxes(300, 62)), {20, SeedingRule::farthest, true});
  EXPECT_EQ(grouping.numberOfSeeds(), 0u);
  EXPECT_TRUE(std::isnan(grouping.coverage()));
  EXPECT_EQ(grouping.groups(), std::vector<pcl::index_t>(300, -1));
  EXPECT_EQ(grouping.groupsOfWorkingPoints(), std::vector<pcl::index_t>(300, -1));
  for (const float cid : grouping.cids())
    EXPECT_TRUE(std::isnan(cid));
  EXPECT_TRUE(grouping.proposal().coverage.empty());
  EXPECT_EQ(grouping.propose(9), ProposalStop::seeds);
  const SeedProposal proposal = grouping.proposal();
  EXPECT_EQ(proposal.seeds, grouping.seeds());
  EXPECT_EQ(proposal.group, grouping.groups());
  EXPECT_EQ(proposal.cid, grouping.cids());
  EXPECT_EQ(proposal.coverage.size(), 9u);
  EXPECT_EQ(proposal.coverage.back(), grouping.coverage());
  EXPECT_EQ(grouping.comparisons(), 9u);
  grouping.addSeeds({grouping.seeds()[3] == 8 ? 9 : 8});
  EXPECT_EQ(grouping.comparisons(), 10u);
  grouping.removeSeeds({9, 2});
  EXPECT_EQ(grouping.comparisons(), 10u) << "taking away compares no seed with all";
  const std::vector<float> coverage = grouping.proposal().coverage;
  ASSERT_EQ(coverage.size(), 8u);
  EXPECT_EQ(coverage[1], proposal.coverage[1]);
  EXPECT_TRUE(std::isnan(coverage[2]));
  EXPECT_EQ(coverage.back(), grouping.coverage());
}

TEST(Grouping, SaysWhyProposingStopped)
{
  Grouping grouping(prepared(twoBoxes(300, 63)));
  EXPECT_EQ(grouping.propose(4), ProposalStop::seeds);
  EXPECT_EQ(grouping.propose(4), ProposalStop::seeds) << "there are as many";
  EXPECT_EQ(grouping.propose(2), ProposalStop::seeds) << "there are more";
  EXPECT_EQ(grouping.numberOfSeeds(), 4u);
  EXPECT_EQ(grouping.propose(300, 2.0f * grouping.coverage()), ProposalStop::coverage);
  EXPECT_EQ(grouping.numberOfSeeds(), 4u);
  EXPECT_EQ(grouping.propose(300, 0.5f * grouping.coverage()), ProposalStop::coverage);
  EXPECT_GT(grouping.numberOfSeeds(), 4u);
  Grouping of_one(prepared(Points(20, Eigen::Vector3f(1, 2, 3))));
  EXPECT_EQ(of_one.propose(5), ProposalStop::no_gain);
  EXPECT_EQ(of_one.numberOfSeeds(), 1u);
  EXPECT_EQ(of_one.propose(1), ProposalStop::seeds);
}

/** A callback that is told of every step, since it takes its time, and stops the n-th.
 */
ProgressCallback
stopAt(int step)
{
  return [step, told = 0](double) mutable {
    std::this_thread::sleep_for(std::chrono::milliseconds(51));
    return ++told < step;
  };
}

TEST(Grouping, CancelledVerbChangesNothing)
{
  using Verb = std::function<void(Grouping&, const ExecutionOptions&)>;
  const std::vector<Verb> verbs = {
      [](Grouping& g, const auto& execution) { g.propose(90, 0.0f, execution); },
      [](Grouping& g, const auto& execution) {
        g.addSeeds({5, 17, 101}, execution);
      },
      [](Grouping& g, const auto& execution) {
        g.insertSeeds({5, 17, 101}, 2, execution);
      },
      [](Grouping& g, const auto& execution) {
        g.removeSeeds({1, 2, 3, 30, 33}, execution);
      }};
  Points points = twoBoxes(9000, 64);
  Grouping grouping(prepared(points));
  grouping.propose(40);
  const Whole before = wholeOf(grouping);
  for (const pcl::index_t seed : {5, 17, 101})
    ASSERT_EQ(std::count(before.state.seeds.begin(), before.state.seeds.end(), seed),
              0);
  RandomGenerator generator(9);
  for (std::size_t v = 0; v < verbs.size(); ++v)
    for (const int most : {1, 4, 12}) {
      SCOPED_TRACE(v);
      ExecutionOptions execution = onThreads(2);
      execution.progress = stopAt(
          1 + static_cast<int>(drawBelow(generator, static_cast<unsigned>(most))));
      EXPECT_THROW(verbs[v](grouping, execution), CIDCancelled);
      expectSame(wholeOf(grouping), before);
      execution.progress = [](double) -> bool { throw std::runtime_error("mine"); };
      EXPECT_THROW(verbs[v](grouping, execution), std::runtime_error);
      expectSame(wholeOf(grouping), before);
    }
  // And it is as good as before.
  grouping.propose(45);
  expectEqualsScratch(grouping);
}

TEST(Grouping, ResultsCanBeCancelled)
{
  Grouping grouping(prepared(twoBoxes(500, 65)));
  grouping.propose(5);
  ExecutionOptions execution;
  execution.progress = [](double) { return false; };
  EXPECT_THROW(grouping.groups(execution), CIDCancelled);
  EXPECT_THROW(grouping.cids(execution), CIDCancelled);
  EXPECT_THROW(grouping.proposal(execution), CIDCancelled);
}

/** \a act throws a CIDException that says so. */
template <typename Act>
void
expectRefused(const Act& act, const std::string& says)
{
  try {
    act();
    ADD_FAILURE() << "not refused: " << says;
  }
  catch (const CIDException& error) {
    EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
  }
}

TEST(Grouping, RefusesBadSeedsAndNumbersAndChangesNothing)
{
  Points points = twoBoxes(100, 66);
  points[7].y() = nan;
  Grouping grouping(prepared(points));
  grouping.propose(6);
  const Whole before = wholeOf(grouping);
  const pcl::index_t seed = before.state.seeds[3];
  pcl::index_t other = 50;
  while (std::count(before.state.seeds.begin(), before.state.seeds.end(), other) > 0)
    ++other;
  const std::string twice = " is a seed already; a point can be a seed only once";
  const struct {
    pcl::Indices seeds;
    std::string says;
  } bad[] = {
      {{seed}, "point " + std::to_string(seed) + twice},
      {{other, seed}, "point " + std::to_string(seed) + twice},
      {{other, other}, "point " + std::to_string(other) + twice},
      {{7}, "the seed is point 7; it must be a finite, selected point of the input"},
      {{other, -1}, "the seed is point -1; it must be"},
      {{100}, "the seed is point 100; it must be"},
  };
  for (const auto& each : bad) {
    expectRefused([&] { grouping.addSeeds(each.seeds); }, each.says);
    expectRefused([&] { grouping.insertSeeds(each.seeds, 0); }, each.says);
    expectRefused([&] { grouping.insertSeeds(each.seeds, 6); }, each.says);
  }
  expectRefused(
      [&] { grouping.insertSeeds({other}, 7); },
      "the number to insert seeds at is 7; it must be 0 to 6 (after the last)");
  expectRefused([&] { grouping.removeSeeds({6}); },
                "the number of a seed to take away is 6; each must be 0 to 6 - 1");
  expectRefused(
      [&] {
        grouping.removeSeeds({2, 4, 2});
      },
      "the number of a seed to take away is 2; each must be 0 to 6 - 1 (the "
      "seeds), and be given once");
  expectRefused([&] { grouping.propose(0); },
                "the number of seeds is 0; it must be at least 1");
  for (const float coverage : {-0.1f, nan, INFINITY})
    expectRefused([&] { grouping.propose(9, coverage); }, "the coverage is ");
  expectSame(wholeOf(grouping), before);
  grouping.addSeeds({});
  grouping.insertSeeds({}, 3);
  grouping.removeSeeds({});
  expectSame(stateOf(grouping), before.state);
}

void
expectSeedsKeepTheirPoints(const Grouping& grouping)
{
  const pcl::Indices seeds = grouping.seeds();
  const std::vector<pcl::index_t> groups = grouping.groups();
  for (std::size_t k = 0; k < seeds.size(); ++k)
    EXPECT_EQ(groups[static_cast<std::size_t>(seeds[k])], static_cast<pcl::index_t>(k));
  EXPECT_EQ(mergeGroups(grouping).numberOfGroups(), seeds.size());
}

TEST(Grouping, SeedsKeepTheirPointsAwayFromTheSurface)
{
  for (const bool uneven : {false, true}) {
    const Points points = twoBoxes(200, 77);
    Grouping grouping(uneven ? unevenAboveASurface(points) : aboveASurface(points));
    pcl::Indices seeds;
    for (pcl::index_t i = 0; i < 40; ++i)
      seeds.push_back(5 * i);
    grouping.addSeeds(seeds);
    expectSeedsKeepTheirPoints(grouping);
    expectEqualsAllPairs(grouping);
    grouping.removeSeeds({3, 0, 20});
    expectSeedsKeepTheirPoints(grouping);
    grouping.insertSeeds({0, 7, 9}, 5);
    grouping.propose(45);
    expectSeedsKeepTheirPoints(grouping);
    expectEqualsAllPairs(grouping);
    expectEqualsScratch(grouping);
  }
}

TEST(Grouping, SeedsAtOnePlaceKeepTheirPoints)
{
  Points points = randomCube(60, 78);
  points.insert(points.end(), 4, points[10]);
  Grouping grouping(prepared(points));
  grouping.addSeeds({60, 10, 61});
  grouping.insertSeeds({63}, 0); // the first takes the others at this place
  const std::vector<pcl::index_t> groups = grouping.groups();
  EXPECT_EQ(groups[62], 0);
  EXPECT_EQ(std::count(groups.begin(), groups.end(), 1), 1);
  expectSeedsKeepTheirPoints(grouping);
  expectEqualsAllPairs(grouping);
  expectEqualsScratch(grouping);
}

TEST(Grouping, RefusesBadSettings)
{
  const PreparedScan::ConstPtr scan = prepared(randomCube(10, 67));
  for (const int samples : {1, 0, -3, (1 << 20) + 1}) {
    GroupingSettings settings;
    settings.samples = samples;
    expectRefused([&] { Grouping(scan, settings); },
                  "the number of samples on a segment is " + std::to_string(samples) +
                      "; it must be a whole number, 2 to 1048576");
  }
  expectRefused([] { Grouping(nullptr); }, "there is no prepared scan to group");
}

TEST(Grouping, RefusesASeedThatTheSubsampleDoesNotHold)
{
  PreparationSettings settings = plainSettings();
  settings.subsample = 40;
  Grouping grouping(prepared(twoBoxes(100, 68), settings));
  grouping.propose(5);
  const Whole before = wholeOf(grouping);
  int refused = 0;
  for (pcl::index_t point = 0; point < 100; ++point)
    if (grouping.scan().workingSet().indexOf(point) < 0) {
      ++refused;
      expectRefused([&] { grouping.addSeeds({point}); },
                    "which the subsample of 40 points does not hold");
    }
  EXPECT_EQ(refused, 60);
  expectSame(wholeOf(grouping), before);
}

TEST(Grouping, CopiesAreIndependent)
{
  for (const NamedScan& scan : scansOf(twoBoxes(400, 69))) {
    SCOPED_TRACE(scan.name);
    auto original = std::make_unique<Grouping>(scan.scan);
    original->propose(10);
    const Whole before = wholeOf(*original);
    Grouping copy = *original;
    expectSame(wholeOf(copy), before);
    EXPECT_EQ(copy.sharedScan(), original->sharedScan());
    copy.removeSeeds({0, 4});
    copy.propose(20);
    expectEqualsScratch(copy);
    expectSame(wholeOf(*original), before);
    original->addSeeds({copy.seeds().back()});
    expectEqualsScratch(*original);
    original.reset();
    expectEqualsScratch(copy);
    const Whole of_copy = wholeOf(copy);
    Grouping moved = std::move(copy);
    expectSame(wholeOf(moved), of_copy);
    copy = moved;
    moved.removeSeeds({1});
    expectSame(wholeOf(copy), of_copy);
  }
}

TEST(GroupingThreads, ConstCallsMayRunSideBySide)
{
  const Points points = twoBoxes(1500, 70);
  for (const PreparedScan::ConstPtr& scan : {prepared(points), weighted(points)}) {
    Grouping grouping(scan);
    grouping.propose(30);
    const State expected = stateOf(grouping);
    std::vector<State> found(4);
    std::vector<Grouping> copies(4, grouping);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < 4; ++t)
      threads.emplace_back([&, t] {
        found[t] = stateOf(grouping);
        copies[t] = grouping; // and groupings of one scan change side by side
        for (std::size_t k = 0; k < 5; ++k) {
          copies[t].removeSeeds({3 * t + k});
          copies[t].groups();
        }
        copies[t].propose(40);
      });
    for (std::thread& thread : threads)
      thread.join();
    for (std::size_t t = 0; t < 4; ++t) {
      expectSame(found[t], expected);
      expectEqualsScratch(copies[t]);
    }
  }
}

} // namespace
} // namespace pcl_cid::test
