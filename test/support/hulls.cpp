/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Hulls for tests: made in one call, and held to what they promise.
 */

#include "hulls.h"

#include "base/random.h"
#include "prepared_points.h"

#include <pcl_cid/core/grouping.h>
#include <pcl_cid/core/hull_guarantees.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace pcl_cid::test {
namespace {

pcl::Indices
countTo(std::size_t count)
{
  pcl::Indices indices(count);
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

/** 0 to 1. */
double
uniformInDouble(RandomGenerator& generator)
{
  constexpr std::uint64_t steps = 1u << 24;
  return static_cast<double>(drawBelow(generator, steps)) / static_cast<double>(steps);
}

Eigen::Vector3d
uniformVectorInDouble(RandomGenerator& generator)
{
  const double x = uniformInDouble(generator);
  const double y = uniformInDouble(generator);
  const double z = uniformInDouble(generator);
  return {x, y, z};
}

/** How far a cloud of size 1 reaches along an axis: not at all, a bit, or fully. */
double
randomExtent(RandomGenerator& generator)
{
  const double kind = uniformInDouble(generator);
  if (kind < 0.3)
    return 0.0;
  return kind < 0.7 ? std::pow(10.0, -7.0 * uniformInDouble(generator)) : 1.0;
}

Eigen::Quaterniond
randomRotation(RandomGenerator& generator)
{
  const Eigen::Vector3d axis =
      uniformVectorInDouble(generator) - Eigen::Vector3d::Constant(0.5);
  const bool turned = uniformInDouble(generator) < 0.7;
  return turned ? Eigen::Quaterniond(
                      Eigen::AngleAxisd(axis.norm() * 6.0, axis.normalized()))
                : Eigen::Quaterniond::Identity();
}

} // namespace

PointSet
pointSet(const Points& points)
{
  return PointSet(points, countTo(points.size()));
}

ConvexPart
partOf(const Points& points, const ConvexPartOptions& options)
{
  const PointSet set = pointSet(points);
  return makeConvexPart(set, countTo(set.size()), options);
}

std::vector<Eigen::Vector3d>
inDouble(const Points& points)
{
  std::vector<Eigen::Vector3d> result;
  for (const Eigen::Vector3f& p : points)
    result.push_back(p.cast<double>());
  return result;
}

std::size_t
trianglesOf(const std::vector<ConvexPart>& parts)
{
  std::size_t triangles = 0;
  for (const ConvexPart& part : parts)
    triangles += part.hull.triangles.size();
  return triangles;
}

double
diagonalOf(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points)
    box.extend(p);
  return box.diagonal().norm();
}

double
excess(const TriangleMesh& hull, const Eigen::Vector3d& p)
{
  double most = -INFINITY;
  for (const auto& [a, b, c] : hull.triangles) {
    const Eigen::Vector3d& origin = hull.vertices[a];
    const Eigen::Vector3d normal =
        (hull.vertices[b] - origin).cross(hull.vertices[c] - origin).normalized();
    most = std::max(most, normal.dot(p - origin));
  }
  return most;
}

double
excess(const HullPrimitive& primitive, const Eigen::Vector3d& place)
{
  const Eigen::Vector3d axis = primitive.axes.col(2);
  const Eigen::Vector3d from_center = place - primitive.center;
  const double along = axis.dot(from_center);
  const double off = (from_center - along * axis).norm();
  const double radius = 0.5 * primitive.extents.x();
  const double half = 0.5 * primitive.extents.z();
  switch (primitive.kind) {
  case HullPrimitive::Kind::sphere:
    return from_center.norm() - radius;
  case HullPrimitive::Kind::cylinder:
    return std::max(off - radius, std::abs(along) - half);
  case HullPrimitive::Kind::capsule:
    return (from_center - std::clamp(along, radius - half, half - radius) * axis)
               .norm() -
           radius;
  default:
    return ((primitive.axes.transpose() * from_center).cwiseAbs() -
            0.5 * primitive.extents)
        .maxCoeff();
  }
}

void
expectGuarantees(const ConvexPart& part,
                 const Points& points,
                 const ConvexPartOptions& options,
                 const std::string& what)
{
  std::vector<Eigen::Vector3d> contained;
  for (const pcl::index_t index : part.indices)
    contained.push_back(points[static_cast<std::size_t>(index)].cast<double>());
  const auto broken = findBrokenGuarantee(part.hull, contained, options);
  EXPECT_FALSE(broken) << what << ": " << *broken;
  EXPECT_FALSE(part.boxed) << what;
  EXPECT_GT(part.volume, 0.0) << what;
  EXPECT_GE(part.thickness, options.min_thickness * (1.0 - hull_tolerance)) << what;
  // A ball of radius r, w / (2 sqrt 3) <= r <= w / 2 for a least width w (Steinhagen),
  // fits in, and A r / 3 <= V <= A r for an area A.
  const double flat_volume = part.area * part.thickness / 2.0;
  EXPECT_LE(part.volume, flat_volume * (1.0 + 1e-9)) << what;
  EXPECT_GE(part.volume, flat_volume / (3.0 * std::sqrt(3.0)) * (1.0 - 1e-9)) << what;
}

Points
randomSmallCloud(std::uint64_t seed)
{
  RandomGenerator generator(seed);
  const std::size_t count = 1 + drawBelow(generator, 60);
  const double scale = std::pow(10.0, -3.0 + 6.0 * uniformInDouble(generator));
  Eigen::Vector3d extents;
  for (double& extent : extents)
    extent = scale * randomExtent(generator);
  const Eigen::Quaterniond rotation = randomRotation(generator);
  const bool is_far = uniformInDouble(generator) < 0.5;
  const double offset =
      is_far ? scale * std::pow(10.0, 4.0 * uniformInDouble(generator)) : 0.0;
  const bool on_grid = uniformInDouble(generator) < 0.25;
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Vector3d p = uniformVectorInDouble(generator);
    if (on_grid)
      p = (3.0 * p).array().round() / 3.0;
    p = rotation * p.cwiseProduct(extents) + Eigen::Vector3d::Constant(offset);
    points.push_back(p.cast<float>());
  }
  return points;
}

std::vector<int>
groupsOf(const Points& points, std::size_t groups)
{
  Grouping grouping(prepared(points));
  grouping.propose(groups);
  const std::vector<pcl::index_t> group = grouping.groups();
  return {group.begin(), group.end()};
}

} // namespace pcl_cid::test
