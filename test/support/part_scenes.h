/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex parts for the tests of files: a room, flat, thin and tiny parts, far away
 * ones.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>

#include <string>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid::test {

/** \brief Parts and what they were made from. */
struct PartScene {
  std::string name;
  /** The cloud, in the frame of the hulls; the parts' indices count these. */
  std::vector<Eigen::Vector3d> points;
  std::vector<ConvexPart> parts;
};

/** \brief Coordinates as of UTM: where float has steps of 0.25 m. */
Eigen::Vector3d
utmOffset();

/** \brief A part for each of several clouds.
 *  \param[in] offset of the clouds' frame in that of the scene */
PartScene
partsOf(const std::string& name,
        const std::vector<Points>& clouds,
        const Eigen::Vector3d& offset);

/** \brief A grid of points on a horizontal rectangle around (x, y). */
Points
plate(float x, float y, float z, float width, float depth);

/** \brief A flat floor, a flat table top above it, a line, a point, equal points, a
 *  tilted plate and a box: parts that are thickened, and one that is not. */
PartScene
thinParts(const Eigen::Vector3d& offset);

/** \brief A furnished room, decomposed by CIDConvexAbstraction. */
PartScene
roomParts();

/** \brief All of them, thin parts also far away. */
std::vector<PartScene>
partScenes();

} // namespace pcl_cid::test
