/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Predictions matched to the truth, and the average precision of the matches.
 */

#include "average_precision.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace pcl_cid {
namespace {

double
ratio(std::size_t part, std::size_t whole)
{
  return static_cast<double>(part) / static_cast<double>(whole);
}

/** Gathers one class scan by scan. */
class ClassCollector {
public:
  ClassCollector(std::uint32_t semantic, const MatchingRules& rules)
  : semantic_(semantic), rules_(rules)
  {
  }

  void
  add(const InstanceOverlaps& scan)
  {
    const std::vector<std::size_t> truths = addTruths(scan);
    const std::vector<std::size_t> predictions = addPredictions(scan);
    for (const InstanceOverlap& overlap : scan.overlaps)
      if (const std::size_t truth = truths[overlap.truth],
          prediction = predictions[overlap.prediction];
          truth != absent && prediction != absent)
        collected_.overlaps.push_back({truth, prediction, scan.iou(overlap)});
  }

  ClassOverlaps
  collected() &&
  {
    return std::move(collected_);
  }

private:
  static constexpr std::size_t absent = std::numeric_limits<std::size_t>::max();

  bool
  isLarge(const Instance& instance) const
  {
    return instance.points >= rules_.min_points;
  }

  /** Whether a predicted point on it is no evidence against the prediction. */
  bool
  isVoid(const Instance& truth) const
  {
    const bool counts = std::binary_search(
        rules_.classes.begin(), rules_.classes.end(), truth.semantic);
    return !counts || (truth.semantic == semantic_ && !isLarge(truth));
  }

  /** \return for each truth instance of the scan its place in the collection */
  std::vector<std::size_t>
  addTruths(const InstanceOverlaps& scan)
  {
    std::vector<std::size_t> places(scan.truths.size(), absent);
    for (std::size_t i = 0; i < scan.truths.size(); ++i) {
      if (scan.truths[i].semantic != semantic_)
        continue;
      places[i] = collected_.truth_counts.size();
      collected_.truth_counts.push_back(isLarge(scan.truths[i]));
    }
    return places;
  }

  /** The same for the predictions. */
  std::vector<std::size_t>
  addPredictions(const InstanceOverlaps& scan)
  {
    const std::vector<double> void_shares = voidShares(scan);
    std::vector<std::size_t> places(scan.predictions.size(), absent);
    for (std::size_t i = 0; i < scan.predictions.size(); ++i) {
      const PredictedInstance& prediction = scan.predictions[i];
      if (prediction.semantic != semantic_ || !isLarge(prediction))
        continue;
      places[i] = collected_.predictions.size();
      collected_.predictions.push_back({prediction.confidence, void_shares[i]});
    }
    return places;
  }

  std::vector<double>
  voidShares(const InstanceOverlaps& scan) const
  {
    std::vector<double> shares(scan.predictions.size(), 0.0);
    if (!rules_.pass_over_void)
      return shares;
    std::vector<std::size_t> on_truth(scan.predictions.size(), 0);
    for (const InstanceOverlap& overlap : scan.overlaps)
      if (!isVoid(scan.truths[overlap.truth]))
        on_truth[overlap.prediction] += overlap.points;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const std::size_t points = scan.predictions[i].points;
      shares[i] = ratio(points - on_truth[i], points);
    }
    return shares;
  }

  std::uint32_t semantic_;
  const MatchingRules& rules_;
  ClassOverlaps collected_;
};

std::size_t
rightOnes(const InstanceMatches& matches)
{
  return static_cast<std::size_t>(
      std::count_if(matches.detections.begin(),
                    matches.detections.end(),
                    [](const Detection& detection) { return detection.is_right; }));
}

/** A point of the curve. */
struct CurvePoint {
  double precision;
  double recall;
};

/** By rising confidence, so by falling recall. */
std::vector<CurvePoint>
precisionRecallCurve(const InstanceMatches& matches)
{
  std::vector<Detection> by_confidence = matches.detections;
  std::sort(by_confidence.begin(),
            by_confidence.end(),
            [](const Detection& a, const Detection& b) {
              return a.confidence < b.confidence;
            });
  const std::size_t truths = rightOnes(matches) + matches.missed;
  std::size_t right = rightOnes(matches);
  std::vector<CurvePoint> curve;
  for (std::size_t i = 0; i < by_confidence.size(); ++i) {
    const Detection& detection = by_confidence[i];
    if (i == 0 || detection.confidence > by_confidence[i - 1].confidence)
      curve.push_back({ratio(right, by_confidence.size() - i), ratio(right, truths)});
    right -= detection.is_right ? 1 : 0;
  }
  curve.push_back({1.0, 0.0});
  return curve;
}

} // namespace

std::size_t
ClassOverlaps::truths() const
{
  return static_cast<std::size_t>(
      std::count(truth_counts.begin(), truth_counts.end(), true));
}

ClassOverlaps
classOverlaps(const std::vector<InstanceOverlaps>& scans,
              std::uint32_t semantic,
              const MatchingRules& rules)
{
  ClassCollector collector(semantic, rules);
  for (const InstanceOverlaps& scan : scans)
    collector.add(scan);
  return std::move(collector).collected();
}

InstanceMatches
matchInstances(const ClassOverlaps& overlaps, double threshold)
{
  InstanceMatches matches;
  std::vector<bool> is_used(overlaps.predictions.size(), false);
  std::vector<bool> hits_any(overlaps.predictions.size(), false);
  auto overlap = overlaps.overlaps.begin();
  for (std::size_t truth = 0; truth < overlaps.truth_counts.size(); ++truth) {
    std::optional<double> best; // confidence of the match of this truth
    for (; overlap != overlaps.overlaps.end() && overlap->truth == truth; ++overlap) {
      if (!(overlap->iou > threshold))
        continue;
      hits_any[overlap->prediction] = true;
      if (!overlaps.truth_counts[truth] || is_used[overlap->prediction])
        continue;
      const double confidence = overlaps.predictions[overlap->prediction].confidence;
      if (best)
        matches.detections.push_back({std::min(*best, confidence), false});
      else
        is_used[overlap->prediction] = true;
      best = best ? std::max(*best, confidence) : confidence;
    }
    if (best)
      matches.detections.push_back({*best, true});
    else if (overlaps.truth_counts[truth])
      ++matches.missed;
  }
  for (std::size_t i = 0; i < overlaps.predictions.size(); ++i)
    if (!hits_any[i] && !(overlaps.predictions[i].void_share > threshold))
      matches.detections.push_back({overlaps.predictions[i].confidence, false});
  return matches;
}

double
averagePrecision(const InstanceMatches& matches)
{
  if (rightOnes(matches) + matches.missed == 0)
    return std::numeric_limits<double>::quiet_NaN();
  const std::vector<CurvePoint> curve = precisionRecallCurve(matches);
  double area = 0.0;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const double before = curve[k == 0 ? 0 : k - 1].recall;
    const double after = k + 1 < curve.size() ? curve[k + 1].recall : 0.0;
    area += curve[k].precision * 0.5 * (before - after);
  }
  return area;
}

double
precisionOf(const InstanceMatches& matches)
{
  const std::size_t right = rightOnes(matches);
  if (right + matches.missed == 0)
    return std::numeric_limits<double>::quiet_NaN();
  return matches.detections.empty() ? 0.0 : ratio(right, matches.detections.size());
}

double
recallOf(const InstanceMatches& matches)
{
  const std::size_t right = rightOnes(matches);
  return right + matches.missed == 0 ? std::numeric_limits<double>::quiet_NaN()
                                     : ratio(right, right + matches.missed);
}

} // namespace pcl_cid
