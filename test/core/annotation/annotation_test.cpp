/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Simulated annotators: what must hold, and their protocols step by step.
 */

#include "clouds.h"
#include "labelled_runs.h"
#include "literal_regions.h"
#include "prepared_points.h"
#include "sanitizers.h"

#include <pcl_cid/core/annotation.h>
#include <pcl_cid/core/label_cleaning.h>
#include <pcl_cid/core/label_doubt.h>
#include <pcl_cid/exceptions.h>

#include <cmath>
#include <map>
#include <numeric>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using Counts = std::vector<std::size_t>;

/** Two boxes; an instance is what lies in a cell of 0.4 metres; some points have
 *  none. */
AnnotationTask
twoBoxesInCells(std::size_t size)
{
  const Points points = twoBoxes(size, 7);
  AnnotationTask task;
  task.scan = prepared(points);
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Array3i cell = (p.array() / 0.4f).floor().cast<int>() + 20;
    task.truth.push_back(
        static_cast<std::uint32_t>(cell.x() + 100 * cell.y() + 10000 * cell.z()));
  }
  for (std::size_t i = 0; i < size; i += 17)
    task.truth[i] = 0;
  return task;
}

Counts
upTo(std::size_t most)
{
  Counts counts(most);
  std::iota(counts.begin(), counts.end(), std::size_t{1});
  return counts;
}

Labels
labelsBy(const Grouping& grouping, const Labels& truth)
{
  Labels labels;
  const pcl::Indices seeds = grouping.seeds();
  for (const pcl::index_t group : grouping.groups())
    labels.push_back(
        group < 0
            ? 0
            : truth[static_cast<std::size_t>(seeds[static_cast<std::size_t>(group)])]);
  return labels;
}

/** The IoU of each instance with the points of its label, by counting. */
std::map<std::uint32_t, double>
countedIous(const Labels& labels, const Labels& truth)
{
  std::map<std::uint32_t, double> ious;
  for (const std::uint32_t instance :
       std::set<std::uint32_t>(truth.begin(), truth.end())) {
    double both = 0.0;
    double either = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      both += truth[i] == instance && labels[i] == instance ? 1.0 : 0.0;
      either +=
          truth[i] == instance || (labels[i] == instance && truth[i] != 0) ? 1.0 : 0.0;
    }
    if (instance != 0)
      ious[instance] = both / either;
  }
  return ious;
}

std::map<std::uint32_t, double>
iousOf(const AnnotationState& state)
{
  std::map<std::uint32_t, double> ious;
  for (const Instance& truth : state.overlaps.truths)
    ious[truth.label] = 0.0;
  for (const InstanceOverlap& overlap : state.overlaps.overlaps)
    ious[state.overlaps.truths[overlap.truth].label] = state.overlaps.iou(overlap);
  return ious;
}

double
meanOf(const AnnotationState& state)
{
  return scoreAnnotations({state.overlaps}).mean_iou;
}

void
expectSame(const std::vector<AnnotationState>& a, const std::vector<AnnotationState>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].clicks, b[k].clicks);
    EXPECT_EQ(iousOf(a[k]), iousOf(b[k]));
  }
}

TEST(ProposedClicks, GiveEveryPointTheTrueLabelOfItsSeed)
{
  const AnnotationTask task = twoBoxesInCells(300);
  const Counts counts{1, 2, 7, 20};
  const std::vector<AnnotationState> states = annotateProposals(task, counts);
  ASSERT_EQ(states.size(), counts.size());
  for (std::size_t k = 0; k < counts.size(); ++k) {
    Grouping grouping(task.scan, task.grouping);
    grouping.propose(counts[k]);
    EXPECT_EQ(states[k].clicks, counts[k]);
    EXPECT_EQ(iousOf(states[k]),
              countedIous(labelsBy(grouping, task.truth), task.truth));
  }
}

/** The annotator who corrects, as it is defined. */
class LiteralCorrections {
public:
  explicit LiteralCorrections(const AnnotationTask& task)
  : task_(task)
  , points_(task.scan->points().points)
  , neighbors_(literalNeighbors(points_))
  , grouping_(task.scan, task.grouping)
  {
  }

  Grouping&
  grouping()
  {
    return grouping_;
  }

  Labels
  labels() const
  {
    return labelsBy(grouping_, task_.truth);
  }

