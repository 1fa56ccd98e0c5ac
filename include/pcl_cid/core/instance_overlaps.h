/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the instances of a prediction and of the truth have in common.
 */

#pragma once

#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief Instance and class of every point of a scan. */
struct PointLabels {
  /** Number of its instance, 0 for none. */
  std::vector<std::uint32_t> label;
  /** Number of its class, 0 for none. */
  std::vector<std::uint32_t> semantic;
};

/** \brief All points of a scan with the same label. */
struct Instance {
  std::uint32_t label = 0;
  /** Number of its class, 0 for none. */
  std::uint32_t semantic = 0;
  std::size_t points = 0;
};

/** \brief An instance, and the confidence in it. */
struct PredictedInstance : Instance {
  double confidence = 1.0;
};

/** \brief Two instances with points in common. */
struct InstanceOverlap {
  /** Indices into the lists of InstanceOverlaps. */
  std::size_t truth = 0;
  std::size_t prediction = 0;
  /** Common points, at least 1. */
  std::size_t points = 0;
};

/** \brief A scan as the scores see it: a small table, whatever the number of points. */
struct InstanceOverlaps {
  /** By label, ascending, without 0. */
  std::vector<Instance> truths;
  std::vector<PredictedInstance> predictions;
  /** By truth, then by prediction. */
  std::vector<InstanceOverlap> overlaps;

  /** \brief Common points over points of either. */
  PCL_CID_EXPORT double
  iou(const InstanceOverlap& overlap) const;
};

/** \brief Count the common points of the instances of one scan.
 *
 *  The class of an instance is the one that most of its points have; of equally
 *  frequent ones the lowest number. 0 takes part in this.
 *  \param[in] prediction its `semantic` may be empty: then the class of a predicted
 *  instance is the one that most of its points have in the truth
 *  \param[in] truth a class for each point, too
 *  \throws CIDException when the lists differ in length
 *  \note Cost: O(n log m) for n points and m pairs of instances. */
PCL_CID_EXPORT InstanceOverlaps
overlapsOf(const PointLabels& prediction, const PointLabels& truth);

/** \brief Keep what two instances of the same label have in common, and give each
 *  predicted instance the class of the truth instance of its label: for predictions
 *  whose labels come from the truth, as those of an annotator do.
 *  \throws CIDException when a predicted label is not one of the truth */
PCL_CID_EXPORT InstanceOverlaps
sameLabelOverlaps(const InstanceOverlaps& overlaps);

/** \brief Pair the instances, and keep what those of a pair have in common: for
 *  predictions whose labels are numbers of their own, as those of a person are.
 *
 *  Pairs are made by falling IoU, of instances that are in none yet; of equal ones the
 *  first in the list. Above an IoU of 0.5 there is no choice: no instance can have that
 *  with two others.
 *  \note Cost: O(m log m) for m overlaps. */
PCL_CID_EXPORT InstanceOverlaps
pairedOverlaps(const InstanceOverlaps& overlaps);

} // namespace pcl_cid
