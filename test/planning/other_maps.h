/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Maps that other people would make of a scan.
 */

#pragma once

#include "collision_map.h"
#include "scan_hulls.h"

#include <pcl/Vertices.h>

namespace planning {

/** \brief A greedy triangulation of a scan by PCL: the vertices are its points. */
std::vector<pcl::Vertices>
triangulate(const Cloud::ConstPtr& scan);

/** \brief FCL's tree of oriented boxes over triangles. */
Shape
triangleShape(const Cloud& scan, const std::vector<pcl::Vertices>& triangles);

/** \brief Octomap's tree of occupied cells, in FCL.
 *  \param[in] cell size of the smallest cells, metres */
Shape
octreeShape(const Cloud& scan, double cell);

} // namespace planning
