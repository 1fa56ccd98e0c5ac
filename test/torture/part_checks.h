/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What must hold of parts and their hulls, whichever rule chose them.
 */

#pragma once

#include "torture_case.h"

#include <pcl_cid/core/convex_part.h>

#include <cstddef>
#include <vector>

namespace pcl_cid::test {

/** \brief To the bit. */
bool
sameParts(const std::vector<ConvexPart>& a, const std::vector<ConvexPart>& b);

/** \brief Hulls keep their guarantees, and each point is in exactly one part.
 *  \param[in] hull what the hulls were made with
 *  \param[in] parted points that are in a part or were dropped with it
 *  \param[in] dropped how many were dropped
 *  \throws Fault */
void
checkParts(const TortureCloud& cloud,
           const std::vector<ConvexPart>& parts,
           const ConvexPartOptions& hull,
           std::size_t parted,
           std::size_t dropped);

} // namespace pcl_cid::test
