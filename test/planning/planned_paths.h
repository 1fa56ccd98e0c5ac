/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The paths that a planner finds on a map, between the same places on each.
 */

#pragma once

#include "path_planning.h"

#include <cstddef>
#include <vector>

namespace planning {

/** \brief Starts and goals between which there is a path: drawn among the places of a
 *  grid that free ways connect.
 *  \return the same for the same space; none when fewer than two places are free */
std::vector<Task>
drawTasks(const FreeSpace& space, std::size_t count);

/** \brief How planning on a map went. */
struct PlannedPaths {
  /** Of the path of each task, metres; 0 where none was found, be it that the map
   *  refuses the start or the goal. */
  std::vector<double> lengths;
  double seconds = 0.0; ///< of a processor, for all tasks

  std::size_t
  found() const;
};

/** \brief Plan all tasks on a map. */
PlannedPaths
planAll(const FreeSpace& space, const std::vector<Task>& tasks);

/** \brief How long the paths on a map are for each metre of those on another one: over
 *  the tasks that have a path on both. Not a number without any. */
double
lengthRatio(const PlannedPaths& planned, const PlannedPaths& other);

} // namespace planning
