/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What must hold of parts that are chosen by their hulls.
 */

#pragma once

#include "torture_case.h"

#include <pcl_cid/core/prepared_scan.h>

namespace pcl_cid::test {

/** \brief Merge by hull, on one thread and on several, and check all that is promised.
 *  \param[in] scan of the case, which is one that merging by CID takes
 *  \throws Fault */
void
checkFitting(const TortureCase& one, const PreparedScan& scan);

} // namespace pcl_cid::test