  bool
  click()
  {
    const pcl::Indices region =
        grouping_.numberOfSeeds() == 0
            ? largestInstance(task_.truth)
            : literalWrongRegion(neighbors_, task_.truth, labels());
    if (region.empty())
      return false;
    const pcl::index_t point = literalInmostPoint(points_, region).point;
    grouping_.addSeeds({point});
    const auto i = static_cast<std::size_t>(point);
    EXPECT_EQ(labels()[i], task_.truth[i]);
    return true;
  }

private:
  const AnnotationTask& task_;
  const Points& points_;
  std::vector<std::set<std::size_t>> neighbors_;
  Grouping grouping_;
};

TEST(CorrectiveClicks, AreThoseOfTheDefinition)
{
  const AnnotationTask task = twoBoxesInCells(150);
  for (const std::size_t proposals : {0, 5}) {
    const std::vector<AnnotationState> states =
        annotateCorrections(task, upTo(30), proposals);
    LiteralCorrections literal(task);
    for (std::size_t k = 0; k < states.size(); ++k) {
      if (k < proposals)
        literal.grouping().propose(k + 1);
      else
        literal.click();
      EXPECT_EQ(states[k].clicks, literal.grouping().numberOfSeeds());
      EXPECT_EQ(iousOf(states[k]), countedIous(literal.labels(), task.truth)) << k;
    }
  }
}

TEST(CorrectiveClicks, MakeAllRightWithAtMostAsManyAsPoints)
{
  const AnnotationTask task = twoBoxesInCells(120);
  const AnnotationState end = annotateCorrections(task, {1000}, 0).back();
  EXPECT_LE(end.clicks, 120u);
  EXPECT_EQ(meanOf(end), 1.0);
}

TEST(CorrectiveClicks, MakeAllRightWherePointsCoincide)
{
  Points points = randomCube(40, 5);
  points.insert(points.end(), points.begin(), points.end());
  AnnotationTask task;
  task.scan = prepared(points);
  for (std::size_t i = 0; i < points.size(); ++i)
    task.truth.push_back(static_cast<std::uint32_t>(1 + i % 3 + i / 40));
  const AnnotationState end = annotateCorrections(task, {80}, 0).back();
  EXPECT_EQ(meanOf(end), 1.0);
}

TEST(CorrectiveClicks, DoNotTouchWhatHasNoTruth)
{
  AnnotationTask task;
  task.scan = prepared(randomCube(50, 2));
  task.truth.assign(50, 0);
  task.truth[31] = 4;
  const AnnotationState state = annotateCorrections(task, {10}, 0).back();
  EXPECT_EQ(state.clicks, 1u); // then nothing is wrong any more
  EXPECT_EQ(state.overlaps.truths.size(), 1u);
}

TEST(CorrectiveClicks, AreOnPointsOfASubsample)
{
  PreparationSettings settings = plainSettings();
  settings.subsample = 60;
  AnnotationTask task = twoBoxesInCells(400);
  task.scan = prepared(task.scan->points().points, settings);
  const std::vector<AnnotationState> states = annotateCorrections(task, {10, 60}, 0);
  EXPECT_GT(meanOf(states[1]), meanOf(states[0]));
  const std::vector<AnnotationState> of_voxels = annotateVoxels(task);
  EXPECT_GT(meanOf(of_voxels.back()), meanOf(of_voxels.front()));
}

/** Two of the three points coincide, so Algorithm 1 has no third seed to propose. */
TEST(CorrectiveClicks, GoOnWhereNothingIsLeftToPropose)
{
  AnnotationTask task;
  task.scan = prepared({{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}});
  task.truth = {1, 2, 3};
  const std::vector<AnnotationState> states = annotateCorrections(task, {2, 3, 5}, 3);
  EXPECT_EQ(states[0].clicks, 2u);
  EXPECT_EQ(states[1].clicks, 3u);
  EXPECT_EQ(meanOf(states[1]), 1.0);
  EXPECT_EQ(states[2].clicks, 3u);
}

/** The annotator who goes where doubt is, on all points of a small scan. */
class LiteralDoubts {
public:
  explicit LiteralDoubts(const AnnotationTask& task)
  : task_(task), session_(task.scan, task.grouping)
  {
    std::iota(points_.begin(), points_.end(), 0);
  }

  void
  click()
  {
    LabelDoubt doubt(task_.scan, task_.grouping.samples, points_);
    const std::vector<float> margins = doubt.margins(session_);
    std::vector<float> known;
    for (const float margin : margins)
      if (!std::isnan(margin))
        known.push_back(margin);
    std::sort(known.begin(), known.end());
    const float limit = known.empty() ? 0.0f : known[known.size() * 6 / 100];
    for (std::size_t rank = 0; const auto area = doubt.area(margins, limit, rank);
         ++rank)
      if (!isSeed(area->point)) {
        answer(area->point);
        return;
      }
    session_.apply(action::Propose{1});
    for (const SessionSeed& seed : session_.seeds())
      if (!seed.label)
        answer(seed.point);
  }

