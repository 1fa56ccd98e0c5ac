/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Purity, and how well the instances of a scan are found.
 */

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid::benchmarks {

/** \brief Number of different labels, 0 not counted. */
std::size_t
countLabels(const std::vector<std::uint32_t>& labels);

/** \brief Purity: the sum over the groups of the size of the largest true instance in
 *  each, as a share of all points. Points without a true instance (0) do not count;
 *  those without a group (0) count as wrong. */
double
purityOf(const std::vector<std::uint32_t>& group,
         const std::vector<std::uint32_t>& instance);

/** \brief Labels by an annotator who names the true instance that each seed lies on,
 *  carried to the points of its group.
 *  \param[in] group from 1, in the order of the seeds */
std::vector<std::uint32_t>
labelsOfSeeds(const std::vector<std::uint32_t>& group,
              const pcl::Indices& seeds,
              const std::vector<std::uint32_t>& instance);

/** \brief How well instances are found, by the protocol of the paper (section V.A). */
struct InstanceScores {
  /** Mean over the classes, at IoU above 0.25, 0.5 and 0.75. */
  double ap25 = 0.0;
  double ap50 = 0.0;
  double ap75 = 0.0;
  /** Mean over the true instances; 0 for those that no seed lay on. */
  double mean_iou = 0.0;
};

/** \brief Predicted instance i is all points with the label i, and is compared with the
 *  true instance i. All predictions are equally sure, so AP is R (1 + P) / 2 with
 * recall R and precision P of a class. \param[in] labels see labelsOfSeeds() \param[in]
 * instance,semantic truth; an instance has the class of its first point */
InstanceScores
scoreInstances(const std::vector<std::uint32_t>& labels,
               const std::vector<std::uint32_t>& instance,
               const std::vector<std::uint32_t>& semantic);

} // namespace pcl_cid::benchmarks
