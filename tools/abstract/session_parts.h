/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The parts that were chosen in a session of pcl_cid_studio.
 */

#pragma once

#include "abstract_settings.h"
#include "abstracted_scan.h"
#include "run/loaded_scan.h"
#include "run/scan_summary.h"

#include <pcl_cid/core/part_session.h>

namespace pcl_cid::tools {

/** \brief Hulls of the parts that are not dropped, simpler ones or primitives where
 *  they are asked for, and what there is to say about them in the report.
 *  \return in the frame of the file
 *  \throws CIDException when there are no parts, or all are dropped */
AbstractedScan
abstractChosenParts(const AbstractSettings& settings,
                    const PartSession& session,
                    const LoadedScan& scan,
                    Run& run);

/** \brief All of pcl_cid_abstract for the parts that were chosen in a session.
 *  \throws CIDException, Interrupted */
ScanFigures
writeSessionParts(AbstractSettings settings);

} // namespace pcl_cid::tools
