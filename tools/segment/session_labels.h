/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The labels of a session of pcl_cid_studio, without the studio.
 */

#pragma once

#include "run/scan_summary.h"

#include <string>

namespace pcl_cid::tools {

struct SegmentSettings;

/** \brief Do again what a session says, and write the labels that it leads to.
 *  \throws CIDException, Interrupted */
ScanFigures
writeSessionLabels(const std::string& tool, SegmentSettings settings);

} // namespace pcl_cid::tools
