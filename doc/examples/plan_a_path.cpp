/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * A way for a sphere through a scan: pcl_cid's hulls, FCL, and OMPL's RRTConnect.
 */

#include "collision_map.h"
#include "path_planning.h"
#include "scan_hulls.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>

namespace {

using planning::Cloud;
using planning::Place;
using planning::Places;

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
  planning::HullOptions hulls;
  /** Start and goal; empty: the program chooses. */
  std::vector<double> ends;
};

/** \throws std::invalid_argument */
pcl_cid::MergingRule
mergingRuleOf(const std::string& name)
{
  if (name == "hull")
    return pcl_cid::MergingRule::hull;
  if (name == "cid")
    return pcl_cid::MergingRule::cid;
  throw std::invalid_argument("no merging rule is called " + name);
}

/** \throws std::logic_error when the words are no order */
Order
orderOf(const std::vector<std::string>& words)
{
  Order order;
  order.hulls.robot_radius = planning::radius;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--one-view")
      order.hulls.has_one_view = true;
    else if (words[i] == "--merging")
      order.hulls.merging = mergingRuleOf(words.at(++i));
    else if (words[i] == "--parts")
      order.hulls.number_of_parts = std::stoi(words.at(++i));
    else if (order.scan.empty())
      order.scan = words[i];
    else
      order.ends.push_back(std::stod(words[i]));
  }
  if (order.scan.empty() || (!order.ends.empty() && order.ends.size() != 6))
    throw std::invalid_argument("a scan, and no or six coordinates are expected");
  return order;
}

planning::Task
taskOf(const Order& order, const planning::FreeSpace& space)
{
  if (order.ends.empty())
    return planning::chooseTask(space, 2.0 * planning::radius, planning::step);
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
  const std::vector<pcl_cid::ConvexPart> parts = planning::hullsOf(scan, order.hulls);
  const planning::CollisionMap map(planning::shapesOf(parts));
  std::clog << parts.size() << " hulls of " << scan->size() << " points\n";

  const planning::View view(*scan);
  const auto is_free = [&](const Place& place) {
    return (!order.hulls.has_one_view || view.saw(place)) &&
           !map.touches(place, planning::checked_radius);
  };
  const planning::FreeSpace space{planning::boxOf(*scan), is_free};
  planning::drawTheSameEachTime();
  const Places path = planning::plan(space, taskOf(order, space));
  if (path.empty())
    throw std::runtime_error("no path was found");

  const double clearance = clearanceOf(path, *scan);
  std::clog << "The path comes to within " << clearance << " metres of a point.\n";
  if (clearance < planning::radius - planning::toleranceOf(parts))
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
    std::cerr
        << "Usage: plan_a_path SCAN.pcd [--one-view] [--merging hull|cid] [--parts N] "
           "[X Y Z X Y Z]\n";
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
