/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Convex parts for the tests of files: a room, flat, thin and tiny parts, far away
 * ones.
 */

#include "part_scenes.h"

#include "clouds.h"
#include "even_sampler.h"
#include "room_scene.h"

#include <pcl_cid/cid_convex_abstraction.h>

#include <numeric>

namespace pcl_cid::test {
namespace {

/** Points from one place to another, both included. */
Points
line(const Eigen::Vector3f& from, const Eigen::Vector3f& to, int steps)
{
  Points points;
  for (int i = 0; i <= steps; ++i)
    points.push_back(from +
                     (to - from) * static_cast<float>(i) / static_cast<float>(steps));
  return points;
}

} // namespace

Eigen::Vector3d
utmOffset()
{
  return {524288.25, 4194304.75, 100.5};
}

PartScene
partsOf(const std::string& name,
        const std::vector<Points>& clouds,
        const Eigen::Vector3d& offset)
{
  PartScene scene;
  scene.name = name;
  Points all;
  std::vector<int> part;
  for (std::size_t i = 0; i < clouds.size(); ++i)
    for (const Eigen::Vector3f& point : clouds[i]) {
      all.push_back(point);
      scene.points.push_back(point.cast<double>() + offset);
      part.push_back(static_cast<int>(i));
    }
  pcl::Indices indices(all.size());
  std::iota(indices.begin(), indices.end(), 0);
  PointSet set(all, indices);
  set.frame.origin += offset;
  scene.parts = makeConvexParts(set, part, {}, {});
  return scene;
}

Points
plate(float x, float y, float z, float width, float depth)
{
  constexpr int steps = 10;
  Points points;
  for (const Eigen::Vector3f& start : line({x - 0.5f * width, y - 0.5f * depth, z},
                                           {x - 0.5f * width, y + 0.5f * depth, z},
                                           steps)) {
    const Points row = line(start, start + Eigen::Vector3f(width, 0, 0), steps);
    points.insert(points.end(), row.begin(), row.end());
  }
  return points;
}

PartScene
thinParts(const Eigen::Vector3d& offset)
{
  Points tilted = plate(-1.0f, 0.0f, 0.0f, 0.5f, 0.5f);
  for (Eigen::Vector3f& point : tilted)
    point.z() = 1.0f + 0.3f * point.x() - 0.7f * point.y();
  const Points box = randomCube(200, 7);
  const Eigen::Vector3f place(1.5f, 1.5f, 0.25f);
  return partsOf(offset.isZero() ? "thin_parts" : "thin_parts_far_away",
                 {plate(0.0f, 0.0f, 0.0f, 5.0f, 4.0f),
                  plate(0.0f, 0.0f, 0.75f, 1.2f, 0.8f),
                  line({1.0f, -1.0f, 0.3f}, {1.5f, -1.5f, 1.3f}, 10),
                  {place + Eigen::Vector3f(0.0f, 0.0f, 2.0f)},
                  Points(5, place + Eigen::Vector3f(-3.0f, 0.0f, 1.0f)),
                  tilted,
                  box},
                 offset);
}

PartScene
roomParts()
{
  RoomOptions options;
  options.tables = 1;
  options.chairs = 2;
  options.clutter = 2;
  const LabelledScan scan = sampleRoomEvenly(makeRoom(options), 4000, 3);
  CIDConvexAbstraction<pcl::PointXYZ> abstraction;
  abstraction.setInputCloud(toCloud(scan.points));
  abstraction.setNumberOfSeeds(30);
  abstraction.setNumberOfParts(15);
  abstraction.setStopAtCut(true);
  PartScene scene;
  scene.name = "room";
  for (const Eigen::Vector3f& point : scan.points)
    scene.points.push_back(point.cast<double>());
  abstraction.reconstruct(scene.parts);
  return scene;
}

std::vector<PartScene>
partScenes()
{
  return {roomParts(), thinParts(Eigen::Vector3d::Zero()), thinParts(utmOffset())};
}

} // namespace pcl_cid::test
