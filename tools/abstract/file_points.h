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
#include <pcl_cid/core/extreme_points.h>

#include <functional>
#include <vector>

namespace pcl_cid::tools {

/** \brief What float may take from a point unnoticed, metres. */
constexpr double unnoticed_rounding = 5e-5;

/** \brief Some points of a part, as they stand in the file. */
struct PartPoints {
  std::size_t part;
  pcl::Indices indices;                ///< in the file
  std::vector<Eigen::Vector3d> points; ///< metres, finite
};

/** \brief Shows all points of all parts, those of a part in one piece or in several. */
using ShowParts =
    std::function<void(const std::function<void(const PartPoints&)>& take)>;

/** \brief Shows the points of parts of a cloud that is in memory, part by part. Both
 * must live as long. */
ShowParts
pointsOfParts(const LabelledCloud& cloud, const std::vector<ConvexPart>& parts);

/** \brief How far, at most, points of the file are from where they are worked on,
 *  metres. Next to nothing about the local origin; a lot for a point that lies astray.
 */
double
roundingOf(const std::vector<Eigen::Vector3d>& points, const Frame& frame);

/** \brief Make a hull again, padded, where its points have lost more than what may go
 *  unnoticed, or where it is so large that it may miss them by as much: it contains the
 *  points of the file then, to within that.
 *  \param[in,out] abstracted its parts, in the local frame of the scan */
void
coverFilePoints(const LoadedScan& scan, AbstractedScan& abstracted);

/** \brief Make all hulls again, of other points than those that parts were made of, and
 *  as coverFilePoints() has them.
 *  \param[in] extremes of the points of each part, as they stand in the file, in the
 *  local frame of the scan
 *  \param[in,out] abstracted its parts, in that frame; they keep their indices */
void
coverExtremes(const ExtremePoints& extremes, AbstractedScan& abstracted);

} // namespace pcl_cid::tools
