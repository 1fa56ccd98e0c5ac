/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The settings of a session and those of a tool.
 */

#pragma once

#include "command_line.h"
#include "common_settings.h"
#include "loaded_scan.h"

#include <pcl_cid/core/label_session.h>
#include <pcl_cid/io/report.h>
#include <pcl_cid/io/session_file.h>

#include <string>
#include <vector>

namespace pcl_cid::tools {

/** \brief Declare `--session`, beside which no option can be given whose setting is the
 *  session's.
 *  \param[in] help what the tool does with it */
void
declareSessionOption(std::string& session, const std::string& help, CommandLine& line);

/** \brief What a new session has from the command line. */
SessionSettings
sessionSettingsOf(const Settings& settings);

/** \brief Let a session that is there decide: labels depend on its settings. */
void
useSettingsOf(const SessionSettings& session, Settings& settings);

/** \brief The settings with which a session was done again, for the report. */
std::vector<Report::Parameter>
sessionParametersOf(const std::string& session, const Settings& settings);

/** \brief A session in which nothing was done, on the points of a scan.
 *  \throws CIDException, CIDCancelled as the preparation does */
LabelSession
prepareSession(const Settings& settings,
               const LoadedScan& scan,
               const ExecutionOptions& execution);

} // namespace pcl_cid::tools
