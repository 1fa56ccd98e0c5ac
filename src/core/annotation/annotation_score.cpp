/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the labels after some clicks are worth.
 */

#include "clicked_session.h"
#include <pcl_cid/core/annotation.h>
#include <pcl_cid/core/evaluation.h>

#include <algorithm>
#include <utility>

namespace pcl_cid {
namespace {

double
meanIou(const InstanceOverlaps& scan)
{
  double sum = 0.0;
  for (const InstanceOverlap& overlap : scan.overlaps)
    sum += scan.iou(overlap);
  return sum / static_cast<double>(scan.truths.size());
}

double
clicksPerInstance(const AnnotationState& state)
{
  return static_cast<double>(state.clicks) /
         static_cast<double>(state.overlaps.truths.size());
}

} // namespace

InstanceOverlaps
annotationOverlaps(std::vector<std::uint32_t> labels,
                   const std::vector<std::uint32_t>& truth)
{
  for (std::size_t i = 0; i < std::min(labels.size(), truth.size()); ++i)
    if (truth[i] == 0)
      labels[i] = 0;
  const std::vector<std::uint32_t> classes(truth.size(), class_of_instances);
  return overlapsOf({std::move(labels), {}}, {truth, classes});
}

AnnotationScore
scoreAnnotations(const std::vector<InstanceOverlaps>& scans)
{
  AnnotationScore score;
  for (const InstanceOverlaps& scan : scans) {
    score.instances += scan.truths.size();
    for (const InstanceOverlap& overlap : scan.overlaps) {
      const double iou = scan.iou(overlap);
      score.mean_iou += iou;
      score.recall25 += iou >= 0.25 ? 1.0 : 0.0;
      score.recall50 += iou >= 0.50 ? 1.0 : 0.0;
      score.recall75 += iou >= 0.75 ? 1.0 : 0.0;
    }
  }
  for (double* const figure :
       {&score.mean_iou, &score.recall25, &score.recall50, &score.recall75})
    *figure /= static_cast<double>(score.instances);
  // What belongs together is known; this protocol asks for no labels of the truth.
  score.ap50 =
      evaluate(scans, EvaluationProtocol::s3dis, {class_of_instances}).mean.ap50;
  return score;
}

double
meanIouAt(const std::vector<AnnotationState>& states, double clicks_per_instance)
{
  double iou = meanIou(states.front().overlaps);
  for (const AnnotationState& state : states)
    if (clicksPerInstance(state) <= clicks_per_instance)
      iou = meanIou(state.overlaps);
  return iou;
}

double
clicksToReach(const std::vector<AnnotationState>& states, double iou, double budget)
{
  for (const AnnotationState& state : states)
    if (meanIou(state.overlaps) >= iou)
      return clicksPerInstance(state);
  return budget;
}

} // namespace pcl_cid
