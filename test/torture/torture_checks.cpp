/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What must hold of every case.
 */

#include "torture_checks.h"

#include "base/random.h"
#include "fitting_checks.h"
#include "literal_grouping.h"
#include "oracle.h"
#include "part_checks.h"
#include "scan/working_set.h"
#include "torture_fault.h"

#include <pcl_cid/cid_label_propagation.h>
#include <pcl_cid/core/cid_from.h>
#include <pcl_cid/core/concavity.h>
#include <pcl_cid/core/hull_tightness.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <set>

namespace pcl_cid::test {
namespace {

using Abstraction = CIDConvexAbstraction<TorturePoint>;

/** Of the inputs that a case can be: all else must work. */
bool
isDocumented(const std::string& refusal)
{
  constexpr std::array<const char*, 7> documented = {
      "points, the least number asked for",
      "there is no finite point",
      "start index is point",
      "none of the seed candidates is",
      "from the middle of the cloud; it must be within",
      "from end to end; it must be",
      "the search surface has no finite point"};
  return std::any_of(documented.begin(), documented.end(), [&](const char* words) {
    return refusal.find(words) != std::string::npos;
  });
}

/** A run, and what came of it. */
struct Run {
  Abstraction abstraction;
  std::vector<ConvexPart> parts;
  std::string refusal;

  Run(const TortureCase& one,
      unsigned int threads,
      GroupRule groups = setting::groups.initial)
  : abstraction(one.abstraction(threads))
  {
    abstraction.setGroupRule(groups);
    try {
      abstraction.reconstruct(parts);
    }
    catch (const CIDException& exception) {
      refusal = exception.what();
      expect(isDocumented(refusal), "an exception: " + refusal);
    }
  }

