/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls as convex shapes of FCL, which MoveIt and OMPL users check collisions with.
 */

#include "exported_scene.h"

#include <memory>

#include <fcl/fcl.h>
#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

/** The hull about the scene's origin; invalid ones are refused by FCL. */
fcl::Convexd
convexOf(const ConvexPart& part, const Eigen::Vector3d& origin)
{
  const auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const Eigen::Vector3d& vertex : part.hull.vertices)
    vertices->push_back(vertex - origin);
  const auto faces = std::make_shared<std::vector<int>>();
  for (const auto& triangle : part.hull.triangles) {
    faces->push_back(3);
    faces->insert(faces->end(), triangle.begin(), triangle.end());
  }
  constexpr bool throw_if_invalid = true;
  return fcl::Convexd(
      vertices, static_cast<int>(part.hull.triangles.size()), faces, throw_if_invalid);
}

/** By libccd, FCL's default. */
bool
collides(const fcl::Convexd& convex, const Eigen::Vector3d& centre, double radius)
{
  const fcl::Sphered sphere(radius);
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  pose.translation() = centre;
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  return fcl::collide(
             &convex, fcl::Transform3d::Identity(), &sphere, pose, request, result) > 0;
}

TEST(FCL, HitsInsideAHullAndMissesOutside)
{
  for (const PartScene& scene : scenesToExport()) {
    SCOPED_TRACE(scene.name);
    const Eigen::Vector3d origin = sceneOrigin(scene.parts);
    for (const ConvexPart& part : scene.parts) {
      const fcl::Convexd convex = convexOf(part, origin);
      const Eigen::Vector3d middle = middleOf(part.hull) - origin;
      const double radius = 0.2 * part.thickness;
      EXPECT_TRUE(collides(convex, middle, radius));
      for (const auto& [a, b, c] : part.hull.triangles) {
        const auto& v = part.hull.vertices;
        const Eigen::Vector3d centre = (v[a] + v[b] + v[c]) / 3.0 - origin;
        const Eigen::Vector3d normal = (v[b] - v[a]).cross(v[c] - v[a]).normalized();
        EXPECT_TRUE(collides(convex, centre - 0.5 * radius * normal, radius));
        EXPECT_TRUE(collides(convex, centre + 0.5 * radius * normal, radius));
        EXPECT_FALSE(collides(convex, centre + 2.0 * radius * normal, radius));
      }
    }
  }
}

TEST(FCL, MeasuresTheVolumeThatWeReport)
{
  for (const PartScene& scene : scenesToExport()) {
    SCOPED_TRACE(scene.name);
    for (const ConvexPart& part : scene.parts)
      EXPECT_NEAR(convexOf(part, middleOf(part.hull)).computeVolume(),
                  part.volume,
                  1e-6 * part.volume);
  }
}

} // namespace
} // namespace pcl_cid::test
