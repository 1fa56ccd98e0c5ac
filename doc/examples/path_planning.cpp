/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The robot, and a way for it by OMPL's RRTConnect.
 */

#include "path_planning.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

namespace planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

/** Samples after which the planner gives up. It does not go by a clock: a busy machine
 *  finds the same paths. */
constexpr unsigned int patience = 20000;

Place
placeOf(const ob::State* state)
{
  return Place(state->as<ob::RealVectorStateSpace::StateType>()->values);
}

ob::ScopedState<ob::RealVectorStateSpace>
stateOf(const Place& place, const ob::StateSpacePtr& space)
{
  ob::ScopedState<ob::RealVectorStateSpace> state(space);
  for (unsigned int axis = 0; axis < 3; ++axis)
    state[axis] = place[axis];
  return state;
}

ob::StateSpacePtr
spaceIn(const Eigen::AlignedBox3d& box)
{
  ob::RealVectorBounds bounds(3);
  for (unsigned int axis = 0; axis < 3; ++axis) {
    bounds.setLow(axis, box.min()[axis]);
    bounds.setHigh(axis, box.max()[axis]);
  }
  const auto space = std::make_shared<ob::RealVectorStateSpace>(3);
  space->setBounds(bounds);
  return space;
}

} // namespace

void
drawTheSameEachTime()
{
  ompl::RNG::setSeed(1);
}

Places
plan(const FreeSpace& space, const Task& task)
{
  ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
  og::SimpleSetup setup(spaceIn(space.box));
  setup.setStateValidityChecker(
      [&space](const ob::State* state) { return space.isFree(placeOf(state)); });
  setup.getSpaceInformation()->setStateValidityCheckingResolution(
      step / setup.getStateSpace()->getMaximumExtent());
  setup.setPlanner(std::make_shared<og::RRTConnect>(setup.getSpaceInformation()));
  setup.setStartAndGoalStates(stateOf(task.start, setup.getStateSpace()),
                              stateOf(task.goal, setup.getStateSpace()));
  ob::IterationTerminationCondition enough(patience);
  if (setup.solve(enough) != ob::PlannerStatus::EXACT_SOLUTION)
    return {};
  setup.simplifySolution();
  Places path;
  for (const ob::State* state : setup.getSolutionPath().getStates())
    path.push_back(placeOf(state));
  return path;
}

} // namespace planning
