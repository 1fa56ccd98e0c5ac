/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scores of instance labels by the protocols of the paper, ScanNet and S3DIS.
 */

#include "average_precision.h"
#include "instance_coverage.h"

#include "base/sentence.h"

#include <pcl_cid/core/evaluation.h>
#include <pcl_cid/exceptions.h>

#include <algorithm>
#include <cmath>

namespace pcl_cid {
namespace {

/** Smallest instance of ScanNet's benchmark: `min_region_sizes` in
 *  evaluate_semantic_instance.py of ScanNet/ScanNet. */
constexpr std::size_t scannet_min_points = 100;

MatchingRules
rulesOf(EvaluationProtocol protocol, const std::vector<std::uint32_t>& classes)
{
  MatchingRules rules;
  rules.classes = classes;
  std::sort(rules.classes.begin(), rules.classes.end());
  if (!rules.classes.empty() && rules.classes.front() == 0)
    throw CIDException("class 0 means none; it cannot be scored");
  const auto twice = std::adjacent_find(rules.classes.begin(), rules.classes.end());
  if (twice != rules.classes.end())
    throw CIDException(
        sentence("class ", *twice, " is listed twice; each must be once"));
  if (protocol == EvaluationProtocol::scannet) {
    rules.min_points = scannet_min_points;
    rules.pass_over_void = true;
  }
  return rules;
}

/** AP, precision and recall at one threshold. */
void
scoreAt(double threshold,
        const ClassOverlaps& overlaps,
        double& ap,
        double& precision,
        double& recall)
{
  const InstanceMatches matches = matchInstances(overlaps, threshold);
  ap = averagePrecision(matches);
  precision = precisionOf(matches);
  recall = recallOf(matches);
}

/** Mean over the thresholds 0.50, 0.55 ... 0.90; as quotients, which round to the
 *  nearest double, so that an IoU of 3/5 is not above 0.60. */
double
meanAveragePrecision(const ClassOverlaps& overlaps)
{
  double sum = 0.0;
  int thresholds = 0;
  for (int twentieths = 10; twentieths <= 18; ++twentieths, ++thresholds)
    sum += averagePrecision(matchInstances(overlaps, twentieths / 20.0));
  return sum / thresholds;
}

ClassEvaluation
evaluateClass(std::uint32_t semantic,
              const std::vector<InstanceOverlaps>& scans,
              EvaluationProtocol protocol,
              const MatchingRules& rules)
{
  const ClassOverlaps overlaps = classOverlaps(scans, semantic, rules);
  ClassEvaluation result;
  result.semantic = semantic;
  result.truths = overlaps.truths();
  result.predictions = overlaps.predictions.size();
  EvaluationFigures& figures = result.figures;
  scoreAt(0.25, overlaps, figures.ap25, figures.precision25, figures.recall25);
  scoreAt(0.50, overlaps, figures.ap50, figures.precision50, figures.recall50);
  scoreAt(0.75, overlaps, figures.ap75, figures.precision75, figures.recall75);
  if (protocol == EvaluationProtocol::scannet)
    figures.ap = meanAveragePrecision(overlaps);
  if (protocol == EvaluationProtocol::s3dis) {
    const InstanceCoverage coverage = coverageOf(scans, semantic);
    figures.coverage = coverage.mean;
    figures.weighted_coverage = coverage.weighted_mean;
    figures.precision = coverage.precision;
    figures.recall = coverage.recall;
  }
  return result;
}

void
addMean(EvaluationProtocol protocol, Evaluation& evaluation)
{
  for (const ClassEvaluation& each : evaluation.classes)
    evaluation.classes_in_mean += each.truths > 0 ? 1 : 0;
  for (const NamedFigure& figure : figuresOf(protocol)) {
    double sum = 0.0;
    for (const ClassEvaluation& each : evaluation.classes)
      if (each.truths > 0)
        sum += each.figures.*figure.value;
    evaluation.mean.*figure.value =
        sum / static_cast<double>(evaluation.classes_in_mean);
  }
}

/** Counts over all instances of one or more scans. */
struct Totals {
  std::size_t pure_points = 0;
  double iou = 0.0;
};

Totals
totalsOf(const InstanceOverlaps& scan)
{
  std::vector<std::size_t> most(scan.predictions.size(), 0);
  std::vector<double> best(scan.truths.size(), 0.0);
  for (const InstanceOverlap& overlap : scan.overlaps) {
    most[overlap.prediction] = std::max(most[overlap.prediction], overlap.points);
    best[overlap.truth] = std::max(best[overlap.truth], scan.iou(overlap));
  }
  Totals totals;
  for (const std::size_t points : most)
    totals.pure_points += points;
  for (const double iou : best)
    totals.iou += iou;
  return totals;
}

/** Purity and compactness of section V, mean IoU: 0 / 0 gives the NaN that they
 *  promise. */
void
addGroupFigures(const std::vector<InstanceOverlaps>& scans, Evaluation& evaluation)
{
  Totals totals;
  for (const InstanceOverlaps& scan : scans) {
    const Totals of_scan = totalsOf(scan);
    totals.pure_points += of_scan.pure_points;
    totals.iou += of_scan.iou;
    evaluation.truths += scan.truths.size();
    evaluation.groups += scan.predictions.size();
    for (const Instance& truth : scan.truths)
      evaluation.truth_points += truth.points;
  }
  const auto truths = static_cast<double>(evaluation.truths);
  const auto groups = static_cast<double>(evaluation.groups);
  evaluation.purity = static_cast<double>(totals.pure_points) /
                      static_cast<double>(evaluation.truth_points);
  evaluation.mean_iou = totals.iou / truths;
  if (evaluation.groups > 0)
    evaluation.compactness = truths / groups;
}

} // namespace

std::vector<NamedFigure>
figuresOf(EvaluationProtocol protocol)
{
  using F = EvaluationFigures;
  std::vector<NamedFigure> figures{{"ap25", "AP25", &F::ap25},
                                   {"precision25", "P25", &F::precision25},
                                   {"recall25", "R25", &F::recall25},
                                   {"ap50", "AP50", &F::ap50},
                                   {"precision50", "P50", &F::precision50},
                                   {"recall50", "R50", &F::recall50},
                                   {"ap75", "AP75", &F::ap75},
                                   {"precision75", "P75", &F::precision75},
                                   {"recall75", "R75", &F::recall75}};
  if (protocol == EvaluationProtocol::scannet)
    figures.insert(figures.begin(), {"ap", "AP", &F::ap});
  if (protocol == EvaluationProtocol::s3dis)
    figures.insert(figures.begin(),
                   {{"coverage", "mCov", &F::coverage},
                    {"weighted_coverage", "mWCov", &F::weighted_coverage},
                    {"precision", "mPrec", &F::precision},
                    {"recall", "mRec", &F::recall}});
  return figures;
}

Evaluation
evaluate(const std::vector<InstanceOverlaps>& scans,
         EvaluationProtocol protocol,
         const std::vector<std::uint32_t>& classes)
{
  const MatchingRules rules = rulesOf(protocol, classes);
  std::vector<InstanceOverlaps> corresponding;
  if (protocol == EvaluationProtocol::paper)
    for (const InstanceOverlaps& scan : scans)
      corresponding.push_back(sameLabelOverlaps(scan));
  const auto& compared = protocol == EvaluationProtocol::paper ? corresponding : scans;

  Evaluation evaluation;
  for (const std::uint32_t semantic : classes)
    evaluation.classes.push_back(evaluateClass(semantic, compared, protocol, rules));
  addMean(protocol, evaluation);
  addGroupFigures(scans, evaluation);
  return evaluation;
}

} // namespace pcl_cid
