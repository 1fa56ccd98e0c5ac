/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How well truth instances are covered, as the ASIS protocol scores S3DIS.
 */

#pragma once

#include <pcl_cid/core/instance_overlaps.h>

#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief The figures of one class; NaN when it has no truth instance. */
struct InstanceCoverage {
  /** Mean over the scans that have the class, of the mean over its truth instances of
   *  the best IoU with a prediction of the class. */
  double mean;
  /** The same with a mean weighted by the points of the instances. */
  double weighted_mean;
  /** Predictions that some truth instance overlaps with an IoU of 0.5 or more, over the
   *  predictions; 0 when there are none. */
  double precision;
  /** The same number over the truth instances: above 1 when two predictions are halves
   *  of one instance. */
  double recall;
};

/** \brief Score one class over scans.
 *
 *  After models/ASIS/eval_iou_accuracy.py in WXinlong/ASIS. */
InstanceCoverage
coverageOf(const std::vector<InstanceOverlaps>& scans, std::uint32_t semantic);

} // namespace pcl_cid
