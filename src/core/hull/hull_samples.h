/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Samples spread evenly over a hull's surface, through its volume, and in a box.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid {

/** \brief The n-th of a sequence of points that fill the unit cube ever more evenly, by
 *  steps of the generalized golden ratio: what additive recurrences use. */
Eigen::Vector3d
evenInCube(std::size_t n);

/** \brief Samples on the surface of a closed mesh, one to each equal share of the area.
 */
std::vector<Eigen::Vector3d>
surfaceSamples(const TriangleMesh& mesh, std::size_t count);

/** \brief Samples inside a closed convex mesh, one to each equal share of the volume.
 */
std::vector<Eigen::Vector3d>
volumeSamples(const TriangleMesh& mesh, std::size_t count);

} // namespace pcl_cid
