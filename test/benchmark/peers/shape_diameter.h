/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Shape diameters of a segment, and how unlike those of two segments are.
 */

#pragma once

#include "surface_graph.h"

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid::benchmarks {

/** \brief How thick a segment is, below some of its points (L. Shapira, A. Shamir, D.
 *  Cohen-Or, "Consistent mesh partitioning and skeletonisation using the shape diameter
 *  function", 2008), as the points of the segment alone tell.
 *
 *  For each sample, of the segment's points in a cone about its inner normal that are
 *  seen from behind, the median distance along the normal.
 *  \param[in] surface all points
 *  \param[in] segment indices of those of the segment
 *  \return one value for each sample that has a point opposite; none for a flat
 *  segment */
std::vector<double>
shapeDiameters(const OrientedPoints& surface, const std::vector<std::size_t>& segment);

/** \brief The earth mover's distance between the histograms of each two of several sets
 *  of values, bins of equal width from the least to the largest value of all; 0 where a
 *  set is empty. */
Eigen::MatrixXd
histogramDistances(const std::vector<std::vector<double>>& values);

} // namespace pcl_cid::benchmarks
