/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What pcl_cid_studio is told: its settings and its command line.
 */

#pragma once

#include "abstract/abstract_settings.h"
#include "run/common_settings.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_cid::studio {

constexpr const char* studio_tool = "pcl_cid_studio";

/** \brief Settings of pcl_cid_studio; what is not asked for is empty. */
struct StudioSettings : tools::Settings {
  std::string session; ///< its file
  std::string import;  ///< a field of INPUT, or a table of seeds
  std::vector<std::string> classes;
  tools::AbstractSettings parts; ///< how hulls are made, and what else parts need
  std::string page;              ///< folder of it
  std::string up = "z";
  std::uint16_t port = 0;
  bool no_browser = false;
};

/** \brief Read the command line, or answer `--help` and `--version`.
 *  \return whether there is work to do
 *  \throws UsageError; CIDException when a file of classes cannot be read or names one
 *  twice */
bool
readCommandLine(int argc, const char* const* argv, StudioSettings& settings);

} // namespace pcl_cid::studio
