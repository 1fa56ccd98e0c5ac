/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The input of a run that is read block by block, for scans larger than the memory.
 */

#pragma once

#include "command_line.h"
#include "loaded_scan.h"

#include <pcl_cid/io/cloud_blocks.h>
#include <pcl_cid/io/voxel_cloud.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief Declare `--voxel`.
 *  \param[in] whole_cloud options that need all points in memory, and are refused
 *  beside it */
void
declareVoxelOption(std::optional<double>& voxel,
                   const std::vector<std::string>& whole_cloud,
                   CommandLine& line);

/** \brief Refuse standard streams beside `--voxel`.
 *  \throws UsageError */
void
checkVoxelOption(const Settings& settings);

/** \brief Counts how many points of the file are in each group, where those of voxels
 *  were grouped. */
class FollowedGroups {
public:
  /** \param[in] group of each point of a voxel, -1 for none
   *  \param[in,out] report its groups are there; their sizes begin at 0 */
  FollowedGroups(const std::vector<pcl::index_t>& group, Report& report);

  /** \param[in] follows see VoxelScan::follow() */
  void
  take(const pcl::Indices& follows);

private:
  const std::vector<pcl::index_t>& group_;
  Report& report_;
};

/** \brief A scan of which one point of each voxel is held. */
class VoxelScan {
public:
  /** \brief Read the input twice, with messages, as loadScan().
   *  \param[in] output a cloud that writeLabels() will write; empty: none
   *  \param[in] check as VoxelOptions::check
   *  \throws CIDException when the output cannot hold the cloud, or cannot be written
   *  block by block, too */
  VoxelScan(const Settings& settings,
            const std::string& output,
            const decltype(VoxelOptions::check)& check,
            Run& run);

  /** \brief The points of the voxels. */
  const LoadedScan&
  scan() const
  {
    return scan_;
  }

  /** \brief Points of the file that are finite and not left out. */
  std::size_t
  finite() const
  {
    return voxels_->finite();
  }

  /** \brief Read the input once more.
   *  \param[in] take told of each block which point of scan() each of its points
   * follows
   */
  void
  follow(const Settings& settings, const VoxelCloud::Take& take, Run& run);

  /** \brief What else is done with the points of the file: which point of scan() each
   *  follows, -1 for none, and its label. */
  using Take = std::function<void(const LabelledCloud& block,
                                  const pcl::Indices& follows,
                                  const std::vector<std::uint32_t>& labels)>;

  /** \brief Read the input once more, and write it with labels.
   *  \param[in] labels of the points of scan() */
  void
  writeLabels(const Settings& settings,
              const std::vector<std::uint32_t>& labels,
              const Take& take,
              Run& run);

  /** \brief What the report says about the points of the file. */
  void
  describe(const Settings& settings, Report& report) const;

private:
  /** \brief The head of the output, whose sensor stands where a block of it says. */
  LabelledCloud
  headFor(const LabelledCloud& block) const;

  CloudBlockReader reader_;
  std::string output_;
  CloudLayout layout_; ///< of the output
  std::optional<VoxelCloud> voxels_;
  LoadedScan scan_;
};

} // namespace pcl_cid::tools
