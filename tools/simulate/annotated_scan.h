/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A scan, and what a simulated annotator makes of it.
 */

#pragma once

#include "run/run.h"
#include "scored_scan.h"
#include "simulate_settings.h"

#include <pcl_cid/core/annotation.h>

#include <vector>

namespace pcl_cid::tools {

/** \brief A scan, and what a simulated annotator makes of it. */
struct AnnotatedScan : ScoredScan {
  /** At each number of clicks; with AnnotationProtocol::agile3d, after each round. */
  std::vector<AnnotationState> states;
};

/** \brief Load a scan, prepare it and let it be annotated, with messages.
 *  \param[in] settings `input` is the scan
 *  \throws CIDException when it has no true labels, or cannot be worked on */
AnnotatedScan
annotateScan(const SimulateSettings& settings, Run& run);

} // namespace pcl_cid::tools
