/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Colors for the furniture of a test room.
 */

#pragma once

#include <vector>

#include "material.h"
#include "room_scene.h"

namespace pcl_cid::test {

/** \brief Draws what each instance is made of, as its class suggests; the walls are of
 *  one color.
 *  \return a material for each primitive of \a scene */
std::vector<Material>
paintFurniture(const RoomScene& scene, RandomGenerator& generator);

} // namespace pcl_cid::test
