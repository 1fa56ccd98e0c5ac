/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One point of each voxel of a scan that need not fit into memory, and which of them
 * every other point follows.
 */

#pragma once

#include <pcl_cid/core/settings.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <memory>
#include <vector>

#include <pcl/types.h>

#include <Eigen/Core>

namespace pcl_cid {

namespace setting {

/** \brief The row of the size of voxels, of what reads scans block by block. */
inline constexpr NumberSetting<double> voxel{
    "Run",
    "voxel",
    "size of a voxel",
    "SIZE",
    "metres",
    0.0,
    shortest,
    longest,
    "work on one point of each voxel of this size",
    "for all points"};

} // namespace setting

/** \brief One point of each voxel that holds points of a scan.
 *
 *  A voxel is a cube of space: all points whose coordinates, divided by its size and
 *  rounded down, are the same, like those of pcl::VoxelGrid, which divides in float.
 *  Its point is the one nearest to the mean of all points in it, the first of them at
 *  equal distance (but for rounding): a point of the scan, where VoxelGrid makes one
 *  up. Every point of the scan follows the nearest of these points, which need not be
 *  that of its own voxel; at equal distance the one that comes first in the scan.
 *
 *  The scan is shown three times, block by block, each time whole and in the same
 *  order; the blocks may differ. What is held depends on the number of voxels alone:
 *  up to about 130 bytes for each until finish() returns, 60 from then on.
 *
 *  \code
 *    pcl_cid::VoxelPoints voxels(0.02);
 *    for (const auto& block : blocks)
 *      voxels.add(block);
 *    for (const auto& block : blocks)
 *      voxels.choose(block);
 *    voxels.finish();
 *    const pcl::Indices& chosen = voxels.source();
 *    for (const auto& block : blocks)
 *      const pcl::Indices follows = voxels.follow(block); // positions in `chosen`
 *  \endcode
 *
 *  Points that are not finite are in no voxel and follow none. Coordinates may be UTM
 *  ones: all is computed in double, relative to the voxel. The result depends on the
 *  points and their order, never on blocks or threads. One thread at a time may change
 *  it, any number may call follow(). */
class PCL_CID_EXPORT VoxelPoints {
public:
  /** \brief Coordinates of consecutive points of the scan. */
  using Block = std::vector<Eigen::Vector3d>;

  /** \param[in] size of a voxel along each axis, in the unit of the coordinates
   *  \param[in] threads as setting::threads
   *  \throws CIDException when the size is out of its range, setting::voxel */
  explicit VoxelPoints(double size, unsigned int threads = setting::threads.initial);
  ~VoxelPoints();
  VoxelPoints(VoxelPoints&& other) noexcept;
  VoxelPoints&
  operator=(VoxelPoints&& other) noexcept;

  /** \brief The first time: find the voxels and their means.
   *  \throws CIDException after choose(), and for a point that is 2^30 voxels or more
   * from the first one, or whose coordinates do not tell voxels apart */
  void
  add(const Block& points);

  /** \brief The second time: choose.
   *  \return for each point the number of its voxel, from 0, when it is the best of it
   *  so far, or else -1
   *  \throws CIDException for a point of a voxel that had none, for more than 2^31 - 1
   *  points in all, and after finish() */
  pcl::Indices
  choose(const Block& points);

  /** \brief Put the chosen points into the order of the scan, for follow().
   *  \return for each of them the number that choose() had for its voxel
   *  \throws CIDException when a voxel has no chosen point */
  pcl::Indices
  finish();

  /** \brief Voxels that hold points. */
  std::size_t
  size() const;

  /** \brief After finish(): indices in the scan of the chosen points, ascending. */
  const pcl::Indices&
  source() const;

  /** \brief After finish(), the third time: for each point the position in source() of
   *  the chosen point that it follows, -1 when it is not finite.
   *  \throws CIDException when a point was not shown before */
  pcl::Indices
  follow(const Block& points) const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl_cid
