/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Which prediction belongs to which truth.
 */

#pragma once

#include <pcl_cid/io/labelled_cloud.h>

#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief A prediction and the truth about the same scan. */
struct ScanPair {
  std::string name;
  std::string prediction;
  std::string truth;
};

/** \brief Read a scan, whatever it is kept in. */
LabelledCloud
readAnyScan(const std::string& path);

/** \brief Two scans are one pair; the scans of two folders are paired by name without
 *  extension, in the order of their names.
 *  \param[in] partial whether the truth may have scans without a prediction
 *  \throws CIDException when one of the two is missing, when only one is a folder of
 *  scans, when a folder has no scan or two of one name, or when a scan has no
 *  counterpart */
std::vector<ScanPair>
pairScans(const std::string& prediction, const std::string& truth, bool partial);

} // namespace pcl_cid::tools
