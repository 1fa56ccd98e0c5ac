/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The robot, and a way for it by OMPL's RRTConnect.
 */

#pragma once

#include "free_places.h"

namespace planning {

/** \brief The robot is a sphere of this radius, metres. */
inline constexpr double radius = 0.15;

/** \brief A path is checked at places that are at most so far apart, metres. */
inline constexpr double step = 0.02;

/** \brief No place of a path is farther than half a step from one that was checked. So
 * a larger sphere that is free there means that the robot is free in between, too. */
inline constexpr double checked_radius = radius + 0.5 * step;

/** \brief Let OMPL draw the same samples in each run of the program: call it once,
 *  before the first plan(). */
void
drawTheSameEachTime();

/** \brief A path, shortened.
 *  \param[in] task its start and goal must be free
 *  \return the places where it turns, the ends included; empty when none was found */
Places
plan(const FreeSpace& space, const Task& task);

} // namespace planning
