/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What a raw scan and the settings of its preparation must be.
 */

#pragma once

#include <pcl_cid/core/prepared_scan.h>

namespace pcl_cid {

/** \brief Refuse what cannot be prepared.
 *  \throws CIDException that names the value, and what is allowed */
void
requireUsable(const RawScan& scan, const PreparationSettings& settings);

} // namespace pcl_cid
