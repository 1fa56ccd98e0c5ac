/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pcl_cid_simulate is told: its settings and its command line.
 */

#pragma once

#include "run/common_settings.h"

#include <pcl_cid/io/output_files.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

constexpr const char* simulate_tool = "pcl_cid_simulate";

/** \brief Where the simulated annotator clicks. */
enum class AnnotationProtocol { proposals, corrective, doubt, agile3d };

/** \brief The row of `--protocol`; reports use its words, too. */
inline constexpr ChoiceSetting<AnnotationProtocol, 4> annotation_protocol_setting{
    "Clicks",
    "protocol",
    "NAME",
    AnnotationProtocol::proposals,
    {{{"proposals", AnnotationProtocol::proposals},
      {"corrective", AnnotationProtocol::corrective},
      {"doubt", AnnotationProtocol::doubt},
      {"agile3d", AnnotationProtocol::agile3d}}},
    "where the annotator clicks: on the proposed seeds (the paper), in the largest "
    "connected region that is wrong, in the largest area where labels are in doubt, "
    "or by the rules of AGILE3D on voxels of 5 cm, with 20 clicks for each instance; "
    "every instance is a target there, and nothing is "
    "background"};

/** \brief The row of `--proposals`. */
inline constexpr NumberSetting<int> proposals_setting{
    "Clicks",
    "proposals",
    "number of proposals",
    "P",
    "",
    0,
    0,
    setting::any_number,
    "with --protocol corrective or doubt: click on so many proposed seeds before the "
    "others"};

/** \brief Settings of pcl_cid_simulate; what is not asked for is empty. `input` is the
 *  scan that is worked on. */
struct SimulateSettings : Settings {
  std::vector<std::string> scans;
  AnnotationProtocol protocol = annotation_protocol_setting.initial;
  /** Numbers of clicks, ascending. */
  std::vector<std::size_t> clicks{10, 20, 30, 50, 100, 200, 300};
  std::optional<int> proposals;
  std::string truth_field = "label";
  std::string session; ///< to be done again, in the place of a simulated annotator
  bool clean_up = setting::clean_up.initial;
  std::string csv;

  /** \brief The same settings for one of the scans. */
  SimulateSettings
  withInput(const std::string& scan) const;
};

/** \brief Read the command line, or answer `--help` and `--version`.
 *  \return whether there is work to do
 *  \throws UsageError */
bool
readCommandLine(int argc, const char* const* argv, SimulateSettings& settings);

/** \brief All files that are read, which outputs must never be written over. */
std::vector<std::string>
inputsOf(const SimulateSettings& settings);

} // namespace pcl_cid::tools
