/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Scans for tests of the scores, written down as runs of points.
 */

#pragma once

#include <pcl_cid/core/instance_overlaps.h>

#include <map>
#include <vector>

namespace pcl_cid::test {

/** \brief Points of a scan that have everything in common. */
struct LabelledRun {
  std::size_t points;
  std::uint32_t truth;
  std::uint32_t true_class;
  std::uint32_t prediction;
};

/** \brief Count a scan.
 *  \param[in] predicted_class of the predicted instances, by label; when it is empty,
 *  predictions have no classes of their own */
inline InstanceOverlaps
overlapsOfRuns(const std::vector<LabelledRun>& runs,
               const std::map<std::uint32_t, std::uint32_t>& predicted_class = {})
{
  PointLabels truth;
  PointLabels prediction;
  for (const LabelledRun& run : runs) {
    truth.label.insert(truth.label.end(), run.points, run.truth);
    truth.semantic.insert(truth.semantic.end(), run.points, run.true_class);
    prediction.label.insert(prediction.label.end(), run.points, run.prediction);
    if (!predicted_class.empty())
      prediction.semantic.insert(
          prediction.semantic.end(),
          run.points,
          run.prediction == 0 ? 0 : predicted_class.at(run.prediction));
  }
  return overlapsOf(prediction, truth);
}

} // namespace pcl_cid::test
