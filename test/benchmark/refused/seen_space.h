/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which space the sensors of a scan have seen to be free.
 */

#pragma once

#include "voxel_grid.h"

#include <pcl_cid/core/point_set.h>

#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace pcl_cid::benchmarks {

/** \brief How the sight of sensors is followed. */
struct SightOptions {
  /** Edge of a voxel, metres, above 0. */
  double voxel = 0.05;
  /** A sensor sees up and down to this sine of the elevation, 0 to 1; none for all
   *  directions. */
  std::optional<double> max_elevation_sine;
  /** Threads; 0 for each processor. They never change a result. */
  unsigned threads = 0;
};

/** \brief Whether a viewpoint sees each of the points of a scan.
 *
 *  Who of several sensors has measured a point is not known. So a viewpoint sees a
 *  point when its range is at most 1.05 times the smallest in the same cell of
 *  directions, 1 degree of azimuth and elevation wide, and 0.05 m. A viewpoint that is
 *  the only one sees all points. */
std::vector<char>
seenFrom(const Eigen::Vector3d& viewpoint,
         const Points& scan,
         bool is_only,
         const SightOptions& options);

/** \brief The bounding box of a scan in voxels, each free or not.
 *
 *  A voxel is free when no point lies in it and the ray from a viewpoint to a point
 *  that it sees crosses it more than a voxel before that point. Without viewpoints
 *  every voxel without a point is free. */
class SeenSpace {
public:
  /** \param[in] scan at least 1 point, metres
   *  \param[in] viewpoints in the frame of the scan
   *  \param[in] options see SightOptions
   *  \throws CIDException when there would be more than 2^31 voxels */
  SeenSpace(const Points& scan,
            const std::vector<Eigen::Vector3d>& viewpoints,
            const SightOptions& options);

  /** \brief Whether a place is in a free voxel; outside of the box, nothing is. */
  bool
  isFree(const Eigen::Vector3d& x) const
  {
    return grid_.contains(x) && isFree(grid_.indexOf(x));
  }

  bool
  isFree(std::size_t voxel) const
  {
    return is_free_[voxel].load(std::memory_order_relaxed);
  }

  /** \brief Number of voxels. */
  std::size_t
  size() const
  {
    return is_free_.size();
  }

  const VoxelGrid&
  grid() const
  {
    return grid_;
  }

  /** \brief Box of the points. */
  const Eigen::AlignedBox3d&
  box() const
  {
    return box_;
  }

  /** \brief Volume of the free voxels, cubic metres. */
  double
  freeVolume() const;

private:
  void
  look(const Eigen::Vector3d& viewpoint,
       const Points& scan,
       bool is_only,
       const SightOptions& options);

  Eigen::AlignedBox3d box_;
  VoxelGrid grid_;
  /** Rays of several threads may cross one voxel; they all write the same. */
  std::vector<std::atomic<bool>> is_free_;
};

} // namespace pcl_cid::benchmarks
