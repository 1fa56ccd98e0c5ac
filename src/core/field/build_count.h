/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How often a field was built: tests prove with it that no scan is prepared twice.
 */

#pragma once

#include <pcl_cid/pcl_cid_export.h>

#include <cstddef>

namespace pcl_cid {

/** \brief The DistanceFields that this process has built so far. */
PCL_CID_EXPORT std::size_t
fieldsBuilt();

} // namespace pcl_cid
