/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Smooth patches of the surface: groups without seeds.
 */

#pragma once

#include <pcl_cid/core/execution.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>
#include <memory>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief Smooth patches of the surface, by region growing: groups for Algorithm 2 in
 *  the place of those of seeds (*ours*).
 *
 *  Only what depends on the surface counts: seeds, costs of pairs and random draws do
 *  not (a subsample does). Every point that is worked on is in exactly one patch, and
 *  none is empty. Patches are numbered by their size before they are filled in, largest
 *  first. See doc/core/smooth_patches.md.
 *
 *  Immutable: const calls may run concurrently.
 *  \note Memory: 4 bytes a point, and the scan. */
class PCL_CID_EXPORT SmoothPatches {
public:
  using ConstPtr = std::shared_ptr<const SmoothPatches>;

  /** \brief Grow regions, keep the largest, and fill in the rest.
   *  \param[in] scan not null
   *  \param[in] max_patches K, at least 1; fewer come where the surface has no more
   *  regions
   *  \param[in] execution threads and progress; never change the result
   *  \throws CIDException when there is no scan, or K is 0; CIDCancelled
   *  \note Cost: O(N log N); regions grow and are filled in on one thread. */
  explicit SmoothPatches(PreparedScan::ConstPtr scan,
                         std::size_t max_patches = setting::seeds.initial,
                         const ExecutionOptions& execution = {});

  const PreparedScan&
  scan() const
  {
    return *scan_;
  }

  const PreparedScan::ConstPtr&
  sharedScan() const
  {
    return scan_;
  }

  std::size_t
  numberOfPatches() const
  {
    return grown_sizes_.size();
  }

  /** \brief The points that each patch grew over, without those that were filled in, by
   *  its number: never more than the one before has. */
  const std::vector<std::size_t>&
  grownSizes() const
  {
    return grown_sizes_;
  }

  /** \brief The number of the patch of each point of the cloud, -1 for a point that is
   *  not finite or not selected. */
  std::vector<pcl::index_t>
  groups() const;

  /** \brief The same for each point that is worked on (see PreparedScan::working()). */
  const std::vector<pcl::index_t>&
  groupsOfWorkingPoints() const
  {
    return patches_;
  }

private:
  PreparedScan::ConstPtr scan_;
  std::vector<pcl::index_t> patches_;
  std::vector<std::size_t> grown_sizes_;
};

} // namespace pcl_cid
