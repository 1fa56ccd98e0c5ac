/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts of the points of voxels, and all points of the file, which follow these.
 */

#pragma once

#include "abstract_settings.h"
#include "abstracted_scan.h"
#include "file_points.h"
#include "run/run.h"
#include "run/voxel_scan.h"

#include <pcl/types.h>

#include <vector>

namespace pcl_cid::tools {

/** \brief Carries parts of the points of voxels over to all points of the file: each is
 *  in the part of the point that it follows, or trimmed or dropped with it. The file is
 *  read for that, never held. */
class VoxelParts {
public:
  /** All must live as long. */
  VoxelParts(const AbstractSettings& settings, VoxelScan& voxels, Run& run)
  : settings_(settings), voxels_(voxels), run_(run)
  {
  }

  /** \brief Read the file: make hulls that contain all points of their parts, count
   *  these, and write `--labels`.
   *  \param[in] group of each point of a voxel; empty: there are no groups
   *  \param[in,out] abstracted its parts, in the local frame; they keep their indices,
   *  which are those of points of voxels */
  void
  cover(const std::vector<pcl::index_t>& group, AbstractedScan& abstracted);

  /** \brief Reads the file each time it shows its points. cover() came before. */
  ShowParts
  show();

private:
  void
  findParts(const std::vector<ConvexPart>& parts);

  void
  count(const pcl::Indices& follows, AbstractedScan& abstracted) const;

  std::vector<int>
  partsOf(const pcl::Indices& follows) const;

  template <typename Take>
  void
  read(const Take& take);

  const AbstractSettings& settings_;
  VoxelScan& voxels_;
  Run& run_;
  std::vector<int> part_;       ///< of each point of a voxel, -1 for none
  std::vector<int> trimmed_of_; ///< the part that it was trimmed from, -1 for none
};

} // namespace pcl_cid::tools
