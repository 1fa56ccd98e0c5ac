/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What clicks are worth, as a table for people, as JSON and as CSV.
 */

#pragma once

#include "annotated_scan.h"
#include "simulate_settings.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief What pcl_cid_simulate found. */
struct SimulationReport {
  SimulateSettings settings;
  std::vector<AnnotatedScan> scans;
};

/** \brief The rows of each scan, and of all scans together, with 3 digits. */
void
printTable(std::ostream& stream, const SimulationReport& report);

/** \brief The same rows, and how they came about. */
std::string
toJson(const SimulationReport& report);

/** \brief The same rows. */
std::string
toCsv(const SimulationReport& report);

} // namespace pcl_cid::tools
