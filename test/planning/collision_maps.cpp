/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls against a triangle map and an octree of the same scan: time, memory, errors,
 * and the paths that a planner finds on them.
 */

#include "other_maps.h"
#include "planned_paths.h"
#include "portable_draw.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include <malloc.h>
#include <pcl/console/print.h>
#include <pcl/kdtree/kdtree_flann.h>

namespace {

using namespace planning;

constexpr double cell = 0.05; // of the octree, metres
constexpr int rounds = 5;     // the fastest counts: other programs only slow it down

/** What the command line asks for. */
struct Request {
  std::string scan;
  std::vector<int> numbers_of_parts;
  std::size_t spheres = 10000;
  std::size_t pairs = 50;
  bool has_one_view = false;
  std::size_t every = 1; ///< of the points, so many-th alone
};

/** \throws std::logic_error when the words are no request */
Request
requestOf(const std::vector<std::string>& words)
{
  Request request;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--spheres")
      request.spheres = std::stoul(words.at(++i));
    else if (words[i] == "--pairs")
      request.pairs = std::stoul(words.at(++i));
    else if (words[i] == "--every")
      request.every = std::max(1ul, std::stoul(words.at(++i)));
    else if (words[i] == "--one-view")
      request.has_one_view = true;
    else if (request.scan.empty())
      request.scan = words[i];
    else
      request.numbers_of_parts.push_back(std::stoi(words[i]));
  }
  if (request.numbers_of_parts.empty())
    throw std::invalid_argument("a scan and numbers of parts are needed");
  return request;
}

Cloud::Ptr
loadScan(const Request& request)
{
  const Cloud::ConstPtr all = loadFinitePoints(request.scan);
  auto scan = pcl::make_shared<Cloud>();
  for (std::size_t i = 0; i < all->size(); i += request.every)
    scan->push_back((*all)[i]);
  return scan;
}

/** How far places are from the points of a scan. */
class PointDistance {
public:
  explicit PointDistance(const Cloud::ConstPtr& scan) { tree_.setInputCloud(scan); }

  double
  of(const Place& place) const
  {
    pcl::PointXYZ center;
    center.getVector3fMap() = place.cast<float>();
    pcl::Indices index(1);
    std::vector<float> distance2(1);
    tree_.nearestKSearch(center, 1, index, distance2);
    return std::sqrt(double{distance2[0]});
  }

private:
  pcl::KdTreeFLANN<pcl::PointXYZ> tree_;
};

/** A sphere's center, and its distance to the nearest point of the scan. */
struct Query {
  Eigen::Vector3d center;
  double distance;
};

/** What all maps are asked. */
struct Questions {
  Eigen::AlignedBox3d box;
  std::function<bool(const Place&)> is_seen;
  double tolerance; ///< how far a point may stand out of its hull, for every map
  std::vector<Query> queries;
  std::vector<Task> tasks;

  /** Where a robot can be, if a map says what its sphere touches. */
  FreeSpace
  spaceOf(std::function<bool(const Place&)> touches) const
  {
    return {box, [this, touches = std::move(touches)](const Place& place) {
              return is_seen(place) && !touches(place);
            }};
  }
};

/** Uniform in the part of the box that was seen. */
std::vector<Query>
drawQueries(const Questions& questions,
            const PointDistance& distance,
            std::size_t count)
{
  pcl_cid::RandomGenerator generator;
  std::vector<Query> queries;
  while (queries.size() < count) {
    Place place;
    for (int axis = 0; axis < 3; ++axis)
      place[axis] = pcl_cid::test::drawWithin(
          generator, {questions.box.min()[axis], questions.box.max()[axis]});
    if (questions.is_seen(place))
      queries.push_back({place, distance.of(place)});
  }
  return queries;
}

/** Bytes that the program has asked for and not given back. */
std::size_t
heapInUse()
{
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/** What a map costs and how often it is wrong. */
struct Figures {
  std::string map;
  std::size_t bytes = 0;
  double microseconds = 0.0; ///< of a query
  std::size_t missed = 0;    ///< a point is within the sphere, and the map says free
  std::size_t false_alarms = 0;
  PlannedPaths planned;
};

void
measureQueries(const CollisionMap& map, const Questions& questions, Figures& figures)
{
  const std::vector<Query>& queries = questions.queries;
  std::vector<char> touched(queries.size());
  figures.microseconds = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < queries.size(); ++i)
      touched[i] = map.touches(queries[i].center, radius);
    const std::chrono::duration<double, std::micro> spent =
        std::chrono::steady_clock::now() - start;
    figures.microseconds = std::min(
        figures.microseconds, spent.count() / static_cast<double>(queries.size()));
  }
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const double beyond = queries[i].distance - radius;
    figures.missed += !touched[i] && beyond < -questions.tolerance;
    figures.false_alarms += touched[i] && beyond > questions.tolerance;
  }
}

