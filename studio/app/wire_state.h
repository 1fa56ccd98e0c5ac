/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A session as pages see it.
 */

#pragma once

#include "places.h"
#include "server/frame.h"

#include <pcl_cid/core/label_session.h>
#include <pcl_cid/core/part_session.h>

namespace pcl_cid::studio {

/** \brief Seeds, instances and counts, without arrays. */
nlohmann::json
summaryOf(const LabelSession& session, const Places& places);

/** \brief The arrays of all places: `labels`, `groups`. */
std::vector<NamedArray>
allLabels(const LabelSession& session, const Places& places);

/** \brief The arrays of those that have changed: `places`, `labels`, `groups`. */
std::vector<NamedArray>
changedLabels(const LabelSession& session,
              const pcl::Indices& changed,
              const Places& places);

/** \brief The points of the group of a seed. */
pcl::Indices
groupOf(const LabelSession& session, pcl::index_t seed);

/** \brief The parts, as `"parts"` of the protocol.
 *  \param[in] decomposition number of the decomposition */
nlohmann::json
partsOf(const PartSession& parts, std::size_t decomposition);

/** \brief The group of each place, as the array `part_groups`; empty before there are
 *  any. */
std::vector<NamedArray>
partGroups(const PartSession& parts, const Places& places);

} // namespace pcl_cid::studio