  Labels
  labels() const
  {
    return session_.labels();
  }

private:
  bool
  isSeed(pcl::index_t point) const
  {
    const pcl::Indices seeds = session_.grouping().seeds();
    return std::find(seeds.begin(), seeds.end(), point) != seeds.end();
  }

  void
  answer(pcl::index_t point)
  {
    const std::uint32_t label = task_.truth[static_cast<std::size_t>(point)];
    const auto& instances = session_.instances();
    const bool is_known =
        label == 0 ||
        std::any_of(instances.begin(), instances.end(), [&](const auto& each) {
          return each.label == label;
        });
    session_.apply(action::Click{{point},
                                 is_known ? action::Answer(label)
                                          : action::NewInstance{"", "", label}});
  }

  const AnnotationTask& task_;
  LabelSession session_;
  pcl::Indices points_ = pcl::Indices(task_.truth.size());
};

TEST(DoubtfulClicks, AreThoseOfTheDefinition)
{
  const AnnotationTask task = twoBoxesInCells(250);
  LiteralDoubts literal(task);
  for (const AnnotationState& state :
       annotateDoubts(task, upTo(is_sanitized ? 12 : 40), 0)) {
    literal.click();
    EXPECT_EQ(iousOf(state), countedIous(literal.labels(), task.truth)) << state.clicks;
  }
}

TEST(DoubtfulClicks, BeginWithWhatIsProposed)
{
  const AnnotationTask task = twoBoxesInCells(250);
  const std::vector<AnnotationState> states = annotateDoubts(task, upTo(9), 6);
  const std::vector<AnnotationState> proposed = annotateProposals(task, upTo(9));
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_EQ(iousOf(states[k]), iousOf(proposed[k]));
  EXPECT_NE(iousOf(states[8]), iousOf(proposed[8]));
}

TEST(DoubtfulClicks, MakeAllRightWithAtMostAsManyAsPoints)
{
  const AnnotationTask task = twoBoxesInCells(120);
  const AnnotationState end = annotateDoubts(task, {1000}, 0).back();
  EXPECT_LE(end.clicks, 120u);
  EXPECT_EQ(meanOf(end), 1.0);
}

TEST(AnnotatedScans, MayHaveTheirBoundariesMended)
{
  PreparationSettings settings = plainSettings();
  for (const int subsample : {0, 250}) {
    settings.subsample = subsample;
    AnnotationTask task = twoBoxesInCells(400);
    task.scan = prepared(task.scan->points().points, settings);
    const AnnotationState ragged = annotateProposals(task, {30}).front();
    task.clean_up = true;
    const AnnotationState mended = annotateProposals(task, {30}).front();
    Grouping grouping(task.scan, task.grouping);
    grouping.propose(30);
    std::vector<std::uint32_t> label_of_seed;
    for (const pcl::index_t seed : grouping.seeds())
      label_of_seed.push_back(task.truth[static_cast<std::size_t>(seed)]);
    EXPECT_EQ(iousOf(mended),
              countedIous(cleanBoundaries(grouping, label_of_seed), task.truth));
    EXPECT_NE(iousOf(mended), iousOf(ragged));
  }
}

TEST(AnnotationThreads, ChangeNothing)
{
  const AnnotationTask task = twoBoxesInCells(500);
  const Counts counts{3, 10, 40};
  expectSame(annotateProposals(task, counts, onThreads(3)),
             annotateProposals(task, counts, onThreads(1)));
  expectSame(annotateCorrections(task, counts, 5, onThreads(3)),
             annotateCorrections(task, counts, 5, onThreads(1)));
  expectSame(annotateDoubts(task, counts, 5, onThreads(3)),
             annotateDoubts(task, counts, 5, onThreads(1)));
  expectSame(annotateVoxels(task, {}, onThreads(3)),
             annotateVoxels(task, {}, onThreads(1)));
}

TEST(VoxelClicks, BeginWithOneInEachInstanceAndKeepTheBudget)
{
  const AnnotationTask task = twoBoxesInCells(400);
  VoxelAnnotationOptions options;
  options.voxel = 1e-4f; // each point has its own
  options.clicks_per_instance = 3;
  const std::vector<AnnotationState> states = annotateVoxels(task, options);
  const std::size_t instances = states.front().overlaps.truths.size();
  ASSERT_GT(instances, 3u);
  EXPECT_EQ(states.front().clicks, instances);
  EXPECT_LE(states.back().clicks, 3 * instances);
  for (std::size_t k = 1; k < states.size(); ++k)
    EXPECT_EQ(states[k].clicks, states[k - 1].clicks + 1);
  options.clicks_per_instance = 400;
  EXPECT_EQ(meanOf(annotateVoxels(task, options).back()), 1.0);
}

