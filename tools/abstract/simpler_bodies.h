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
#include "run/run.h"

#include <pcl_cid/cid_convex_abstraction.h>
#include <pcl_cid/core/frame.h>
#include <pcl_cid/core/hull_primitive.h>

#include <optional>
#include <vector>

namespace pcl_cid::tools {

using Abstraction = CIDConvexAbstraction<pcl::PointXYZ>;

/** Where scanners stood. */
using Viewpoints = std::vector<Eigen::Vector3d>;

/** What stands for each part; empty when primitives are not asked for. */
using Primitives = std::vector<std::optional<HullPrimitive>>;

/** \brief What stands for hulls in scenes, within the bound, when asked for. */
Primitives
findPrimitives(const AbstractSettings& settings,
               const Viewpoints& viewpoints,
               const std::vector<ConvexPart>& parts,
               Abstraction& abstraction,
               Run& run);

/** \brief As few vertices as the error allows, when asked for. */
void
simplify(const AbstractSettings& settings,
         std::vector<ConvexPart>& parts,
         Abstraction& abstraction,
         Run& run);

/** \brief From the frame that is worked in to that of the file. */
void
moveToFile(const Frame& frame, Primitives& primitives);

} // namespace pcl_cid::tools
