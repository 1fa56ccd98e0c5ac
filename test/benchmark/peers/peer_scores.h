/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Purity, and how well the instances of a scan are found.
 */

#pragma once

#include "peer_scan.h"

#include <pcl_cid/core/evaluation.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid::benchmarks {

/** \brief Number of different labels, 0 not counted. */
std::size_t
countLabels(const std::vector<std::uint32_t>& labels);

/** \brief The purity of groups, from 1; 0 for none. See Evaluation::purity. */
double
purityOf(const std::vector<std::uint32_t>& group, const PeerScan& scan);

/** \brief Labels by an annotator who names the true instance that each seed lies on,
 *  carried to the points of its group.
 *  \param[in] group from 1, in the order of the seeds
 *  \param[in] instance true instance of each point */
std::vector<std::uint32_t>
labelsOfSeeds(const std::vector<std::uint32_t>& group,
              const pcl::Indices& seeds,
              const std::vector<std::uint32_t>& instance);

/** \brief Score labels of seeds by the protocol of the paper. */
Evaluation
scoreLabels(const std::vector<std::uint32_t>& labels, const PeerScan& scan);

} // namespace pcl_cid::benchmarks