/** Labels of the first points of all voxels, on all of their points. */
Labels
throughVoxels(const Labels& labels, const Points& points, double side)
{
  std::map<std::vector<double>, std::uint32_t> of_voxel;
  Labels result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<double> voxel;
    for (int axis = 0; axis < 3; ++axis)
      voxel.push_back(std::floor(double{points[i][axis]} / side));
    result.push_back(of_voxel.emplace(voxel, labels[i]).first->second);
  }
  return result;
}

TEST(VoxelClicks, OfTheFirstRoundAreThoseOfTheDefinition)
{
  const AnnotationTask task = twoBoxesInCells(400);
  const Points& points = task.scan->points().points;
  const float side = 0.125f;
  VoxelAnnotationOptions options;
  options.voxel = side;
  options.clicks_per_instance = 1;

  Labels numbers(points.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  const Labels first = throughVoxels(numbers, points, side);
  pcl::Indices seen; // the first points of voxels
  Points seen_points;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (first[i] == i) {
      seen.push_back(static_cast<pcl::index_t>(i));
      seen_points.push_back(points[i]);
    }
  ASSERT_LT(seen.size(), points.size());
  std::map<std::uint32_t, pcl::Indices> regions;
  for (std::size_t v = 0; v < seen.size(); ++v)
    regions[task.truth[static_cast<std::size_t>(seen[v])]].push_back(
        static_cast<pcl::index_t>(v));
  regions.erase(0);
  pcl::Indices clicks;
  for (const auto& [instance, region] : regions)
    clicks.push_back(
        seen[static_cast<std::size_t>(literalInmostPoint(seen_points, region).point)]);

  Grouping grouping(task.scan, task.grouping);
  grouping.addSeeds(clicks);
  const Labels labels = throughVoxels(labelsBy(grouping, task.truth), points, side);
  const AnnotationState state = annotateVoxels(task, options).front();
  EXPECT_EQ(state.clicks, clicks.size());
  EXPECT_EQ(iousOf(state), countedIous(labels, task.truth));
}

/** Each point is a voxel of its own. */
TEST(VoxelClicks, OfLaterRoundsAreInTheLargestRegion)
{
  const AnnotationTask task = twoBoxesInCells(300);
  const Points& points = task.scan->points().points;
  VoxelAnnotationOptions options;
  options.voxel = 1e-4f;
  const std::vector<AnnotationState> states = annotateVoxels(task, options);
  ASSERT_GT(states.size(), 15u);
  Grouping grouping(task.scan, task.grouping);
  Labels labels(points.size(), 0);
  for (std::size_t k = 0; k < 15; ++k) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, pcl::Indices> regions;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (task.truth[i] != 0 && task.truth[i] != labels[i])
        regions[{task.truth[i], labels[i]}].push_back(static_cast<pcl::index_t>(i));
    pcl::Indices clicks;
    InmostPoint largest;
    for (const auto& [pair, region] : regions) {
      const InmostPoint inmost = literalInmostPoint(points, region);
      clicks.push_back(inmost.point);
      if (inmost.squared_distance > largest.squared_distance ||
          (inmost.squared_distance == largest.squared_distance &&
           inmost.point < largest.point))
        largest = inmost;
    }
    grouping.addSeeds(k == 0 ? clicks : pcl::Indices{largest.point});
    labels = labelsBy(grouping, task.truth);
    EXPECT_EQ(states[k].clicks, grouping.numberOfSeeds());
    EXPECT_EQ(iousOf(states[k]), countedIous(labels, task.truth)) << k;
  }
}

TEST(AnnotationScores, AreThoseCountedByHand)
{
  // IoU 3/4, 4/7 and 0 of the instances 1, 2 and 3; two predictions, both right.
  const InstanceOverlaps scan = sameLabelOverlaps(
      overlapsOfRuns({{3, 1, 1, 1}, {1, 1, 1, 2}, {4, 2, 1, 2}, {2, 3, 1, 2}}));
  const AnnotationScore score = scoreAnnotations({scan});
  EXPECT_EQ(score.instances, 3u);
  EXPECT_DOUBLE_EQ(score.mean_iou, (3.0 / 4 + 4.0 / 7) / 3);
  EXPECT_DOUBLE_EQ(score.recall25, 2.0 / 3);
  EXPECT_DOUBLE_EQ(score.recall50, 2.0 / 3);
  EXPECT_DOUBLE_EQ(score.recall75, 1.0 / 3);
  EXPECT_DOUBLE_EQ(score.ap50, 2.0 / 3);
  const AnnotationScore twice = scoreAnnotations({scan, scan});
  EXPECT_EQ(twice.instances, 6u);
  EXPECT_DOUBLE_EQ(twice.mean_iou, score.mean_iou);
}

