/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * One attempt at a furnished room.
 */

#pragma once

#include <optional>

#include "room_scene.h"

namespace pcl_cid::test {

/** \brief Draws shell, openings and furniture one by one.
 *  \param[in] options checked already
 *  \param[in,out] generator where all draws come from
 *  \return the room, or nothing when some piece found no free place */
std::optional<RoomScene>
drawLayout(const RoomOptions& options, RandomGenerator& generator);

/** \brief The first room drawn that has place for what is in it.
 *  \param[in] draw_options what the rooms may be like
 *  \param[in,out] generator where all draws come from
 *  \param[in] seed of the generator, for the complaint
 *  \throw CIDException when a hundred rooms had no place */
RoomScene
drawRoom(RoomOptions (*draw_options)(RandomGenerator&),
         RandomGenerator& generator,
         std::uint64_t seed);

} // namespace pcl_cid::test
