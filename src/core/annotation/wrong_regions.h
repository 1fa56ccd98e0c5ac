/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Where labels are wrong.
 */

#pragma once

#include "session/radius_graph.h"

#include <cstdint>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid {

using Labels = std::vector<std::uint32_t>;

/** \brief The points of each pair of a true and another label, by pair, ascending.
 *  Points whose true label is 0 are never wrong. */
std::vector<pcl::Indices>
wrongRegions(const Labels& truth, const Labels& labels);

/** \brief The largest connected set of points with the same true and the same other
 *  label, ascending; of equally large ones that with the lowest index; empty where
 *  nothing is wrong. */
pcl::Indices
largestConnectedWrongRegion(const RadiusGraph& graph,
                            const Labels& truth,
                            const Labels& labels);

/** \brief The points of the true instance that has most, ascending; of equally large
 *  ones that of the lowest label; empty where there is none. */
pcl::Indices
largestInstance(const Labels& truth);

} // namespace pcl_cid