TEST(AnnotationScores, OfNumbersOfAPersonAreThoseOfPairs)
{
  // IoU 3/4 of instance 1 and label 5, 1/2 of instance 2 and label 6; label 9 is a
  // wrong prediction. The last two points have no true label.
  const InstanceOverlaps all =
      annotationOverlaps({5, 5, 5, 0, 6, 9, 9, 6}, {1, 1, 1, 1, 2, 2, 0, 0});
  const AnnotationScore score = scoreAnnotations({pairedOverlaps(all)});
  EXPECT_EQ(score.instances, 2u);
  EXPECT_DOUBLE_EQ(score.mean_iou, (3.0 / 4 + 1.0 / 2) / 2);
  EXPECT_DOUBLE_EQ(score.recall50, 1.0);
  EXPECT_DOUBLE_EQ(score.recall75, 1.0 / 2);
  EXPECT_DOUBLE_EQ(score.ap50, 1.0 / 2 * (1.0 + 1.0 / 3) / 2);
  EXPECT_THROW(annotationOverlaps({1, 2}, {1}), CIDException);
}

TEST(AnnotationScores, OfCurvesAreByClicksForEachInstance)
{
  // Two instances; IoU 0, then 1/2 and 1, then both 1.
  const auto state = [](std::size_t clicks, const std::vector<LabelledRun>& runs) {
    return AnnotationState{clicks, sameLabelOverlaps(overlapsOfRuns(runs))};
  };
  const std::vector<AnnotationState> states{
      state(2, {{4, 1, 1, 0}, {4, 2, 1, 0}}),
      state(3, {{2, 1, 1, 1}, {2, 1, 1, 0}, {4, 2, 1, 2}}),
      state(4, {{4, 1, 1, 1}, {4, 2, 1, 2}})};
  EXPECT_DOUBLE_EQ(meanIouAt(states, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(meanIouAt(states, 1.5), 0.75);
  EXPECT_DOUBLE_EQ(meanIouAt(states, 1.9), 0.75);
  EXPECT_DOUBLE_EQ(meanIouAt(states, 5.0), 1.0);
  EXPECT_DOUBLE_EQ(clicksToReach(states, 0.75, 20.0), 1.5);
  EXPECT_DOUBLE_EQ(clicksToReach(states, 0.80, 20.0), 2.0);
  EXPECT_DOUBLE_EQ(clicksToReach({states[0], states[1]}, 0.80, 20.0), 20.0);
}

TEST(AnnotationTasks, ThatAreNoneAreRefused)
{
  const AnnotationTask good = twoBoxesInCells(40);
  EXPECT_THROW(annotateProposals(good, {}), CIDException);
  EXPECT_THROW(annotateProposals(good, {0}), CIDException);
  EXPECT_THROW(annotateProposals(good, {5, 5}), CIDException);
  EXPECT_THROW(annotateCorrections(good, {5, 4}, 0), CIDException);
  VoxelAnnotationOptions options;
  options.voxel = 0.0f;
  EXPECT_THROW(annotateVoxels(good, options), CIDException);
  options = {};
  options.clicks_per_instance = 0;
  EXPECT_THROW(annotateVoxels(good, options), CIDException);

  AnnotationTask task = good;
  task.scan = nullptr;
  EXPECT_THROW(annotateProposals(task, {1}), CIDException);
  task = good;
  task.truth.pop_back();
  EXPECT_THROW(annotateCorrections(task, {1}, 0), CIDException);
  task.truth.assign(40, 0);
  EXPECT_THROW(annotateVoxels(task), CIDException);
}

TEST(AnnotationTasks, AreCancelled)
{
  const AnnotationTask task = twoBoxesInCells(200);
  const ExecutionOptions cancelled{1, [](double) { return false; }};
  EXPECT_THROW(annotateProposals(task, {20}, cancelled), CIDCancelled);
  EXPECT_THROW(annotateCorrections(task, {20}, 0, cancelled), CIDCancelled);
  EXPECT_THROW(annotateDoubts(task, {20}, 0, cancelled), CIDCancelled);
  EXPECT_THROW(annotateVoxels(task, {}, cancelled), CIDCancelled);
}

} // namespace
} // namespace pcl_cid::test
