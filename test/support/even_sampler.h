/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Points drawn evenly from all surfaces of a test room, seen by a sensor or not.
 */

#pragma once

#include <cstddef>
#include <cstdint>

#include "labelled_scan.h"
#include "room_scene.h"

namespace pcl_cid::test {

/** \brief Draws points independently and uniformly by area from every surface of
 *  \a scene that faces air, whether a sensor could see it or not. Surfaces on which
 *  something stands or hangs get none there.
 *  \param[in] scene the room
 *  \param[in] count number of points
 *  \param[in] seed of the draws
 *  \return exactly \a count points; the same on every machine
 *  \note Cost: about a microsecond a point. */
LabelledScan
sampleRoomEvenly(const RoomScene& scene, std::size_t count, std::uint64_t seed);

} // namespace pcl_cid::test
