/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Protocols of the paper, ScanNet and S3DIS: examples worked by hand.
 */

#include "labelled_runs.h"

#include <pcl_cid/core/evaluation.h>
#include <pcl_cid/exceptions.h>

#include <cmath>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

constexpr auto paper = EvaluationProtocol::paper;
constexpr auto scannet = EvaluationProtocol::scannet;
constexpr auto s3dis = EvaluationProtocol::s3dis;

TEST(InstanceOverlaps, CountCommonPoints)
{
  const InstanceOverlaps scan = overlapsOfRuns(
      {{3, 5, 1, 9}, {2, 5, 1, 2}, {4, 7, 2, 9}, {1, 0, 0, 2}, {6, 7, 2, 0}});
  ASSERT_EQ(scan.truths.size(), 2u);
  EXPECT_EQ(scan.truths[0].label, 5u);
  EXPECT_EQ(scan.truths[0].points, 5u);
  EXPECT_EQ(scan.truths[1].points, 10u);
  ASSERT_EQ(scan.predictions.size(), 2u);
  EXPECT_EQ(scan.predictions[0].label, 2u);
  EXPECT_EQ(scan.predictions[0].points, 3u);
  EXPECT_EQ(scan.predictions[1].points, 7u);
  ASSERT_EQ(scan.overlaps.size(), 3u);
  EXPECT_DOUBLE_EQ(scan.iou(scan.overlaps[0]), 2.0 / (5 + 3 - 2));
  EXPECT_DOUBLE_EQ(scan.iou(scan.overlaps[1]), 3.0 / (5 + 7 - 3));
  EXPECT_DOUBLE_EQ(scan.iou(scan.overlaps[2]), 4.0 / (10 + 7 - 4));
}

TEST(InstanceOverlaps, TakeTheMostFrequentClassAndTheLowestOfEquals)
{
  // Truth 1: 2 points of class 8, 3 of 4. Prediction 6: 3 of 8, 3 of 4: the lower one.
  const InstanceOverlaps scan =
      overlapsOfRuns({{2, 1, 8, 6}, {3, 1, 4, 6}, {1, 2, 8, 6}});
  EXPECT_EQ(scan.truths[0].semantic, 4u);
  EXPECT_EQ(scan.predictions[0].semantic, 4u);
  const InstanceOverlaps own = overlapsOfRuns({{5, 1, 8, 6}}, {{6, 3}});
  EXPECT_EQ(own.predictions[0].semantic, 3u);
}

TEST(InstanceOverlaps, WantAsManyLabelsAsPoints)
{
  const PointLabels two{{1, 2}, {1, 1}};
  const PointLabels three{{1, 2, 3}, {1, 1, 1}};
  EXPECT_THROW(overlapsOf(two, three), CIDException);
  EXPECT_THROW(overlapsOf({{1, 2}, {1}}, two), CIDException);
  EXPECT_THROW(overlapsOf(two, {{1, 2}, {}}), CIDException);
  EXPECT_TRUE(overlapsOf({}, {}).truths.empty());
}

TEST(PairedOverlaps, ArePairsByFallingIoU)
{
  // The largest IoU is that of truth 2 and prediction 7: 5/11. So truth 1, of which 7
  // has most, goes to 8, with 4/10, and nothing is left for prediction 9.
  const InstanceOverlaps all = overlapsOfRuns(
      {{5, 1, 1, 7}, {5, 2, 1, 7}, {4, 1, 1, 8}, {1, 1, 1, 9}, {1, 2, 1, 0}});
  const InstanceOverlaps pairs = pairedOverlaps(all);
  EXPECT_EQ(pairs.truths.size(), 2u);
  EXPECT_EQ(pairs.predictions.size(), 3u);
  ASSERT_EQ(pairs.overlaps.size(), 2u);
  EXPECT_EQ(pairs.truths[pairs.overlaps[0].truth].label, 1u);
  EXPECT_EQ(pairs.predictions[pairs.overlaps[0].prediction].label, 8u);
  EXPECT_DOUBLE_EQ(pairs.iou(pairs.overlaps[0]), 0.4);
  EXPECT_EQ(pairs.truths[pairs.overlaps[1].truth].label, 2u);
  EXPECT_EQ(pairs.predictions[pairs.overlaps[1].prediction].label, 7u);
  EXPECT_DOUBLE_EQ(pairs.iou(pairs.overlaps[1]), 5.0 / 11.0);
}

