/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Algorithm 2 on points that are in groups, wherever the groups come from.
 */

#pragma once

#include "cid/working_points.h"

#include <pcl_cid/core/group_merging.h>

#include <cstdint>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

/** \brief All that Algorithm 2 depends on, except for the points. */
struct GroupMergingOptions : MergingSettings {
  int samples = setting::samples.initial;                   ///< M
  std::uint64_t random_seed = setting::random_seed.initial; ///< of the draw
  ExecutionOptions execution;
};

/** \brief See mergeGroups() of a Grouping.
 *  \param[in] group number of the group of each point, 0 to groups - 1; -1 for none
 *  \param[in] groups K; every group has at least 1 point */
MergeTree
mergeGroups(const WorkingPoints& points,
            const std::vector<pcl::index_t>& group,
            std::size_t groups,
            const GroupMergingOptions& options);

} // namespace pcl_cid
