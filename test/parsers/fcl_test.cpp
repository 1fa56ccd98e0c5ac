/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls as convex shapes of FCL, which MoveIt and OMPL users check collisions with.
 */

#include "collision_map.h"
#include "exported_scene.h"

#include <pcl_cid/io/mesh_export.h>

#include <fcl/fcl.h>
#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** The hull of a part about an origin near it. */
planning::Shape
shapeAbout(const Eigen::Vector3d& origin, const ConvexPart& part)
{
  std::vector<ConvexPart> moved{part};
  moveToFile(Frame{-origin}, moved);
  return planning::shapeOf(moved[0].hull);
}

/** By libccd, FCL's default. */
bool
collides(const planning::Shape& convex, const Eigen::Vector3d& center, double radius)
{
  const fcl::Sphered sphere(radius);
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  pose.translation() = center;
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  return fcl::collide(convex.get(),
                      fcl::Transform3d::Identity(),
                      &sphere,
                      pose,
                      request,
                      result) > 0;
}

TEST(FCL, HitsInsideAHullAndMissesOutside)
{
  for (const PartScene& scene : scenesToExport()) {
    SCOPED_TRACE(scene.name);
    const Eigen::Vector3d origin = sceneOrigin(scene.parts);
    for (const ConvexPart& part : scene.parts) {
      const planning::Shape convex = shapeAbout(origin, part);
      const Eigen::Vector3d middle = middleOf(part.hull) - origin;
      const double radius = 0.2 * part.thickness;
      EXPECT_TRUE(collides(convex, middle, radius));
      for (const auto& [a, b, c] : part.hull.triangles) {
        const auto& v = part.hull.vertices;
        const Eigen::Vector3d center = (v[a] + v[b] + v[c]) / 3.0 - origin;
        const Eigen::Vector3d normal = (v[b] - v[a]).cross(v[c] - v[a]).normalized();
        EXPECT_TRUE(collides(convex, center - 0.5 * radius * normal, radius));
        EXPECT_TRUE(collides(convex, center + 0.5 * radius * normal, radius));
        EXPECT_FALSE(collides(convex, center + 2.0 * radius * normal, radius));
      }
    }
  }
}

TEST(FCL, MeasuresTheVolumeThatWeReport)
{
  for (const PartScene& scene : scenesToExport()) {
    SCOPED_TRACE(scene.name);
    for (const ConvexPart& part : scene.parts)
      EXPECT_NEAR(shapeAbout(middleOf(part.hull), part)->computeVolume(),
                  part.volume,
                  1e-6 * part.volume);
  }
}

} // namespace
} // namespace pcl_cid::test
