/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What --voxel does, by hand: the chosen points as a cloud, and whom others follow.
 */

#pragma once

#include "cloud_files.h"

#include <pcl_cid/io/cloud_blocks.h>
#include <pcl_cid/io/cloud_formats.h>
#include <pcl_cid/io/voxel_cloud.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pcl_cid::test {

/** \brief Write the points of the voxels of a scan as a cloud of their own.
 *  \return their indices in the scan */
inline pcl::Indices
chooseFrom(const std::string& scan, double size, const std::string& chosen)
{
  CloudBlockReader reader(scan);
  VoxelOptions options;
  options.size = size;
  const VoxelCloud voxels(reader, options);
  saveCloud(chosen, voxels.cloud(), pcd_binary);
  return voxels.source();
}

/** \brief For each point of a scan the label of the nearest of those that were chosen.
 *  \param[in] source indices of the chosen ones
 *  \param[in] of_chosen their labels
 *  \param[in,out] labels what they are; those of every so many points are looked for */
inline void
findByBruteForce(const std::string& scan,
                 const pcl::Indices& source,
                 const std::vector<std::uint32_t>& of_chosen,
                 std::size_t stride,
                 std::vector<std::uint32_t>& labels)
{
  const LabelledCloud cloud = readCloud(scan);
  const CloudPoints points = pointsOf(cloud);
  const FileCoordinates at(cloud);
  std::vector<Eigen::Vector3d> chosen;
  for (const pcl::index_t i : source)
    chosen.push_back(at[static_cast<std::size_t>(i)]);
  for (std::size_t i = 0; i < cloud.size(); i += stride) {
    labels[i] = 0;
    if (!(*points.points)[i].getVector3fMap().allFinite())
      continue;
    double least = std::numeric_limits<double>::infinity();
    const Eigen::Vector3d p = at[i];
    for (std::size_t k = 0; k < chosen.size(); ++k)
      if (const double squared = (p - chosen[k]).squaredNorm(); squared < least) {
        least = squared;
        labels[i] = of_chosen[k];
      }
  }
}

} // namespace pcl_cid::test
