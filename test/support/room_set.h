/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A sequence of furnished rooms that differ: size, kind and number of things in them.
 */

#pragma once

#include <cstddef>
#include <cstdint>

#include "labelled_scan.h"
#include "room_scene.h"

namespace pcl_cid::test {

/** \brief A room of 10 to 60 square metres with furniture to its size; what is in it,
 *  how it is turned, and whether it has windows, beams, columns, boards and pictures is
 *  drawn.
 *  \return the same for the same seed, on every machine
 *  \throw CIDException when no draw was a room with place for all that is in it */
RoomScene
makeVariousRoom(std::uint64_t seed);

/** \brief What a depth sensor with the noise of SensorOptions sees of \a scene from a
 *  drawn number of positions.
 *  \return exactly \a points points, as scanRoom() */
LabelledScan
scanVariousRoom(const RoomScene& scene, std::size_t points, std::uint64_t seed);

/** \brief The seed of a room of a set: the first rooms are the same however many
 *  there are.
 *  \param[in] random_seed of the set
 *  \param[in] number of the room, from 0 */
std::uint64_t
seedOfRoom(std::uint64_t random_seed, unsigned number);

} // namespace pcl_cid::test
