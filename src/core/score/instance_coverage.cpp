/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How well truth instances are covered, as the ASIS protocol scores S3DIS.
 */

#include "instance_coverage.h"

#include <algorithm>
#include <limits>

namespace pcl_cid {
namespace {

constexpr double hit_iou = 0.5;

/** The best IoU of each instance of one scan with one of the other side, in one class.
 */
struct BestIoUs {
  std::vector<double> of_truths;
  std::vector<double> of_predictions;
};

BestIoUs
bestIoUs(const InstanceOverlaps& scan, std::uint32_t semantic)
{
  BestIoUs best{std::vector<double>(scan.truths.size(), 0.0),
                std::vector<double>(scan.predictions.size(), 0.0)};
  for (const InstanceOverlap& overlap : scan.overlaps) {
    if (scan.truths[overlap.truth].semantic != semantic ||
        scan.predictions[overlap.prediction].semantic != semantic)
      continue;
    double& of_truth = best.of_truths[overlap.truth];
    double& of_prediction = best.of_predictions[overlap.prediction];
    of_truth = std::max(of_truth, scan.iou(overlap));
    of_prediction = std::max(of_prediction, scan.iou(overlap));
  }
  return best;
}

/** The sums of one class. */
struct Sums {
  double mean = 0.0;
  double weighted_mean = 0.0;
  std::size_t scans = 0;
  std::size_t truths = 0;
  std::size_t predictions = 0;
  std::size_t hits = 0;
};

void
addTruths(const InstanceOverlaps& scan,
          std::uint32_t semantic,
          const std::vector<double>& best,
          Sums& sums)
{
  double iou = 0.0;
  double weighted_iou = 0.0;
  std::size_t points = 0;
  std::size_t truths = 0;
  for (std::size_t i = 0; i < scan.truths.size(); ++i) {
    if (scan.truths[i].semantic != semantic)
      continue;
    iou += best[i];
    weighted_iou += best[i] * static_cast<double>(scan.truths[i].points);
    points += scan.truths[i].points;
    ++truths;
  }
  if (truths == 0)
    return;
  sums.mean += iou / static_cast<double>(truths);
  sums.weighted_mean += weighted_iou / static_cast<double>(points);
  sums.truths += truths;
  ++sums.scans;
}

void
addPredictions(const InstanceOverlaps& scan,
               std::uint32_t semantic,
               const std::vector<double>& best,
               Sums& sums)
{
  for (std::size_t i = 0; i < scan.predictions.size(); ++i)
    if (scan.predictions[i].semantic == semantic) {
      ++sums.predictions;
      sums.hits += best[i] >= hit_iou ? 1 : 0;
    }
}

} // namespace

InstanceCoverage
coverageOf(const std::vector<InstanceOverlaps>& scans, std::uint32_t semantic)
{
  Sums sums;
  for (const InstanceOverlaps& scan : scans) {
    const BestIoUs best = bestIoUs(scan, semantic);
    addTruths(scan, semantic, best.of_truths, sums);
    addPredictions(scan, semantic, best.of_predictions, sums);
  }
  if (sums.truths == 0) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none, none};
  }
  const auto count = static_cast<double>(sums.scans);
  const auto hits = static_cast<double>(sums.hits);
  return {sums.mean / count,
          sums.weighted_mean / count,
          sums.predictions == 0 ? 0.0 : hits / static_cast<double>(sums.predictions),
          hits / static_cast<double>(sums.truths)};
}

} // namespace pcl_cid
