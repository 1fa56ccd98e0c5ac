/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex parts, and how they are asked for.
 */

#pragma once

#include "long_work.h"
#include "scan.h"
#include "settings.h"

#include <pcl_cid/core/convex_part.h>

#include <optional>
#include <vector>

namespace pcl_cid::python {

/** \brief The settings of parts and hulls. */
struct PartSettings {
  GroupRule groups = setting::groups.initial;
  std::optional<int> seeds; ///< the number of patches
  int group_samples = setting::group_samples.initial;
  double robot_radius = setting::robot_radius.initial;
  int min_points = setting::min_points.initial;
  ConvexPartOptions hulls;
};

/** \brief Call \a visit with the row and the value of each. */
template <typename Settings, typename Visitor>
void
forEachPartSetting(Settings& settings, Visitor&& visit)
{
  visit(setting::groups, settings.groups);
  visit(setting::seeds, settings.seeds);
  visit(setting::group_samples, settings.group_samples);
  visit(setting::robot_radius, settings.robot_radius);
  visit(setting::min_points, settings.min_points);
  visit(setting::min_thickness, settings.hulls.min_thickness);
  visit(setting::max_vertices, settings.hulls.max_vertices);
  visit(setting::padding, settings.hulls.padding);
  visit(setting::trim_distance, settings.hulls.trim_distance);
}

/** \brief What Scan.parts() is asked for. */
struct PartRequest {
  PartSettings settings;
  MergingRule rule = MergingRule::cid;
  MergeCut cut;
  std::optional<double> max_error;
  std::vector<Eigen::Vector3d> viewpoints; ///< in the coordinates of the prepared cloud
  /** As few vertices as the bound on the error allows. */
  bool fewest_vertices = false;
};

/** \brief Merge the groups of seeds, or patches: see CIDPartParameters::cutGroups() and
 *  cutPatches().
 *  \param[in] seeds the number of patches; none: the default */
std::vector<int>
mergeAndCut(const Scan& scan,
            const Seeding& seeding,
            GroupRule groups,
            const std::optional<int>& seeds,
            PartMaker& maker,
            const ExecutionOptions& execution);

/** \brief The parts of a scan, in the coordinates that were given. May run without the
 *  GIL.
 *  \throws CIDException, CIDCancelled */
std::vector<ConvexPart>
makeParts(const Scan& scan,
          const PartRequest& request,
          const ExecutionOptions& execution);

/** \brief ConvexPart and save(). */
void
bindParts(py::module_& module);

} // namespace pcl_cid::python