  const Grouping&
  grouping() const
  {
    return *abstraction.getGrouping();
  }
};

bool
same(const MergeTree& a, const MergeTree& b)
{
  return a.groupSizes() == b.groupSizes() &&
         std::equal(a.steps().begin(),
                    a.steps().end(),
                    b.steps().begin(),
                    b.steps().end(),
                    [](const MergeStep& left, const MergeStep& right) {
                      return left.first == right.first && left.second == right.second &&
                             left.height == right.height && left.size == right.size;
                    });
}

void
checkThreads(const TortureCase& one, const Run& on_one)
{
  const Run on_three(one, 3);
  expect(on_three.refusal == on_one.refusal, "3 threads refuse other things");
  if (!on_one.refusal.empty())
    return;
  expect(on_three.grouping().seeds() == on_one.grouping().seeds(),
         "other seeds on 3 threads");
  expect(GroupingState(on_three.grouping()) == GroupingState(on_one.grouping()),
         "other groups on 3 threads");
  expect(same(on_three.abstraction.getMergeTree(), on_one.abstraction.getMergeTree()),
         "other merges on 3 threads");
  expect(sameParts(on_three.parts, on_one.parts), "other parts on 3 threads");
}

/** Seed by seed, the proposal is that of the definitions. */
void
checkProposal(const TortureCase& one, const Grouping& grouping)
{
  const PreparedScan& scan = grouping.scan();
  const pcl::Indices seeds = grouping.seeds();
  const SeedProposal proposal = grouping.proposal();
  expect(!seeds.empty() && seeds.size() <= static_cast<std::size_t>(one.seeds),
         "the number of seeds");
  expect(seeds[0] == scan.workingSet().cloudIndexOf(scan.start()), "the start");
  LiteralGrouping literal(scan, one.samples);
  const bool is_soft = one.seeding == SeedingRule::soft;
  const auto next = [&](std::size_t k) {
    const SoftDraw draw(scan.softSeed(), k);
    return literal.next(is_soft ? &draw : nullptr);
  };
  for (std::size_t k = 0; k < seeds.size(); ++k) {
    const std::string name = "seed " + std::to_string(k);
    if (k > 0)
      expect(next(k) == seeds[k], name + " is not " + std::to_string(next(k)));
    literal.add(seeds[k]);
    expect(literal.coverage() == proposal.coverage[k], "the coverage of " + name);
  }
  expect(literal.state() == GroupingState(grouping), "the groups of the proposal");
  if (seeds.size() < static_cast<std::size_t>(one.seeds))
    expect(grouping.coverage() <= one.coverage || next(seeds.size()) < 0,
           "the proposal stopped too soon");
}

/** The same by the paper's formulas in double. */
void
checkOracle(const TortureCase& one, const Grouping& grouping)
{
  const PreparedScan& scan = grouping.scan();
  if (scan.blindSpot() || scan.points().size() > 60)
    return;
  Points surface;
  const BlockTree& tree = scan.field().blocks();
  for (std::size_t b = 0; b < tree.size(); ++b)
    for (int row = 0; row < tree.block(b).count; ++row)
      surface.push_back(tree.block(b).point(row));
  const Oracle oracle(surface, one.samples);
  const Points& points = scan.working().points();
  Points all = scan.points().points;
  all.insert(all.end(), surface.begin(), surface.end());
  const Eigen::Vector3f& p = points[static_cast<std::size_t>(scan.start())];
  const std::vector<float> cids = cidFrom(scan.field(), p, points, one.samples);
  for (std::size_t i = 0; i < points.size(); ++i) {
    expect(cids[i] == pointCID(scan.field(), points[i], p, one.samples), "cidFrom");
    expect(std::abs(static_cast<double>(cids[i]) - oracle.pointCID(p, points[i])) <=
               agreementTolerance(all),
           "a CID is not the oracle's");
  }
}

/** Every finite, selected point has a group; a seed its own. */
void
checkGroups(const TortureCase& one, const Grouping& grouping)
{
  std::set<pcl::index_t> selected;
  for (std::size_t i = 0; i < one.cloud->size(); ++i)
    selected.insert(static_cast<pcl::index_t>(i));
  if (one.indices)
    selected = {one.indices->begin(), one.indices->end()};
  const std::vector<pcl::index_t> groups = grouping.groups();
  expect(groups.size() == one.cloud->size(), "the number of groups of points");
  const auto count = static_cast<pcl::index_t>(grouping.numberOfSeeds());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const bool is_grouped = (*one.cloud)[i].getVector3fMap().allFinite() &&
                            selected.count(static_cast<pcl::index_t>(i)) > 0;
    expect(is_grouped ? groups[i] >= 0 && groups[i] < count : groups[i] == -1,
           "the group of point " + std::to_string(i));
  }
  const pcl::Indices seeds = grouping.seeds();
  for (pcl::index_t k = 0; k < count; ++k)
    expect(groups[static_cast<std::size_t>(seeds[static_cast<std::size_t>(k)])] == k,
           "seed " + std::to_string(k) + " has lost its point");
}

MergingSettings
mergingSettings(const TortureCase& one)
{
  MergingSettings settings;
  settings.group_samples = static_cast<std::size_t>(one.group_samples);
  return settings;
}

/** \param[in] whole the tree to its end, \a made may have stopped before */
void
checkMerges(const TortureCase& one,
            const MergeTree& whole,
            std::size_t groups,
            const MergeTree& made)
{
  const std::vector<MergeStep>& steps = whole.steps();
  expect(steps.size() + 1 == groups, "the number of merges");
  for (std::size_t n = 0; n < steps.size(); ++n) {
    expect(std::isfinite(steps[n].height) && steps[n].height >= 0.0, "a height");
    expect(n == 0 || steps[n].height >= steps[n - 1].height * (1.0 - 1e-12),
           "heights fall");
  }
  expect(made.steps().size() <= steps.size(), "there are too many merges");
  const std::vector<MergeStep> begin(
      steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(made.steps().size()));
  expect(same(made, MergeTree(made.groupSizes(), begin)),
         "the merges up to the stop are others");
  expect(made.cut(one.cut) == whole.cut(one.cut), "the cut at the stop is another");
}

void
checkPartsOfGroups(const TortureCase& one,
                   const std::vector<pcl::index_t>& groups,
                   const Run& run)
{
  const auto grouped = static_cast<std::size_t>(
      std::count_if(groups.begin(), groups.end(), [](auto g) { return g >= 0; }));
  checkParts(*one.cloud,
             run.parts,
             one.hull,
             grouped,
             run.abstraction.getNumberOfDroppedPoints());
}

/** Patches in the place of groups of seeds. */
void
checkPatches(const TortureCase& one)
{
  const Run on_one(one, 1, GroupRule::patches);
  const Run on_three(one, 3, GroupRule::patches);
  expect(on_three.refusal == on_one.refusal, "3 threads refuse other patches");
  if (!on_one.refusal.empty())
    return;
  const SmoothPatches& patches = *on_one.abstraction.getPatches();
  const std::size_t number = patches.numberOfPatches();
  expect(number >= 1 && number <= static_cast<std::size_t>(one.seeds),
         "the number of patches");
  const std::vector<pcl::index_t> groups = patches.groups();
  expect(on_three.abstraction.getPatches()->groups() == groups,
         "other patches on 3 threads");
  const MergeTree& made = on_one.abstraction.getMergeTree();
  expect(same(on_three.abstraction.getMergeTree(), made),
         "other merges of patches on 3 threads");
  expect(sameParts(on_three.parts, on_one.parts),
         "other parts of patches on 3 threads");
  checkMerges(
      one, mergeGroups(patches, one.samples, mergingSettings(one)), number, made);
  checkPartsOfGroups(one, groups, on_one);
}

bool
isShare(double value)
{
  return value >= 0.0 && value <= 1.0 + 1e-9;
}

void
checkTightness(const TortureCase& one, const Run& run)
{
  TightnessOptions options;
  options.free_distance = std::max(1e-3 * one.hull.min_thickness, 1e-15);
  options.hull_samples = 40;
  options.box_samples = 200;
  std::array<Tightness, 2> measured;
  for (const unsigned int threads : {1u, 3u}) {
    options.execution.threads = threads;
    measured[threads / 2] =
        TightnessMeter(run.grouping().sharedScan(), options).measure(run.parts);
  }
  const Tightness& tightness = measured[0];
  expect(tightness.hulls.size() == run.parts.size(), "the number of tightnesses");
  for (const HullTightness& hull : tightness.hulls) {
    expect(std::isfinite(hull.max_concavity) && hull.mean_concavity >= 0.0 &&
               hull.mean_concavity <= hull.max_concavity * (1.0 + 1e-9),
           "a concavity");
    expect(isShare(hull.free_share), "the free share of a hull");
  }
  expect(isShare(tightness.all.free_share), "the free share of all hulls");
  expect(tightness.volume == measured[1].volume &&
             tightness.all.mean_concavity == measured[1].all.mean_concavity,
         "another tightness on 3 threads");
}

/** Seeds come and go; the state is always that of the definitions. */
void
checkHistory(const TortureCase& one, Grouping grouping)
{
  RandomGenerator generator(one.number);
  const PreparedScan& scan = grouping.scan();
  const auto draw = [&](std::size_t count) { return drawBelow(generator, count); };
  const auto newSeeds = [&] {
    const pcl::Indices seeds = grouping.seeds();
    std::set<pcl::index_t> drawn;
    for (std::size_t tries = 1 + draw(5); tries > 0; --tries) {
      const auto i = static_cast<pcl::index_t>(draw(scan.working().size()));
      drawn.insert(scan.workingSet().cloudIndexOf(i));
    }
    for (const pcl::index_t seed : seeds)
      drawn.erase(seed);
    return pcl::Indices(drawn.begin(), drawn.end());
  };
  for (int n = 0; n < 3; ++n) {
    const ExecutionOptions execution{draw(2) == 0 ? 1u : 3u, {}};
    const std::size_t seeds = grouping.numberOfSeeds();
    switch (draw(4)) {
    case 0:
      grouping.addSeeds(newSeeds(), execution);
      break;
    case 1:
      grouping.insertSeeds(newSeeds(), draw(seeds + 1), execution);
      break;
    case 2:
      if (seeds > 1)
        grouping.removeSeeds({draw(seeds)}, execution);
      break;
    default:
      grouping.propose(seeds + 1, 0.0f, execution);
    }
  }
  LiteralGrouping literal(scan, one.samples);
  Grouping scratch(grouping.sharedScan(), grouping.settings());
  scratch.addSeeds(grouping.seeds());
  for (const pcl::index_t seed : grouping.seeds())
    literal.add(seed);
  const GroupingState state(grouping);
  expect(state == GroupingState(scratch), "seeds that came and went: not as scratch");
  expect(state == literal.state(), "seeds that came and went: not by definition");
  checkGroups(one, grouping);
}

/** Given seeds keep their labels, duplicates and all. */
void
checkLabels(const TortureCase& one, const Grouping& grouping)
{
  RandomGenerator generator(one.number);
  const PreparedScan& scan = grouping.scan();
  pcl::Indices seeds;
  std::vector<std::uint32_t> labels;
  for (std::size_t k = 0; k < 6; ++k) {
    seeds.push_back(scan.points().source[drawBelow(generator, scan.points().size())]);
    labels.push_back(static_cast<std::uint32_t>(seeds.back()) + 4000000000u);
  }
  CIDLabelPropagation<TorturePoint> propagation;
  propagation.setInputCloud(one.cloud);
  if (one.indices)
    propagation.setIndices(one.indices);
  if (one.surface)
    propagation.setSearchSurface(one.surface);
  propagation.setSubsample(one.preparation.subsample);
  propagation.setDensityWeight(one.preparation.density);
  propagation.setNumberOfSamples(one.samples);
  propagation.setSeeds(seeds, labels);
  std::vector<std::uint32_t> found;
  propagation.segment(found);
  for (std::size_t k = 0; k < seeds.size(); ++k)
    expect(found[static_cast<std::size_t>(seeds[k])] == labels[k],
           "given seed " + std::to_string(seeds[k]) + " has lost its label");
}

void
check(const TortureCase& one, TortureVerdict& verdict)
{
  const Run run(one, 1);
  verdict.refusal = run.refusal;
  checkThreads(one, run);
  if (!run.refusal.empty())
    return;
  const Grouping& grouping = run.grouping();
  checkProposal(one, grouping);
  checkOracle(one, grouping);
  checkGroups(one, grouping);
  checkMerges(one,
              mergeGroups(grouping, mergingSettings(one)),
              grouping.numberOfSeeds(),
              run.abstraction.getMergeTree());
  checkPartsOfGroups(one, grouping.groups(), run);
  checkPatches(one);
  checkTightness(one, run);
  checkHistory(one, grouping);
  checkLabels(one, grouping);
  if (one.fitting.is_checked)
    checkFitting(one, grouping.scan());
}

} // namespace

TortureVerdict
judge(const TortureCase& one)
{
  TortureVerdict verdict;
  try {
    check(one, verdict);
  }
  catch (const Fault& fault) {
    verdict.fault = fault.text;
  }
  catch (const std::exception& exception) {
    verdict.fault = std::string("an exception: ") + exception.what();
  }
  return verdict;
}

} // namespace pcl_cid::test