Figures
measure(const std::string& name,
        const std::function<std::vector<Shape>()>& makeShapes,
        const Questions& questions)
{
  Figures figures;
  figures.map = name;
  const std::size_t before = heapInUse();
  const auto map = std::make_unique<CollisionMap>(makeShapes());
  figures.bytes = heapInUse() - before;
  measureQueries(*map, questions, figures);
  const FreeSpace space = questions.spaceOf(
      [&map](const Place& place) { return map->touches(place, checked_radius); });
  figures.planned = planAll(space, questions.tasks);
  return figures;
}

std::vector<Figures>
measureHulls(const Cloud::ConstPtr& scan,
             const Request& request,
             const Questions& questions)
{
  using pcl_cid::MergingRule;
  std::vector<Figures> rows;
  for (const MergingRule merging : {MergingRule::cid, MergingRule::hull})
    for (const int number_of_parts : request.numbers_of_parts) {
      const HullOptions options{number_of_parts, merging, radius, request.has_one_view};
      const std::vector<pcl_cid::ConvexPart> parts = hullsOf(scan, options);
      const char* const rule = merging == MergingRule::cid ? "cid" : "hull";
      rows.push_back(measure(
          std::to_string(parts.size()) + " hulls, " + rule,
          [&parts] { return shapesOf(parts); },
          questions));
    }
  return rows;
}

std::vector<Figures>
measureOthers(const Cloud::ConstPtr& scan, const Questions& questions)
{
  const std::vector<pcl::Vertices> triangles = triangulate(scan);
  return {measure(
              std::to_string(triangles.size()) + " triangles",
              [&] { return std::vector<Shape>{triangleShape(*scan, triangles)}; },
              questions),
          measure(
              "octree of 5 cm",
              [&] { return std::vector<Shape>{octreeShape(*scan, cell)}; },
              questions)};
}

void
printCollisions(const std::vector<Figures>& maps, std::size_t queries)
{
  std::printf("| map | microseconds a query | KiB | missed | false alarms |\n");
  std::printf("|---|---|---|---|---|\n");
  for (const Figures& figures : maps)
    std::printf("| %s | %.1f | %.0f | %zu | %.1f %% |\n",
                figures.map.c_str(),
                figures.microseconds,
                static_cast<double>(figures.bytes) / 1024.0,
                figures.missed,
                100.0 * static_cast<double>(figures.false_alarms) /
                    static_cast<double>(queries));
}

void
printPaths(const std::vector<Figures>& maps, const PlannedPaths& on_points)
{
  std::printf(
      "| map | paths found of %zu | their length, of that on the points | s |\n",
      on_points.lengths.size());
  std::printf("|---|---|---|---|\n");
  const auto print = [&](const std::string& map, const PlannedPaths& planned) {
    std::printf("| %s | %zu | %.2f | %.1f |\n",
                map.c_str(),
                planned.found(),
                lengthRatio(planned, on_points),
                planned.seconds);
  };
  for (const Figures& figures : maps)
    print(figures.map, figures.planned);
  print("the points themselves", on_points);
}

/** \return whether the hulls missed nothing */
bool
compare(const Request& request)
{
  const Cloud::ConstPtr scan = loadScan(request);
  const PointDistance distance(scan);
  const View view(*scan);
  Questions questions;
  questions.box = boxOf(*scan);
  questions.is_seen = [&](const Place& place) {
    return !request.has_one_view || view.saw(place);
  };
  questions.tolerance = pcl_cid::hull_tolerance * questions.box.diagonal().norm();
  questions.queries = drawQueries(questions, distance, request.spheres);
  const FreeSpace truth = questions.spaceOf(
      [&](const Place& place) { return distance.of(place) < checked_radius; });
  questions.tasks = drawTasks(truth, request.pairs);

  std::vector<Figures> maps = measureHulls(scan, request, questions);
  const bool missed_none = std::all_of(
      maps.begin(), maps.end(), [](const Figures& hulls) { return hulls.missed == 0; });
  for (Figures& other : measureOthers(scan, questions))
    maps.push_back(std::move(other));
  std::printf("%zu points, %zu spheres of %g m\n\n",
              scan->size(),
              questions.queries.size(),
              radius);
  printCollisions(maps, questions.queries.size());
  std::printf("\n");
  printPaths(maps, planAll(truth, questions.tasks));
  return missed_none;
}

} // namespace

int
main(int argc, char** argv)
{
  Request request;
  try {
    request = requestOf({argv + 1, argv + argc});
  }
  catch (const std::logic_error&) {
    std::cerr
        << "Usage: cid_collision_maps SCAN.pcd PARTS... [--spheres N] [--pairs N] "
           "[--one-view] [--every N]\n";
    return 2;
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR); // the triangulation warns
  drawTheSameEachTime();
  try {
    if (compare(request))
      return 0;
    std::cerr << request.scan << ": the hulls missed a collision\n";
  }
  catch (const std::exception& error) {
    std::cerr << request.scan << ": " << error.what() << '\n';
  }
  return 1;
}
