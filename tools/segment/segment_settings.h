/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pcl_cid_segment is told: its settings and its command line.
 */

#pragma once

#include "run/common_settings.h"
#include "scannet_outputs.h"

#include <pcl_cid/io/output_files.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

constexpr const char* segment_tool = "pcl_cid_segment";

/** \brief Settings of pcl_cid_segment; what is not asked for is empty. */
struct SegmentSettings : Settings {
  std::string labels;
  std::string labels_from;
  std::string propose;
  std::string session;
  bool clean_up = setting::clean_up.initial;
  ScannetSettings scannet;
  std::optional<int> cid_from;
};

/** \brief Read the command line, or answer `--help` and `--version`.
 *  \return whether there is work to do
 *  \throws UsageError */
bool
readCommandLine(int argc, const char* const* argv, SegmentSettings& settings);

/** \brief The options that name files of each scan, of several. */
std::vector<NameOption>
nameOptions(SegmentSettings& settings);

/** \brief All files that are read, which outputs must never be written over. */
std::vector<std::string>
inputsOf(const SegmentSettings& settings);

/** \brief Announce all that will be written.
 *  \throws CIDException when something cannot be written, or would be lost */
void
announceOutputs(const SegmentSettings& settings, OutputFiles& outputs);

/** \brief Where seeds get their labels from, and what becomes of labels, for the
 *  report. */
std::vector<Report::Parameter>
labelParametersOf(const SegmentSettings& settings);

} // namespace pcl_cid::tools
