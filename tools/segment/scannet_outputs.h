/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pcl_cid_segment writes for the tools of ScanNet.
 */

#pragma once

#include "run/command_line.h"
#include "run/console.h"

#include <pcl_cid/core/named_instance.h>
#include <pcl_cid/io/output_files.h>

#include <cstdint>
#include <string>
#include <vector>

#include <pcl/types.h>

namespace pcl_cid::tools {

/** \brief What to write; what is not asked for is empty. */
struct ScannetSettings {
  std::string superpoints;
  std::string submission; ///< folder
};

void
declareScannetOptions(ScannetSettings& settings, CommandLine& line);

/** \brief Refuse what cannot be written.
 *  \param[in] labels_from the field that seeds get their labels from; may be empty
 *  \throws UsageError */
void
checkScannetOptions(const ScannetSettings& settings, const std::string& labels_from);

/** \brief Announce the outputs: before all others, which may be in their folder.
 *  \param[in] input the scan
 *  \throws CIDException when predictions are asked for and it is no scan of ScanNet */
void
announceScannetOutputs(const ScannetSettings& settings,
                       const std::string& input,
                       OutputFiles& outputs);

/** \brief A scan with what was found out about it, point by point. */
struct SegmentedScan {
  std::string name; ///< as scanName() says
  std::vector<std::uint32_t> labels;
  std::vector<NamedInstance> instances; ///< what is known of labels
  pcl::Indices group;                   ///< -1 for none
  pcl::Indices seeds;
  /** The labels and classes of INPUT; empty when nothing asks for them. */
  std::vector<std::uint32_t> true_labels;
  std::vector<std::uint32_t> true_classes;
};

/** \brief Write the outputs; masks that an earlier run left for this scan go with the
 *  commit. */
void
writeScannetOutputs(const ScannetSettings& settings,
                    const SegmentedScan& scan,
                    const Console& console,
                    OutputFiles& outputs);

} // namespace pcl_cid::tools
