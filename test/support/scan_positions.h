/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Where the sensor of a simulated scan stood, as JSON.
 */

#pragma once

#include <nlohmann/json.hpp>

#include "labelled_scan.h"

namespace pcl_cid::test {

/** \brief [[x, y, z], ...], in metres: what a truth file has as `sensor_positions`. */
inline nlohmann::ordered_json
positionsOf(const LabelledScan& scan)
{
  nlohmann::ordered_json positions = nlohmann::ordered_json::array();
  for (const Eigen::Vector3d& p : scan.sensor_positions)
    positions.push_back({p.x(), p.y(), p.z()});
  return positions;
}

} // namespace pcl_cid::test
