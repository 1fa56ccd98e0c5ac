/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls against a triangle map and an octree of the same scan: time, memory, errors.
 */

#include "other_maps.h"
#include "portable_draw.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <string>

#include <malloc.h>
#include <pcl/console/print.h>
#include <pcl/kdtree/kdtree_flann.h>

namespace {

using namespace planning;

constexpr double radius = 0.15; // of the spheres, metres
constexpr double cell = 0.05;   // of the octree, metres
constexpr int rounds = 5;       // the fastest counts: other programs only slow it down

/** A sphere's center, and its distance to the nearest point of the scan. */
struct Query {
  Eigen::Vector3d center;
  double distance;
};

/** Uniform in the box around the scan. */
std::vector<Query>
drawQueries(const Cloud::ConstPtr& scan, std::size_t count)
{
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(scan);
  const Eigen::AlignedBox3d box = boxOf(*scan);
  pcl_cid::RandomGenerator generator;
  std::vector<Query> queries(count);
  for (Query& query : queries) {
    for (int axis = 0; axis < 3; ++axis)
      query.center[axis] =
          pcl_cid::test::drawWithin(generator, {box.min()[axis], box.max()[axis]});
    pcl::PointXYZ center;
    center.getVector3fMap() = query.center.cast<float>();
    pcl::Indices index(1);
    std::vector<float> distance2(1);
    tree.nearestKSearch(center, 1, index, distance2);
    query.distance = std::sqrt(double{distance2[0]});
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
  std::size_t bytes = 0;
  double microseconds = 0.0; ///< of a query
  std::size_t missed = 0;    ///< a point is within the sphere, and the map says free
  std::size_t false_alarms = 0;
};

Figures
measure(const std::function<std::vector<Shape>()>& makeShapes,
        const std::vector<Query>& queries,
        double tolerance)
{
  Figures figures;
  const std::size_t before = heapInUse();
  const auto map = std::make_unique<CollisionMap>(makeShapes());
  figures.bytes = heapInUse() - before;

  std::vector<char> touched(queries.size());
  figures.microseconds = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < queries.size(); ++i)
      touched[i] = map->touches(queries[i].center, radius);
    const std::chrono::duration<double, std::micro> spent =
        std::chrono::steady_clock::now() - start;
    figures.microseconds = std::min(
        figures.microseconds, spent.count() / static_cast<double>(queries.size()));
  }

  for (std::size_t i = 0; i < queries.size(); ++i) {
    figures.missed += !touched[i] && queries[i].distance < radius - tolerance;
    figures.false_alarms += touched[i] && queries[i].distance > radius + tolerance;
  }
  return figures;
}

void
printRow(const std::string& map, const Figures& figures, std::size_t queries)
{
  std::printf("| %s | %.1f | %.0f | %zu | %.1f %% |\n",
              map.c_str(),
              figures.microseconds,
              static_cast<double>(figures.bytes) / 1024.0,
              figures.missed,
              100.0 * static_cast<double>(figures.false_alarms) /
                  static_cast<double>(queries));
}

/** \return whether the hulls missed nothing */
bool
compare(const std::string& path,
        std::size_t count,
        const std::vector<int>& numbers_of_parts)
{
  const Cloud::ConstPtr scan = loadFinitePoints(path);
  const std::vector<Query> queries = drawQueries(scan, count);
  const std::vector<pcl::Vertices> triangles = triangulate(scan);
  // How far a point may stand out of its hull; the same for every map.
  const double tolerance = pcl_cid::hull_tolerance * boxOf(*scan).diagonal().norm();

  std::printf("%zu spheres of %g m, %zu points\n\n", count, radius, scan->size());
  std::printf("| map | microseconds a query | KiB | missed | false alarms |\n");
  std::printf("|---|---|---|---|---|\n");
  bool missed_none = true;
  for (const int number_of_parts : numbers_of_parts) {
    const std::vector<pcl_cid::ConvexPart> parts = hullsOf(scan, number_of_parts);
    const Figures hulls = measure([&] { return shapesOf(parts); }, queries, tolerance);
    printRow(std::to_string(parts.size()) + " hulls", hulls, count);
    missed_none = missed_none && hulls.missed == 0;
  }
  printRow(std::to_string(triangles.size()) + " triangles",
           measure([&] { return std::vector<Shape>{triangleShape(*scan, triangles)}; },
                   queries,
                   tolerance),
           count);
  printRow("octree of 5 cm",
           measure([&] { return std::vector<Shape>{octreeShape(*scan, cell)}; },
                   queries,
                   tolerance),
           count);
  return missed_none;
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc < 4) {
    std::cerr << "Usage: cid_collision_maps SCAN.pcd QUERIES PARTS...\n";
    return 2;
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR); // the triangulation warns
  try {
    std::vector<int> numbers_of_parts;
    for (int i = 3; i < argc; ++i)
      numbers_of_parts.push_back(std::stoi(argv[i]));
    if (compare(argv[1], std::stoul(argv[2]), numbers_of_parts))
      return 0;
    std::cerr << argv[1] << ": the hulls missed a collision\n";
  }
  catch (const std::exception& error) {
    std::cerr << argv[1] << ": " << error.what() << '\n';
  }
  return 1;
}
