/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pages have exported, and under what names.
 */

#pragma once

#include <string>
#include <vector>

namespace pcl_cid::studio {

/** \brief What was written. */
struct ExportedFiles {
  /** Files, or the folder of those that are one. */
  std::vector<std::string> files;
  /** A sentence for each thing that the format cannot say. */
  std::vector<std::string> remarks;
};

/** \throws CIDException when a name is not that of a file, without folders */
void
requireFileName(const std::string& name);

} // namespace pcl_cid::studio
