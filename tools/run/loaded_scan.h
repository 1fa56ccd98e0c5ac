/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The input of a run: its cloud, and the coordinates that are worked on.
 */

#pragma once

#include "run.h"

#include <pcl_cid/io/cloud_points.h>
#include <pcl_cid/io/labelled_cloud.h>

#include <string>
#include <vector>

namespace pcl_cid::tools {

enum class OutputUnit;
struct Settings;

/** \brief A scan as it was read. */
struct LoadedScan {
  std::string name; ///< as scanName() says
  LabelledCloud cloud;
  CloudPoints points;
};

/** \brief The files of the input, which outputs must never be written over. */
std::vector<std::string>
inputFiles(const Settings& settings);

/** \brief Load the input, with messages; remarks on it go to the user and the report.
 *  \throws CIDException when it has no finite point */
LoadedScan
loadScan(const Settings& settings, Run& run);

/** \brief Say so when the scan is larger than buildings are: its unit may not be the
 *  metre. */
void
remarkOnUnit(const Settings& settings, const LoadedScan& scan, Run& run);

/** \brief Let what is written beside the scan have the unit of `--output-unit`. */
void
useOutputUnit(const Settings& settings, LoadedScan& scan);

/** \brief Refuse an output that cannot hold the cloud of a scan, before the work;
 *  remarks on it go to the user and the report.
 *  \throws CIDException */
void
requireOutputHolds(const std::string& path, const LoadedScan& scan, Run& run);

/** \brief Announce OUTPUT, a cloud: a file, or the standard output. */
void
announceCloud(const std::string& path, OutputFiles& outputs);

/** \brief Write a cloud in the format that the extension of a file says.
 *  \param[in] path was announced */
void
writeScan(const std::string& path,
          const LabelledCloud& cloud,
          OutputUnit unit,
          OutputFiles& outputs);

} // namespace pcl_cid::tools
