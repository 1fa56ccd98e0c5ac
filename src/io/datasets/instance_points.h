/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The points of each instance, as the writers of datasets go through them.
 */

#pragma once

#include <pcl_cid/io/labelled_instances.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl_cid {

/** \brief An instance and its points. */
struct InstancePoints {
  NamedInstance instance;
  /** At least one, in the order of the cloud. */
  std::vector<std::size_t> points;
};

/** \brief The instances that have points, by label, ascending.
 *  \param[in] scan passes requireConsistent()
 *  \param[in] counts whether a point is taken, by its index */
std::vector<InstancePoints>
pointsOfInstances(
    const LabelledInstances& scan,
    const std::function<bool(std::size_t)>& counts = [](std::size_t) { return true; });

} // namespace pcl_cid
