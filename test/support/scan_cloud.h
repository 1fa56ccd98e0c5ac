/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A simulated scan as a cloud of PCL, with its truth in fields.
 */

#pragma once

#include <pcl/PCLPointCloud2.h>

#include "labelled_scan.h"

namespace pcl_cid::test {

/** \brief The points in their order: float x y z, uint32 label (the instance) and
 *  semantic (the class, an index into the names of the scan) and, where the scan has
 *  colors, rgb as PCL packs it into a float; no padding. */
pcl::PCLPointCloud2
cloudOf(const LabelledScan& scan);

} // namespace pcl_cid::test
