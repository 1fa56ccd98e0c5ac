/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The options for raw scans: density, isolated points, seeding, colour.
 */

#pragma once

#include "command_line.h"

#include <pcl_cid/cid_parameters.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/io/labelled_cloud.h>
#include <pcl_cid/io/report.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

class Console;

/** \brief These settings as the command line has them. */
struct RawScanOptions {
  std::size_t density = 0; ///< as in DensityWeight
  float density_power = setting::density_power.initial;
  int isolated_neighbors = setting::isolated_neighbors.initial;
  std::size_t seeding = 0; ///< as in SeedingRule
  float color = setting::color.initial;
  std::size_t blind_spot = 0; ///< 0: filled
};

/** \brief Declare the options. */
void
declareRawScanOptions(RawScanOptions& options, CommandLine& command_line);

/** \brief Their names: what works without these settings refuses them. */
std::vector<std::string>
rawScanOptionNames();

/** \brief Hand the settings on to a class of the library.
 *  \throws CIDException when colours are wanted that the cloud does not have */
void
configureForRawScan(const RawScanOptions& options,
                    const LabelledCloud& cloud,
                    CIDParameters& parameters);

/** \brief The settings as they were used, for the report. */
std::vector<Report::Parameter>
parametersOf(const RawScanOptions& options);

/** \brief Tell the user and the report what was decided about the density. */
void
describeDensity(const DensityDecision& decision,
                const Console& console,
                Report& report);

/** \brief Tell the user and the report about a blind spot, if there is one.
 *  \param[in] offset of the points to the frame of the file */
void
describeBlindSpot(const std::optional<FilledBlindSpot>& spot,
                  const Eigen::Vector3d& offset,
                  const Console& console,
                  Report& report);

} // namespace pcl_cid::tools
