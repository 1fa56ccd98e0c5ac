/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan as parts and hulls, before it is written.
 */

#pragma once

#include <pcl_cid/core/convex_part.h>
#include <pcl_cid/core/group_merging.h>
#include <pcl_cid/core/hull_primitive.h>
#include <pcl_cid/io/report.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_cid::tools {

/** Where scanners stood. */
using Viewpoints = std::vector<Eigen::Vector3d>;

/** What stands for each part; empty when primitives are not asked for. */
using Primitives = std::vector<std::optional<HullPrimitive>>;

/** \brief What became of a scan. */
struct AbstractedScan {
  std::vector<ConvexPart> parts;
  /** Parts whose hulls have all their vertices and hold all their points; empty: none
   *  is such. */
  std::vector<bool> is_exact;
  ConvexPartOptions hull_options; ///< of the other parts
  Primitives primitives;          ///< in the place of parts in scenes
  MergeTree tree;
  /** Of each part, where it was made of points of voxels; empty: of all points. */
  std::vector<FollowedPart> followed;
  std::size_t dropped_points = 0;

  bool
  isExact(std::size_t part) const
  {
    return !is_exact.empty() && is_exact[part];
  }

  ConvexPartOptions
  optionsOf(std::size_t part) const
  {
    ConvexPartOptions options = hull_options;
    if (isExact(part)) {
      options.max_vertices = 0;
      options.trim_distance = 0.0;
    }
    return options;
  }
};

} // namespace pcl_cid::tools
