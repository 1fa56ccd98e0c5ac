/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Predictions matched to the truth, and the average precision of the matches.
 */

#pragma once

#include <pcl_cid/core/instance_overlaps.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief Which instances take part in a matching. */
struct MatchingRules {
  /** The classes that count, ascending. */
  std::vector<std::uint32_t> classes;
  /** Smaller predictions are dropped; smaller truth instances are not looked for. */
  std::size_t min_points = 1;
  /** Whether a prediction that is wrong is passed over, instead of counted as wrong,
   *  when most of it has no truth that counts (see matchInstances()). */
  bool pass_over_void = false;
};

/** \brief The instances of one class, of any number of scans. */
struct ClassOverlaps {
  struct Prediction {
    double confidence;
    /** Share of its points that are void: on no truth instance, or on one that does not
     *  count. */
    double void_share;
  };
  struct Overlap {
    std::size_t truth;
    std::size_t prediction;
    double iou;
  };

  /** For each truth instance, by scan and label, whether it is looked for. */
  std::vector<bool> truth_counts;
  std::vector<Prediction> predictions;
  /** By truth, then by prediction. */
  std::vector<Overlap> overlaps;

  /** \brief Number of truth instances that are looked for. */
  std::size_t
  truths() const;
};

/** \brief Collect the instances of one class. */
ClassOverlaps
classOverlaps(const std::vector<InstanceOverlaps>& scans,
              std::uint32_t semantic,
              const MatchingRules& rules);

/** \brief A prediction, and whether it is right. */
struct Detection {
  double confidence;
  bool is_right;
};

/** \brief What is right, wrong and missing. */
struct InstanceMatches {
  std::vector<Detection> detections;
  /** Truth instances without a detection. */
  std::size_t missed = 0;
};

/** \brief Match the instances of one class as ScanNet's benchmark does.
 *
 *  The truth instances that count take their turns. Each looks at the predictions that
 *  overlap it and are not used: the first whose IoU is *above* the threshold is right
 *  and used from then on. A further one makes a wrong detection, and stays unused; of
 *  the two confidences the lower one goes to the wrong detection. A prediction that no
 *  truth instance (even one that does not count) overlaps by more than the threshold is
 *  wrong; unless void is passed over and more than the threshold of it is void.
 *  \param[in] threshold of the IoU, 0 to 1 */
InstanceMatches
matchInstances(const ClassOverlaps& overlaps, double threshold);

/** \brief Area under the curve of precision over recall, by ScanNet's rule.
 *
 *  The curve has a point for each distinct confidence c (precision and recall of the
 *  detections with confidence c or more), by falling recall, and ends at recall 0 with
 *  precision 1. Each precision is weighted by half the difference of the recalls before
 *  and after it. With a single confidence this is R (1 + P) / 2.
 *  \return 0 without detections; NaN when there is nothing to find */
double
averagePrecision(const InstanceMatches& matches);

/** \brief Right detections over all of them; 0 when there are none; NaN when there is
 *  nothing to find. */
double
precisionOf(const InstanceMatches& matches);

/** \brief Right detections over truth instances; NaN when there are none. */
double
recallOf(const InstanceMatches& matches);

} // namespace pcl_cid
