/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What its labels cost a point near a boundary.
 */

#pragma once

#include "base/parallel_for.h"
#include "boundary_points.h"
#include "label_energy.h"

#include <pcl_cid/core/grouping.h>

#include <cstdint>
#include <vector>

namespace pcl_cid {

/** \brief What each label of each point costs more than the best one: the smallest cost
 *  of the point and a seed with the label, less the smallest of all, at most \a
 *  most_loss.
 *  \param[in] group the number of the seed of each point that is worked on
 *  \param[in] most_loss metres, above 0
 *  \return of each of \a boundary, in the order of its labels
 *  \throws CIDCancelled
 *  \note Cost: one CID for each of the points and each seed of its labels, most of them
 *  given up early. */
std::vector<std::vector<LabelEnergy::Choice>>
labelCosts(const Grouping& grouping,
           const std::vector<std::uint32_t>& label_of_seed,
           const std::vector<pcl::index_t>& group,
           const std::vector<BoundaryPoint>& boundary,
           float most_loss,
           int threads,
           Progress& progress,
           ProgressSpan span);

} // namespace pcl_cid
