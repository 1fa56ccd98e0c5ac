/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * How tightly hulls fit, over the cuts of a merge tree.
 */

#pragma once

#include "abstract_settings.h"
#include "run/run.h"

#include <pcl_cid/cid_convex_abstraction.h>
#include <pcl_cid/core/hull_tightness.h>

#include <iosfwd>
#include <vector>

namespace pcl_cid::tools {

using Abstraction = CIDConvexAbstraction<pcl::PointXYZ>;

/** \brief How tightly hulls fit, for the report.
 *  \return what has measured it */
TightnessMeter
measureTightness(const AbstractSettings& settings,
                 const PreparedScan::ConstPtr& scan,
                 const std::vector<ConvexPart>& parts,
                 Run& run);

/** \brief One cut of the merge tree. */
struct CurvePoint {
  std::size_t parts;
  double height; ///< of the last merge, metres; 0 when there is none
  std::size_t vertices;
  Tightness tightness;
};

/** \brief Some cuts from all groups to one part, each with about a sixth fewer parts
 *  than the one before.
 *  \param[in] simplified whether the hulls shall have as few vertices as may be
 *  \param[in,out] abstraction its last tree is whole */
std::vector<CurvePoint>
tightnessCurve(const TightnessMeter& meter, bool simplified, Abstraction& abstraction);

/** \brief As CSV: parts,height,vertices,max_concavity,mean_concavity,free_share,
 *  free_volume,volume. */
void
writeCurve(std::ostream& stream, const std::vector<CurvePoint>& curve);

} // namespace pcl_cid::tools