TEST(PairedOverlaps, OfEqualPairsTakeTheFirst)
{
  const InstanceOverlaps pairs = pairedOverlaps(
      overlapsOfRuns({{2, 1, 1, 5}, {2, 1, 1, 6}, {2, 2, 1, 5}, {2, 2, 1, 6}}));
  ASSERT_EQ(pairs.overlaps.size(), 2u);
  EXPECT_EQ(pairs.predictions[pairs.overlaps[0].prediction].label, 5u);
  EXPECT_EQ(pairs.predictions[pairs.overlaps[1].prediction].label, 6u);
  EXPECT_TRUE(pairedOverlaps({}).overlaps.empty());
}

TEST(PaperProtocol, ComparesInstancesOfTheSameLabel)
{
  // Prediction 1 covers all 4 points of truth 1: right. Prediction 2 has only 1 of the
  // 4 points of truth 2, IoU 1/8, but all 4 of truth 3 of the same class: not its own.
  // Truth 3 has no seed. R = 1/3, P = 1/2: 1/3 * 3/2 / 2 = 1/4.
  const std::vector<InstanceOverlaps> scans{
      overlapsOfRuns({{4, 1, 6, 1}, {1, 2, 6, 2}, {3, 2, 6, 0}, {4, 3, 6, 2}})};
  const EvaluationFigures figures = evaluate(scans, paper, {6}).classes.at(0).figures;
  EXPECT_DOUBLE_EQ(figures.recall50, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(figures.precision50, 1.0 / 2.0);
  EXPECT_DOUBLE_EQ(figures.ap50, 1.0 / 4.0);
  // S3DIS would count it: IoU 4/5 with truth 3. R = 2/3, P = 1, AP = 2/3 * 2 / 2.
  EXPECT_DOUBLE_EQ(evaluate(scans, s3dis, {6}).mean.ap50, 2.0 / 3.0);
}

TEST(PaperProtocol, GivesAPredictionTheClassOfItsLabel)
{
  // Most points of prediction 1 are of class 2; it still is a prediction of class 1.
  const Evaluation evaluation = evaluate(
      {overlapsOfRuns({{4, 1, 1, 1}, {5, 2, 2, 1}, {1, 2, 2, 2}})}, paper, {1, 2, 3});
  EXPECT_EQ(evaluation.classes[0].predictions, 1u);
  EXPECT_DOUBLE_EQ(evaluation.classes[0].figures.ap25, 1.0); // IoU 4/9
  EXPECT_DOUBLE_EQ(evaluation.classes[0].figures.ap50, 0.0);
  EXPECT_DOUBLE_EQ(evaluation.classes[1].figures.ap25, 0.0); // IoU 1/6
  EXPECT_EQ(evaluation.classes[2].truths, 0u);
  EXPECT_TRUE(std::isnan(evaluation.classes[2].figures.ap25));
  EXPECT_EQ(evaluation.classes_in_mean, 2u);
  EXPECT_DOUBLE_EQ(evaluation.mean.ap25, 0.5);
}

TEST(PaperProtocol, RefusesLabelsThatDoNotComeFromTheTruth)
{
  const std::vector<InstanceOverlaps> scans{overlapsOfRuns({{4, 1, 1, 77}})};
  try {
    evaluate(scans, paper, {1});
    ADD_FAILURE() << "nothing was thrown";
  }
  catch (const CIDException& error) {
    EXPECT_NE(std::string(error.what()).find("77"), std::string::npos) << error.what();
  }
  EXPECT_DOUBLE_EQ(evaluate(scans, s3dis, {1}).mean.ap75, 1.0);
}

TEST(ScannetProtocol, AveragesOverNineThresholds)
{
  // IoU 120/200 = 3/5 is above 0.50 and 0.55, and not above 0.60: 2 of 9.
  const Evaluation evaluation =
      evaluate({overlapsOfRuns({{120, 1, 3, 1}, {80, 1, 3, 0}})}, scannet, {3, 5});
  EXPECT_DOUBLE_EQ(evaluation.classes[0].figures.ap, 2.0 / 9.0);
  EXPECT_DOUBLE_EQ(evaluation.classes[0].figures.ap50, 1.0);
  EXPECT_DOUBLE_EQ(evaluation.classes[0].figures.ap75, 0.0);
  EXPECT_TRUE(std::isnan(evaluation.classes[1].figures.ap));
  EXPECT_DOUBLE_EQ(evaluation.mean.ap, 2.0 / 9.0);
}

TEST(ScannetProtocol, AsksForAHundredPoints)
{
  for (const std::size_t points : {99u, 100u}) {
    const Evaluation evaluation =
        evaluate({overlapsOfRuns({{points, 1, 3, 1}, {200, 2, 3, 0}})}, scannet, {3});
    const std::size_t large = points == 100 ? 1 : 0;
    EXPECT_EQ(evaluation.classes[0].truths, 1 + large);
    EXPECT_EQ(evaluation.classes[0].predictions, large);
    // R = 1/2, P = 1: 1/2 * 2 / 2; without the small ones, one truth and nothing else.
    EXPECT_DOUBLE_EQ(evaluation.mean.ap50, large == 1 ? 0.5 : 0.0);
  }
}

TEST(ScannetProtocol, ScoresClassesWithoutPredictionsAsZero)
{
  const Evaluation evaluation =
      evaluate({overlapsOfRuns({{150, 1, 3, 1}, {150, 2, 4, 0}})}, scannet, {3, 4, 5});
  EXPECT_DOUBLE_EQ(evaluation.classes[0].figures.ap, 1.0);
  EXPECT_DOUBLE_EQ(evaluation.classes[1].figures.ap, 0.0);
  EXPECT_DOUBLE_EQ(evaluation.mean.ap, 0.5);
}

TEST(S3disProtocol, AveragesCoverageOverRooms)
{
  // Room 1: truths of 4 and 2 points, best IoU 2/4 and 0: mean 1/4, weighted
  // (1/2 * 4 + 0 * 2) / 6 = 1/3. Room 2: one truth, IoU 1. mCov = (1/4 + 1) / 2 = 5/8,
  // mWCov = (1/3 + 1) / 2 = 2/3. Room 3 has none of this class.
  const Evaluation evaluation =
      evaluate({overlapsOfRuns({{2, 1, 1, 1}, {2, 1, 1, 0}, {2, 2, 1, 0}}),
                overlapsOfRuns({{5, 1, 1, 3}}),
                overlapsOfRuns({{5, 1, 2, 3}})},
               s3dis,
               {1, 2});
  const EvaluationFigures& figures = evaluation.classes[0].figures;
  EXPECT_DOUBLE_EQ(figures.coverage, 5.0 / 8.0);
  EXPECT_DOUBLE_EQ(figures.weighted_coverage, 2.0 / 3.0);
  // An IoU of 1/2 is a hit here, and none for AP50.
  EXPECT_DOUBLE_EQ(figures.precision, 1.0);
  EXPECT_DOUBLE_EQ(figures.recall, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(figures.precision50, 1.0 / 2.0);
  EXPECT_DOUBLE_EQ(figures.recall50, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(evaluation.mean.precision, 1.0);
  EXPECT_DOUBLE_EQ(evaluation.mean.recall, (2.0 / 3.0 + 1.0) / 2.0);
}

TEST(S3disProtocol, CountsEveryHitOnTheSameTruth)
{
  // Two halves of one instance: IoU 1/2 twice, 2 hits for 1 truth.
  const Evaluation halves =
      evaluate({overlapsOfRuns({{3, 1, 1, 1}, {3, 1, 1, 2}})}, s3dis, {1});
  EXPECT_DOUBLE_EQ(halves.mean.precision, 1.0);
  EXPECT_DOUBLE_EQ(halves.mean.recall, 2.0);
  EXPECT_DOUBLE_EQ(halves.mean.coverage, 0.5);
}

TEST(S3disProtocol, ComparesWithinAClassOnly)
{
  const Evaluation evaluation =
      evaluate({overlapsOfRuns({{4, 1, 1, 1}}, {{1, 2}})}, s3dis, {1, 2});
  EXPECT_DOUBLE_EQ(evaluation.classes[0].figures.coverage, 0.0);
  EXPECT_DOUBLE_EQ(evaluation.classes[0].figures.precision, 0.0);
  EXPECT_TRUE(std::isnan(evaluation.classes[1].figures.precision));
  EXPECT_DOUBLE_EQ(evaluation.mean_iou, 1.0); // whatever the class
}

TEST(GroupFigures, PoolPurityCompactnessAndMeanIoU)
{
  // Scan 1: group 1 has 3 + 1 points of truths 1 and 2, group 2 has 2 of truth 2; 5
  // points without truth do not count. Scan 2: truth 1 has 4 points, none predicted.
  // Purity (3 + 2) / (6 + 4); compactness 3 / 2; best IoU 3/(3+9-3), 2/(3+2-2), 0.
  const std::vector<InstanceOverlaps> scans{
      overlapsOfRuns({{3, 1, 1, 1}, {1, 2, 1, 1}, {2, 2, 1, 2}, {5, 0, 0, 1}}),
      overlapsOfRuns({{4, 1, 1, 0}})};
  for (const EvaluationProtocol protocol : {paper, scannet, s3dis}) {
    const Evaluation evaluation = evaluate(scans, protocol, {1});
    EXPECT_EQ(evaluation.truths, 3u);
    EXPECT_EQ(evaluation.groups, 2u);
    EXPECT_EQ(evaluation.truth_points, 10u);
    EXPECT_DOUBLE_EQ(evaluation.purity, 5.0 / 10.0);
    EXPECT_DOUBLE_EQ(evaluation.compactness, 3.0 / 2.0);
    EXPECT_DOUBLE_EQ(evaluation.mean_iou, (3.0 / 9.0 + 2.0 / 3.0 + 0.0) / 3.0);
  }
}

TEST(GroupFigures, OfNothingAreUndefined)
{
  for (const EvaluationProtocol protocol : {paper, scannet, s3dis}) {
    const Evaluation nothing = evaluate({}, protocol, {1});
    for (const double figure :
         {nothing.purity, nothing.compactness, nothing.mean_iou, nothing.mean.ap50})
      EXPECT_TRUE(std::isnan(figure));
    const Evaluation no_groups =
        evaluate({overlapsOfRuns({{4, 1, 1, 0}})}, protocol, {1});
    EXPECT_EQ(no_groups.purity, 0.0);
    EXPECT_EQ(no_groups.mean_iou, 0.0);
    EXPECT_TRUE(std::isnan(no_groups.compactness));
  }
}

TEST(Evaluation, RefusesClassesThatCannotBeScored)
{
  EXPECT_THROW(evaluate({}, scannet, {3, 0}), CIDException);
  EXPECT_THROW(evaluate({}, scannet, {3, 5, 3}), CIDException);
}

TEST(Evaluation, OfThePerfectPredictionIsOneInEveryFigure)
{
  const std::vector<InstanceOverlaps> scans{
      overlapsOfRuns({{150, 1, 1, 1}, {120, 2, 2, 2}, {300, 3, 1, 3}}),
      overlapsOfRuns({{100, 8, 2, 8}})};
  for (const EvaluationProtocol protocol : {paper, scannet, s3dis}) {
    const Evaluation evaluation = evaluate(scans, protocol, {1, 2});
    for (const NamedFigure& figure : figuresOf(protocol))
      EXPECT_DOUBLE_EQ(evaluation.mean.*figure.value, 1.0) << figure.name;
    EXPECT_DOUBLE_EQ(evaluation.purity, 1.0);
    EXPECT_DOUBLE_EQ(evaluation.compactness, 1.0);
    EXPECT_DOUBLE_EQ(evaluation.mean_iou, 1.0);
  }
}

} // namespace
} // namespace pcl_cid::test
