/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls that cost whoever uses them less: primitives, and hulls of fewer vertices.
 */

#pragma once

#include "abstract_settings.h"
#include "abstracted_scan.h"
#include "run/run.h"

#include <pcl_cid/core/frame.h>
#include <pcl_cid/core/prepared_scan.h>

namespace pcl_cid::tools {

/** \brief What stands for hulls in scenes, within the bound, when asked for. */
void
findPrimitives(const AbstractSettings& settings,
               const Viewpoints& viewpoints,
               const PreparedScan::ConstPtr& scan,
               Run& run,
               AbstractedScan& abstracted);

/** \brief As few vertices as the error allows, when asked for; exact hulls keep
 *  theirs. */
void
simplify(const AbstractSettings& settings,
         const Viewpoints& viewpoints,
         const PreparedScan::ConstPtr& scan,
         Run& run,
         AbstractedScan& abstracted);

/** \brief From the frame that is worked in to that of the file. */
void
moveToFile(const Frame& frame, AbstractedScan& abstracted);

} // namespace pcl_cid::tools
