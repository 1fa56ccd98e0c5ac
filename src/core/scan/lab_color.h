/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Perceptual colors, CIE L*a*b*.
 */

#pragma once

#include "nearest_neighbors.h"
#include <pcl_cid/core/color.h>

#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief CIE L*a*b* of a color, for the white of sRGB (D65): L* is 0 to 100.
 *
 *  The difference of two colors is about their Euclidean distance here; 2.3 is just
 *  noticeable. */
Eigen::Vector3f
labOf(const ColorRGB& color);

/** \brief L*a*b* of each point, as the mean over itself and its near neighbors: a
 *  sensor's colors are noisy, and most surfaces span more than nine points.
 *  \param[in] colors of the points
 *  \param[in] neighbors of the points */
std::vector<Eigen::Vector3f>
smoothLab(const std::vector<ColorRGB>& colors, const NearestNeighbors& neighbors);

} // namespace pcl_cid
