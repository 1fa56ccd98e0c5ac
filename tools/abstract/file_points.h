/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls and the points as they stand in the file: work is done in float, a file may
 * hold double.
 */

#pragma once

#include "abstracted_scan.h"
#include "run/loaded_scan.h"

#include <pcl_cid/core/convex_part.h>

#include <vector>

namespace pcl_cid::tools {

/** \brief What float may take from a point unnoticed, metres. */
constexpr double unnoticed_rounding = 5e-5;

/** \brief How far, at most, points are from where the file has them, metres. Next to
 *  nothing about the local origin; a lot for a point that lies astray. */
double
roundingOf(const pcl::Indices& indices,
           const CloudPoints& points,
           const FileCoordinates& coordinates);

/** \brief Make a hull again, padded, where its points have lost more than what may go
 *  unnoticed, or where it is so large that it may miss them by as much: it contains the
 *  points of the file then, to within that.
 *  \param[in,out] abstracted its parts, in the local frame of the scan */
void
coverFilePoints(const LoadedScan& scan, AbstractedScan& abstracted);

} // namespace pcl_cid::tools
