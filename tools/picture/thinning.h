/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Few points in the place of many.
 */

#pragma once

#include <pcl_cid/core/point_set.h>

#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

namespace pcl_cid::tools {

/** \brief A box around a scan without what lies far astray: along each axis, around all
 *  but a thousandth of the points at either end, and a tenth of that more, where there
 *  are points.
 *  \param[in] points finite, at least 1 */
Eigen::AlignedBox3f
usualBox(const Points& points);

/** \brief Positions of points that are spread evenly over the scan: one in each cell of
 *  a grid, then one in each of those of a grid twice as fine that have none yet, and so
 *  on. The first ones are a thinner scan. The same ones each time.
 *  \param[in] points finite
 *  \param[in] box of the grid; what lies outside is in the cells at its border
 *  \param[in] most how many to take; fewer when there are fewer
 *  \note Cost: O(n log n), 40 bytes a point. */
std::vector<std::size_t>
spreadEvenly(const Points& points, const Eigen::AlignedBox3f& box, std::size_t most);

} // namespace pcl_cid::tools
