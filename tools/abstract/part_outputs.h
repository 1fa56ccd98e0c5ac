/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Parts on their way into files: told of, written, read again, verified.
 */

#pragma once

#include "abstract_settings.h"
#include "abstracted_scan.h"
#include "file_points.h"
#include "run/loaded_scan.h"
#include "run/run.h"

namespace pcl_cid::tools {

/** \brief Refuse outputs that cannot hold a scan or its hulls, before the work.
 *  \throws CIDException */
void
requireOutputsCanHold(const AbstractSettings& settings,
                      const LoadedScan& scan,
                      Run& run);

/** \brief Write all that is asked for of the parts of a scan, tell the user and the
 *  report of them, verify where that is asked for, and put the outputs in place.
 *  \param[in] settings its outputs were announced (see announceOutputs())
 *  \param[in] viewpoints of the bound on the error
 *  \param[in] abstracted in the frame of the file
 *  \param[in] show the points of the parts, for `--verify`
 *  \throws CIDException when a guarantee does not hold, or writing fails; then nothing
 *  is there */
void
writeParts(const AbstractSettings& settings,
           const Viewpoints& viewpoints,
           const AbstractedScan& abstracted,
           const LoadedScan& scan,
           const ShowParts& show,
           Run& run);

} // namespace pcl_cid::tools
