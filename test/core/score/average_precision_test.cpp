/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Matches and average precision: examples worked by hand, ScanNet's corner cases.
 */

#include "labelled_runs.h"

#include "score/average_precision.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

using Confidences = std::vector<double>;

InstanceMatches
matchesOf(const Confidences& right, const Confidences& wrong, std::size_t missed)
{
  InstanceMatches matches;
  for (const double confidence : right)
    matches.detections.push_back({confidence, true});
  for (const double confidence : wrong)
    matches.detections.push_back({confidence, false});
  matches.missed = missed;
  return matches;
}

/** The confidences of the right, or the wrong, detections, ascending. */
Confidences
confidencesOf(const InstanceMatches& matches, bool right)
{
  Confidences confidences;
  for (const Detection& detection : matches.detections)
    if (detection.is_right == right)
      confidences.push_back(detection.confidence);
  std::sort(confidences.begin(), confidences.end());
  return confidences;
}

/** Match class 1, the only one that counts. */
InstanceMatches
matchClassOne(const InstanceOverlaps& scan, double threshold, MatchingRules rules = {})
{
  rules.classes = {1};
  return matchInstances(classOverlaps({scan}, 1, rules), threshold);
}

TEST(AveragePrecision, OfOneConfidenceIsHalfOfRTimesOnePlusP)
{
  // R = 6 / 10, P = 6 / 8: 0.6 * 1.75 / 2 = 0.525
  const InstanceMatches matches =
      matchesOf(Confidences(6, 1.0), Confidences(2, 1.0), 4);
  EXPECT_DOUBLE_EQ(averagePrecision(matches), 0.525);
  EXPECT_DOUBLE_EQ(precisionOf(matches), 0.75);
  EXPECT_DOUBLE_EQ(recallOf(matches), 0.6);
  for (std::size_t right = 0; right < 4; ++right)
    for (std::size_t wrong = 0; wrong < 4; ++wrong)
      for (std::size_t missed = 0; missed < 4; ++missed) {
        const InstanceMatches any =
            matchesOf(Confidences(right, 0.3), Confidences(wrong, 0.3), missed);
        if (right + missed == 0)
          continue;
        EXPECT_NEAR(averagePrecision(any),
                    recallOf(any) * (1.0 + precisionOf(any)) / 2.0,
                    1e-15);
      }
}

TEST(AveragePrecision, OfDistinctConfidences)
{
  // Three truths. From the lowest confidence on, (P, R): (2/3, 2/3), (1/2, 1/3),
  // (1, 1/3), and the end (1, 0). Weights (R before - R after) / 2: 1/6, 1/6, 1/6, 1/6.
  // (2/3 + 1/2 + 1 + 1) / 6 = 19/36
  EXPECT_DOUBLE_EQ(averagePrecision(matchesOf({0.9, 0.7}, {0.8}, 1)), 19.0 / 36.0);
}

TEST(AveragePrecision, TakesTiesTogetherInAnyOrder)
{
  // Two truths: (2/3, 1) for 0.5 and more, (1/2, 1/2) for 0.9, the end (1, 0).
  // 2/3 * 1/4 + 1/2 * 1/2 + 1 * 1/4 = 2/3
  InstanceMatches matches = matchesOf({0.9, 0.5}, {0.9}, 0);
  EXPECT_DOUBLE_EQ(averagePrecision(matches), 2.0 / 3.0);
  std::reverse(matches.detections.begin(), matches.detections.end());
  EXPECT_DOUBLE_EQ(averagePrecision(matches), 2.0 / 3.0);
}

TEST(AveragePrecision, WithoutPredictionsIsZeroAndWithoutTruthUndefined)
{
  EXPECT_EQ(averagePrecision(matchesOf({}, {}, 3)), 0.0);
  EXPECT_EQ(precisionOf(matchesOf({}, {}, 3)), 0.0);
  EXPECT_EQ(recallOf(matchesOf({}, {}, 3)), 0.0);
  for (const InstanceMatches& matches : {matchesOf({}, {}, 0), matchesOf({}, {1.0}, 0)})
    for (const double figure :
         {averagePrecision(matches), precisionOf(matches), recallOf(matches)})
      EXPECT_TRUE(std::isnan(figure));
}

