/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which way the surface faces at every point, but for the sign.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/point_set.h>

#include <cstddef>
#include <vector>

namespace pcl_cid {

/** \brief The normal at each point: the direction in which the points nearest to it
 *  spread least, by principal components in double.
 *  \param[in] points finite, metres
 *  \param[in] neighbors points that each is fitted to, its own included: at least 3; at
 *  equal distance those of lower index
 *  \param[in] execution threads and progress; never change a result
 *  \return of length 1, the component of largest size positive; 0 where the points are
 *  all at one place or in a line
 *  \throws CIDCancelled
 *  \note Cost: O(N log N). */
std::vector<Eigen::Vector3f>
surfaceNormals(const Points& points,
               std::size_t neighbors,
               const ExecutionOptions& execution);

/** \brief The same for some of the points, at their share of the cost.
 *  \param[in] wanted for each point whether its normal is; 0 for the others */
std::vector<Eigen::Vector3f>
surfaceNormals(const Points& points,
               std::size_t neighbors,
               const std::vector<bool>& wanted,
               const ExecutionOptions& execution);

} // namespace pcl_cid
