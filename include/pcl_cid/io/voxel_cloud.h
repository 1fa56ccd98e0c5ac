/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One point of each voxel of a file that need not fit into memory.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/voxel_points.h>
#include <pcl_cid/io/cloud_points.h>
#include <pcl_cid/pcl_cid_io_export.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

class CloudBlockReader;

/** \brief How the points of voxels are chosen. */
struct VoxelOptions {
  double size = setting::voxel.initial; ///< of a voxel, metres
  PointOptions points;                  ///< which points of the file count
  /** Called once with each block, before the work, and its coordinates, which are NaN
   *  where points are left out; may throw, may be empty. */
  std::function<void(const LabelledCloud& block, const VoxelPoints::Block& points)>
      check;
  ExecutionOptions execution;
};

/** \brief The points of a file that VoxelPoints chooses, with all their fields.
 *
 *  The file is read twice for that, and once more to carry results to all its points:
 *
 *  \code
 *    pcl_cid::CloudBlockReader reader("scan.pcd");
 *    pcl_cid::VoxelOptions options;
 *    options.size = 0.02;
 *    pcl_cid::VoxelCloud voxels(reader, options);
 *    ... // voxels.cloud() is a cloud like others: segment it
 *    voxels.follow(reader, [&](pcl_cid::LabelledCloud& block, const pcl::Indices&
 * follows) {
 *      ... // follows[i] is a point of voxels.cloud(), or -1
 *    });
 *  \endcode
 *
 *  Points that are left out (see PointOptions) or not finite are in no voxel. */
class PCL_CID_IO_EXPORT VoxelCloud {
public:
  /** \brief Choose the points.
   *  \param[in,out] reader is rewound; whichever blocks it gives
   *  \throws CIDException when the file cannot be read, has no finite point, or when a
   *  voxel is too small for it (see VoxelPoints::add()); CIDCancelled */
  VoxelCloud(CloudBlockReader& reader, const VoxelOptions& options);
  ~VoxelCloud();
  VoxelCloud(const VoxelCloud&) = delete;
  VoxelCloud&
  operator=(const VoxelCloud&) = delete;

  /** \brief The chosen points in the order of the file, in one row, with the file's
   *  fields, layout, scale and pose. */
  const LabelledCloud&
  cloud() const
  {
    return cloud_;
  }

  /** \brief Hand cloud() over; it is empty then. */
  LabelledCloud
  takeCloud()
  {
    return std::exchange(cloud_, {});
  }

  /** \brief Their indices in the file. */
  const pcl::Indices&
  source() const
  {
    return voxels_.source();
  }

  /** \brief Points of the file that are finite and not left out. */
  std::size_t
  finite() const
  {
    return finite_;
  }

  /** \brief Called with each block, and for each of its points the position in cloud()
   * of the chosen point that is nearest to it, -1 for those in no voxel. */
  using Take = std::function<void(LabelledCloud& block, const pcl::Indices& follows)>;

  /** \brief Read the file once more, and say which chosen point each point follows.
   *  \throws CIDException when the file has changed; CIDCancelled; what \a take throws
   */
  void
  follow(CloudBlockReader& reader,
         const Take& take,
         const ExecutionOptions& execution = {}) const;

private:
  void
  findVoxels(CloudBlockReader& reader, const VoxelOptions& options);

  void
  choosePoints(CloudBlockReader& reader, const VoxelOptions& options);

  VoxelPoints voxels_;
  LabelledCloud cloud_;
  std::vector<Eigen::Vector3d> left_out_; ///< places
  std::size_t finite_ = 0;
};

} // namespace pcl_cid