TEST(InstanceMatching, AsksForAnIoUAboveTheThreshold)
{
  // 2 of 3 points: IoU 2/3. 2 of 4 points: IoU 1/2, which is not above 0.5.
  const InstanceOverlaps two_thirds = overlapsOfRuns({{2, 1, 1, 1}, {1, 1, 1, 0}});
  const InstanceOverlaps half = overlapsOfRuns({{2, 1, 1, 1}, {2, 1, 1, 0}});
  for (const double threshold : {0.25, 0.5, 0.75}) {
    const bool hit = threshold < 0.75;
    const InstanceMatches matches = matchClassOne(two_thirds, threshold);
    EXPECT_EQ(matches.missed, hit ? 0u : 1u);
    EXPECT_EQ(confidencesOf(matches, true).size(), hit ? 1u : 0u);
    EXPECT_EQ(confidencesOf(matches, false).size(), hit ? 0u : 1u);
  }
  EXPECT_EQ(matchClassOne(half, 0.5).missed, 1u);
  EXPECT_EQ(matchClassOne(half, std::nextafter(0.5, 0.0)).missed, 0u);
}

TEST(InstanceMatching, CountsAFurtherHitAsWrongWithTheLowerConfidence)
{
  // Two predictions, 4 of the 10 points each: IoU 0.4 above 0.25, twice.
  InstanceOverlaps scan = overlapsOfRuns({{4, 1, 1, 1}, {4, 1, 1, 2}, {2, 1, 1, 0}});
  // Of equal confidence: R = 1, P = 1/2, AP = 1 * 1.5 / 2
  EXPECT_DOUBLE_EQ(averagePrecision(matchClassOne(scan, 0.25)), 0.75);
  // The first that comes is the less sure one, but the truth keeps the better score:
  // (1/2, 1), (1, 1), end (1, 0): 1/2 * 0 + 1 * 1/2 + 1 * 1/2 = 1
  scan.predictions[0].confidence = 0.5;
  scan.predictions[1].confidence = 0.9;
  const InstanceMatches matches = matchClassOne(scan, 0.25);
  EXPECT_EQ(confidencesOf(matches, true), Confidences{0.9});
  EXPECT_EQ(confidencesOf(matches, false), Confidences{0.5});
  EXPECT_DOUBLE_EQ(averagePrecision(matches), 1.0);
}

TEST(InstanceMatching, LeavesAFurtherHitToTheNextTruth)
{
  // Truth 1 has 12 points, truth 2 has 6. "Near" has 5 of truth 1: IoU 5/12. "Both" has
  // 6 of truth 1, IoU 6 / (12 + 12 - 6) = 1/3, and 6 of truth 2, IoU 6/12.
  const auto scan = [](std::uint32_t near, std::uint32_t both) {
    return overlapsOfRuns(
        {{5, 1, 1, near}, {6, 1, 1, both}, {1, 1, 1, 0}, {6, 2, 1, both}});
  };
  // "Near" comes first: truth 1 takes it, "both" is a wrong one more, and right for 2.
  const InstanceMatches near_first = matchClassOne(scan(1, 2), 0.25);
  EXPECT_EQ(near_first.missed, 0u);
  EXPECT_EQ(confidencesOf(near_first, true).size(), 2u);
  EXPECT_EQ(confidencesOf(near_first, false).size(), 1u);
  // "Both" comes first: truth 1 uses it up, and truth 2 is missed.
  const InstanceMatches both_first = matchClassOne(scan(2, 1), 0.25);
  EXPECT_EQ(both_first.missed, 1u);
  EXPECT_EQ(confidencesOf(both_first, true).size(), 1u);
  EXPECT_EQ(confidencesOf(both_first, false).size(), 1u);
}

