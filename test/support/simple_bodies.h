/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scene of simple bodies: most of its parts are primitives.
 */

#pragma once

#include "part_scenes.h"

#include <pcl_cid/core/hull_primitive.h>
#include <pcl_cid/io/scene_export.h>

#include <string>

namespace pcl_cid::test {

/** \brief Parts and what stands for them. */
struct SimpleBodies {
  PartScene content;
  SceneDescription description;

  /** \brief As a format of the table has it: "URDF". */
  std::string
  textIn(const std::string& format) const;
};

/** \brief A box, a ball, a thick rod and a rod with round ends, all askew, and a
 *  pyramid, which stays a mesh.
 *  \param[in] kinds that may stand for them
 *  \param[in] offset of their frame in that of the scene */
SimpleBodies
simpleBodies(const std::vector<HullPrimitive::Kind>& kinds,
             const Eigen::Vector3d& offset);

/** \brief Fails when what a parser has read is of another kind than it must be, or does
 *  not hold all points of the part. */
void
expectHolds(const HullPrimitive& read, const SimpleBodies& bodies, std::size_t part);

} // namespace pcl_cid::test
