/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The options for raw scans: density, isolated points, seeding, cues, connected
 * groups, blind spot.
 */

#pragma once

#include "command_line.h"

#include <pcl_cid/cid_parameters.h>
#include <pcl_cid/core/frame.h>
#include <pcl_cid/core/prepared_scan.h>
#include <pcl_cid/core/settings.h>
#include <pcl_cid/io/labelled_cloud.h>
#include <pcl_cid/io/report.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_cid::tools {

struct Run;

/** \brief These settings as the command line has them. */
struct RawScanOptions {
  DensityWeight density = setting::density.initial;
  float density_power = setting::density_power.initial;
  int isolated_neighbors = setting::isolated_neighbors.initial;
  SeedingRule seeding = setting::seeding.initial;
  float color = setting::color.initial;
  float normals = setting::normals.initial;
  bool connected = setting::connected.initial;
  bool blind_spot = setting::blind_spot.initial;
};

/** \brief Declare the options. */
void
declareRawScanOptions(RawScanOptions& options, CommandLine& line);

/** \brief Their names: what works without these settings refuses them. */
std::vector<std::string>
rawScanOptionNames();

/** \brief Hand the settings on to a class of the library.
 *  \throws CIDException when colors are wanted that the cloud does not have */
void
configureForRawScan(const RawScanOptions& options,
                    const LabelledCloud& cloud,
                    CIDParameters& parameters);

/** \brief The settings as they were used, for the report. */
std::vector<Report::Parameter>
parametersOf(const RawScanOptions& options);

/** \brief Tell the user and the report what was decided about the density. */
void
describeDensity(const DensityDecision& decision, Run& run);

/** \brief Tell the user and the report about a blind spot, if there is one.
 *  \param[in] frame of the points that were worked on */
void
describeBlindSpot(const std::optional<FilledBlindSpot>& spot,
                  const Frame& frame,
                  Run& run);

} // namespace pcl_cid::tools
