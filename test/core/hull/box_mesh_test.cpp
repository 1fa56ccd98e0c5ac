/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * The body that stands in for a hull is one, and contains the points.
 */

#include "hull/box_mesh.h"
#include "hulls.h"

#include <pcl_cid/core/hull_guarantees.h>

#include <gtest/gtest.h>

namespace pcl_cid::test {
namespace {

TEST(BoxMesh, HoldsTheGuaranteesOfAHull)
{
  for (const NamedPoints& cloud : randomClouds())
    for (const std::size_t most : {0u, 4u, 7u, 8u, 100u}) {
      const std::vector<Eigen::Vector3d> points = inDouble(cloud.points);
      const PrincipalBox box = principalBox(points);
      ConvexPartOptions options;
      options.max_vertices = most;
      options.min_thickness = box.extents.minCoeff();
      const auto broken = findBrokenGuarantee(boxMesh(box, most), points, options);
      EXPECT_FALSE(broken) << cloud.name << " " << most << ": " << *broken;
    }
}

TEST(BoxMesh, IsTheBoxWhereItMayHaveEightVertices)
{
  const PrincipalBox box = principalBox(inDouble(randomCube(100, 81)));
  for (const std::size_t most : {0u, 8u, 9u}) {
    EXPECT_EQ(boxMesh(box, most).vertices.size(), 8u);
    for (const Eigen::Vector3d& v : boxMesh(box, most).vertices)
      EXPECT_TRUE(box.toLocal(v).cwiseAbs().isApprox(0.5 * box.extents));
  }
  EXPECT_EQ(boxMesh(box, 7).vertices.size(), 4u);
}

} // namespace
} // namespace pcl_cid::test
