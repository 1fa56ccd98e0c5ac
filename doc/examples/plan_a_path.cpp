/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A way for a sphere through a scan: pcl_cid's hulls, FCL, and OMPL's RRTConnect.
 */

#include "collision_map.h"
#include "free_places.h"
#include "scan_hulls.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using planning::Cloud;
using planning::Place;
using planning::Places;

/** The robot, metres. */
constexpr double radius = 0.15;

/** More parts usually leave more of the free space free, and take longer to look at. */
constexpr int number_of_parts = 60;

/** A path is checked at places that are at most so far apart, metres. */
constexpr double step = 0.02;

/** No place of a path is farther than half a step from one that was checked. So a
 *  larger sphere that is free there means that the robot is free in between, too. */
constexpr double checked_radius = radius + 0.5 * step;

/** Seconds after which the planner gives up. */
constexpr double patience = 10.0;

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

/** The places where a path turns, the ends included; empty when none was found. */
Places
plan(const planning::FreeSpace& space, const planning::Task& task)
{
  ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
  ompl::RNG::setSeed(1); // the same path each time
  og::SimpleSetup setup(spaceIn(space.box));
  setup.setStateValidityChecker(
      [&space](const ob::State* state) { return space.isFree(placeOf(state)); });
  setup.getSpaceInformation()->setStateValidityCheckingResolution(
      step / setup.getStateSpace()->getMaximumExtent());
  setup.setPlanner(std::make_shared<og::RRTConnect>(setup.getSpaceInformation()));
  setup.setStartAndGoalStates(stateOf(task.start, setup.getStateSpace()),
                              stateOf(task.goal, setup.getStateSpace()));
  if (setup.solve(patience) != ob::PlannerStatus::EXACT_SOLUTION)
    return {};
  setup.simplifySolution();
  Places path;
  for (const ob::State* state : setup.getSolutionPath().getStates())
    path.push_back(placeOf(state));
  return path;
}

double
distanceToSegment(const Place& point, const Place& from, const Place& to)
{
  const Eigen::Vector3d along = to - from;
  const double length2 = along.squaredNorm();
  const double share =
      length2 > 0.0 ? std::clamp((point - from).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (point - from - share * along).norm();
}

/** How near the path comes to any point of the scan: exact, and without the hulls. */
double
clearanceOf(const Places& path, const Cloud& scan)
{
  double clearance = std::numeric_limits<double>::infinity();
  for (const pcl::PointXYZ& point : scan)
    for (std::size_t i = 1; i < path.size(); ++i)
      clearance =
          std::min(clearance,
                   distanceToSegment(
                       point.getVector3fMap().cast<double>(), path[i - 1], path[i]));
  return clearance;
}

/** What the command line asks for. */
struct Order {
  std::string scan;
  /** The scan is what one camera saw from the origin: stay where it saw. */
  bool one_view = false;
  /** Start and goal; empty: the program chooses. */
  std::vector<double> ends;
};

/** \throws std::invalid_argument */
Order
orderOf(const std::vector<std::string>& words)
{
  Order order;
  for (const std::string& word : words) {
    if (order.scan.empty())
      order.scan = word;
    else if (word == "--one-view")
      order.one_view = true;
    else
      order.ends.push_back(std::stod(word));
  }
  if (order.scan.empty() || (!order.ends.empty() && order.ends.size() != 6))
    throw std::invalid_argument("a scan, and no or six coordinates are expected");
  return order;
}

planning::Task
taskOf(const Order& order, const planning::FreeSpace& space)
{
  if (order.ends.empty())
    return planning::chooseTask(space, 2.0 * radius, step);
  const planning::Task task{Place(order.ends.data()), Place(order.ends.data() + 3)};
  for (const Place& end : {task.start, task.goal})
    if (!space.box.contains(end) || !space.isFree(end))
      throw std::runtime_error("start or goal is not free");
  return task;
}

/** The path goes to the standard output, one place a line; remarks go beside it. */
void
planAPath(const Order& order)
{
  const Cloud::ConstPtr scan = planning::loadFinitePoints(order.scan);
  const std::vector<pcl_cid::ConvexPart> parts =
      planning::hullsOf(scan, number_of_parts);
  const planning::CollisionMap map(planning::shapesOf(parts));
  std::clog << parts.size() << " hulls of " << scan->size() << " points\n";

  const planning::View view(*scan);
  const auto is_free = [&](const Place& place) {
    return (!order.one_view || view.saw(place)) && !map.touches(place, checked_radius);
  };
  const planning::FreeSpace space{planning::boxOf(*scan), is_free};
  const Places path = plan(space, taskOf(order, space));
  if (path.empty())
    throw std::runtime_error("no path was found");

  const double clearance = clearanceOf(path, *scan);
  std::clog << "The path comes to within " << clearance << " metres of a point.\n";
  if (clearance < radius - planning::toleranceOf(parts))
    throw std::runtime_error("the path is too near to a point");
  std::cout << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (const Place& place : path)
    std::cout << place.x() << ' ' << place.y() << ' ' << place.z() << '\n';
}

} // namespace

int
main(int argc, char** argv)
{
  Order order;
  try {
    order = orderOf({argv + 1, argv + argc});
  }
  catch (const std::logic_error&) {
    std::cerr << "Usage: plan_a_path SCAN.pcd [--one-view] [X Y Z X Y Z]\n";
    return 2;
  }
  try {
    planAPath(order);
  }
  catch (const std::exception& error) {
    std::cerr << order.scan << ": " << error.what() << '\n';
    return 1;
  }
  return 0;
}
