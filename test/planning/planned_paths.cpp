/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The paths that a planner finds on a map, between the same places on each.
 */

#include "planned_paths.h"

#include "base/random.h"

#include <algorithm>
#include <ctime>

namespace planning {
namespace {

double
lengthOf(const Places& path)
{
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length += (path[i] - path[i - 1]).norm();
  return length;
}

double
processorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

} // namespace

std::vector<Task>
drawTasks(const FreeSpace& space, std::size_t count)
{
  const Places places = connectedPlaces(space, 2.0 * radius, step);
  if (places.size() < 2)
    return {};
  pcl_cid::RandomGenerator generator;
  std::vector<Task> tasks;
  while (tasks.size() < count) {
    const std::size_t start = pcl_cid::drawBelow(generator, places.size());
    const std::size_t goal = pcl_cid::drawBelow(generator, places.size());
    if (start != goal)
      tasks.push_back({places[start], places[goal]});
  }
  return tasks;
}

std::size_t
PlannedPaths::found() const
{
  return lengths.size() -
         static_cast<std::size_t>(std::count(lengths.begin(), lengths.end(), 0.0));
}

PlannedPaths
planAll(const FreeSpace& space, const std::vector<Task>& tasks)
{
  PlannedPaths planned;
  const double before = processorSeconds();
  for (const Task& task : tasks) {
    const bool has_free_ends = space.isFree(task.start) && space.isFree(task.goal);
    planned.lengths.push_back(has_free_ends ? lengthOf(plan(space, task)) : 0.0);
  }
  planned.seconds = processorSeconds() - before;
  return planned;
}

double
lengthRatio(const PlannedPaths& planned, const PlannedPaths& other)
{
  double sum = 0.0;
  double sum_of_other = 0.0;
  for (std::size_t i = 0; i < planned.lengths.size(); ++i)
    if (planned.lengths[i] > 0.0 && other.lengths[i] > 0.0) {
      sum += planned.lengths[i];
      sum_of_other += other.lengths[i];
    }
  return sum / sum_of_other;
}

} // namespace planning
