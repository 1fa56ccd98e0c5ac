/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The purity of CID at any number of parts: what peers are compared with.
 */

#pragma once

#include "peer_method.h"

#include <cstddef>
#include <map>
#include <set>

namespace pcl_cid::benchmarks {

/** \brief For each number of parts the purity of CID with as many, at full resolution:
 *  below the number T of groups of the merge tree, that tree cut to that number, as in
 *  section V.B of the paper; from T on, that many seeds and their groups, not merged.
 *  \param[in] parts numbers of parts, each at least 1
 *  \return the mean over the random seeds of the settings */
std::map<std::size_t, double>
purityOfCID(const PeerScan& scan,
            const SeedSettings& settings,
            const std::set<std::size_t>& parts);

} // namespace pcl_cid::benchmarks
