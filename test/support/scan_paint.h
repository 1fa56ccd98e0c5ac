/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The colors of a scan: materials under lamps.
 */

#pragma once

#include "colored_room.h"
#include "labelled_scan.h"

namespace pcl_cid::test {

/** \brief How bright a surface is: at least this share of its material's color, where
 *  no lamp reaches it, and at most all of it. Shadows are not cast. */
constexpr double least_light = 0.5;

/** \brief Gives each point of \a scan the color that its place has in \a room: what the
 *  material is there, brighter towards a lamp and near to it.
 *  \param[in] room that the scan is of
 *  \param[in,out] scan points without noise; its colors are set */
void
paintScan(const ColoredRoom& room, LabelledScan& scan);

} // namespace pcl_cid::test