TEST(InstanceMatching, PassesOverWhatLiesOnVoid)
{
  MatchingRules rules;
  rules.pass_over_void = true;
  // 6 of the 10 points of the prediction have no truth, or one of another, uncounted
  // class: 0.6 is above 0.5, not above 0.75.
  for (const std::uint32_t label : {0u, 7u}) {
    const InstanceOverlaps scan =
        overlapsOfRuns({{6, label, 2, 1}, {4, 1, 1, 1}, {96, 1, 1, 0}}, {{1, 1}});
    EXPECT_EQ(matchClassOne(scan, 0.5, rules).detections.size(), 0u);
    EXPECT_EQ(confidencesOf(matchClassOne(scan, 0.75, rules), false).size(), 1u);
    EXPECT_EQ(confidencesOf(matchClassOne(scan, 0.5), false).size(), 1u);
  }
  // Exactly half of it is not above 0.5.
  const InstanceOverlaps half =
      overlapsOfRuns({{5, 0, 0, 1}, {5, 1, 1, 1}, {95, 1, 1, 0}}, {{1, 1}});
  EXPECT_EQ(confidencesOf(matchClassOne(half, 0.5, rules), false).size(), 1u);
}

TEST(InstanceMatching, DoesNotCountOtherClassesThatCountAsVoid)
{
  MatchingRules rules;
  rules.classes = {1, 2};
  rules.pass_over_void = true;
  const InstanceOverlaps scan =
      overlapsOfRuns({{10, 1, 2, 1}, {10, 2, 1, 0}}, {{1, 1}});
  const InstanceMatches matches = matchInstances(classOverlaps({scan}, 1, rules), 0.5);
  EXPECT_EQ(confidencesOf(matches, false).size(), 1u);
  EXPECT_EQ(matches.missed, 1u);
}

TEST(InstanceMatching, NeitherLooksForSmallTruthNorBlamesThePredictionsOnIt)
{
  MatchingRules rules;
  rules.min_points = 10;
  rules.pass_over_void = true;
  // Truth 1 has 9 points. The prediction of 12 points hits it: IoU 9/12 > 0.5.
  const InstanceOverlaps hit =
      overlapsOfRuns({{9, 1, 1, 1}, {3, 2, 1, 1}, {20, 2, 1, 0}});
  const InstanceMatches of_hit = matchClassOne(hit, 0.5, rules);
  EXPECT_EQ(of_hit.detections.size(), 0u);
  EXPECT_EQ(of_hit.missed, 1u); // truth 2, of 23 points
  // Two small ones, 8 points each, of a prediction of 20: no IoU above 0.5, but 16/20
  // of it lies on small truth.
  const InstanceOverlaps spread =
      overlapsOfRuns({{8, 1, 1, 1}, {8, 2, 1, 1}, {4, 3, 1, 1}, {20, 3, 1, 0}});
  EXPECT_EQ(matchClassOne(spread, 0.5, rules).detections.size(), 0u);
  rules.pass_over_void = false;
  EXPECT_EQ(matchClassOne(spread, 0.5, rules).detections.size(), 1u);
}

TEST(InstanceMatching, DropsSmallPredictions)
{
  MatchingRules rules;
  rules.min_points = 10;
  // 9 of 10 points: IoU 0.9, but too small to be taken into account.
  const InstanceOverlaps scan = overlapsOfRuns({{9, 1, 1, 1}, {1, 1, 1, 0}});
  const InstanceMatches matches = matchClassOne(scan, 0.5, rules);
  EXPECT_EQ(matches.detections.size(), 0u);
  EXPECT_EQ(matches.missed, 1u);
}

TEST(InstanceMatching, PoolsScansWithoutMixingThem)
{
  // The same labels in both scans; right in one, wrong in the other.
  const InstanceOverlaps right = overlapsOfRuns({{4, 1, 1, 1}});
  const InstanceOverlaps wrong = overlapsOfRuns({{1, 1, 1, 1}, {3, 1, 1, 0}});
  MatchingRules rules;
  rules.classes = {1};
  const InstanceMatches matches =
      matchInstances(classOverlaps({right, wrong}, 1, rules), 0.5);
  EXPECT_EQ(confidencesOf(matches, true).size(), 1u);
  EXPECT_EQ(confidencesOf(matches, false).size(), 1u);
  EXPECT_EQ(matches.missed, 1u);
}

} // namespace
} // namespace pcl_cid::test
