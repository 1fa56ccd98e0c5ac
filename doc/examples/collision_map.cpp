/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Shapes that a sphere must not touch, held by FCL.
 */

#include "collision_map.h"

namespace planning {

Shape
shapeOf(const pcl_cid::TriangleMesh& hull)
{
  const auto vertices = std::make_shared<std::vector<fcl::Vector3d>>(hull.vertices);
  const auto faces = std::make_shared<std::vector<int>>();
  faces->reserve(4 * hull.triangles.size());
  for (const auto& triangle : hull.triangles) {
    faces->push_back(3); // how many vertices follow
    faces->insert(faces->end(), triangle.begin(), triangle.end());
  }
  constexpr bool throw_if_invalid = true;
  return std::make_shared<fcl::Convexd>(
      vertices, static_cast<int>(hull.triangles.size()), faces, throw_if_invalid);
}

std::vector<Shape>
shapesOf(const std::vector<pcl_cid::ConvexPart>& parts)
{
  std::vector<Shape> shapes;
  shapes.reserve(parts.size());
  for (const pcl_cid::ConvexPart& part : parts)
    shapes.push_back(shapeOf(part.hull));
  return shapes;
}

CollisionMap::CollisionMap(const std::vector<Shape>& shapes)
{
  for (const Shape& shape : shapes) {
    objects_.push_back(std::make_unique<fcl::CollisionObjectd>(shape));
    tree_.registerObject(objects_.back().get());
  }
  tree_.setup();
}

bool
CollisionMap::touches(const Eigen::Vector3d& center, double radius) const
{
  fcl::CollisionObjectd sphere(std::make_shared<fcl::Sphered>(radius));
  sphere.setTranslation(center);
  sphere.computeAABB();
  fcl::DefaultCollisionData<double> answer;
  tree_.collide(&sphere, &answer, fcl::DefaultCollisionFunction<double>);
  return answer.result.isCollision();
}

} // namespace planning
