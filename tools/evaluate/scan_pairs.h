/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which prediction belongs to which truth.
 */

#pragma once

#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief A prediction and the truth about the same scan. */
struct ScanPair {
  std::string name;
  std::string prediction;
  std::string truth;
};

/** \brief Two scans (see readScan()) are one pair. The scans of two folders are paired
 *  by scanName(), in the order of their names.
 *  \param[in] partial whether the truth may have scans without a prediction
 *  \throws CIDException when one of the two is missing, when only one is a folder of
 *  scans, when a folder has no scan or two of one name, or when a scan has no
 *  counterpart */
std::vector<ScanPair>
pairScans(const std::string& prediction, const std::string& truth, bool partial);

} // namespace pcl_cid::tools
