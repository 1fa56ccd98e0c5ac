/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * What the actions of a session brought, as a table for people, as JSON and as CSV.
 */

#pragma once

#include "replayed_session.h"
#include "simulate_settings.h"

#include <iosfwd>
#include <string>

namespace pcl_cid::tools {

/** \brief What pcl_cid_simulate found about a session. */
struct SessionReport {
  SimulateSettings settings;
  ReplayedSession session;
};

/** \brief A row for each action, then one for all that are called the same, with 3
 *  digits. */
void
printTable(std::ostream& stream, const SessionReport& report);

/** \brief The same rows, and how they came about. */
std::string
toJson(const SessionReport& report);

/** \brief The rows of the actions. */
std::string
toCsv(const SessionReport& report);

} // namespace pcl_cid::tools
