/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls for tests: made in one call, and held to what they promise.
 */

#pragma once

#include "clouds.h"

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/hull_primitive.h>
#include <pcl_cid/core/point_set.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl_cid::test {

/** All the points, numbered 0, 1, ... */
PointSet
pointSet(const Points& points);

/** The hull of all the points. */
ConvexPart
partOf(const Points& points, const ConvexPartOptions& options = {});

/** In double, as a hull has them. */
std::vector<Eigen::Vector3d>
inDouble(const Points& points);

/** How many triangles all the hulls have. */
std::size_t
trianglesOf(const std::vector<ConvexPart>& parts);

/** Of the box of some points. */
double
diagonalOf(const std::vector<Eigen::Vector3d>& points);

/** How far outside of a hull: the largest excess over its faces. */
double
excess(const TriangleMesh& hull, const Eigen::Vector3d& p);

/** The same for a primitive, from its definition; negative inside. */
double
excess(const HullPrimitive& primitive, const Eigen::Vector3d& place);

/** Fails with the first guarantee that a part breaks; its volume, area and thickness
 *  must be those of its hull.
 *  \param[in] points of the input cloud
 *  \param[in] what is said when it fails */
void
expectGuarantees(const ConvexPart& part,
                 const Points& points,
                 const ConvexPartOptions& options,
                 const std::string& what);

/** 1 to 60 points at a scale of 1 mm to 1 km: solid, flat in one to three directions, a
 *  bit flat, on a grid, or far from the origin. */
Points
randomSmallCloud(std::uint64_t seed);

/** The parts of a decomposed cloud: the number of the group of each point. */
std::vector<int>
groupsOf(const Points& points, std::size_t groups);

} // namespace pcl_cid::test
