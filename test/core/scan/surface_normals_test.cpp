/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * pcl_cid: Concavity-Induced Distance for point clouds
 * Copyright (c) 2026, pcl_cid contributors
 *
 * Normals of the surface, without orientation.
 */

#include "clouds.h"
#include "prepared_points.h"

#include "scan/surface_normals.h"

#include <cmath>

#include <gtest/gtest.h>

#include <Eigen/SVD>

namespace pcl_cid::test {
namespace {

std::vector<Eigen::Vector3f>
normalsOf(const Points& points, unsigned int threads = 1)
{
  const ExecutionOptions execution = onThreads(threads);
  return surfaceNormals(
      points, NearestNeighbors(points, execution, NearestNeighbors::most), execution);
}

/** The last right singular vector of the centered points, and how clear it is. */
struct LiteralNormal {
  Eigen::Vector3d direction;
  Eigen::Vector3d spread; ///< largest first

  LiteralNormal(const Points& points, const NearestNeighbors& neighbors, std::size_t i)
  {
    Eigen::MatrixXd rows(1 + neighbors.count(), 3);
    rows.row(0) = points[i].cast<double>();
    for (std::size_t k = 0; k < neighbors.count(); ++k)
      rows.row(static_cast<Eigen::Index>(k + 1)) =
          points[static_cast<std::size_t>(neighbors.neighbor(i, k))].cast<double>();
    rows.rowwise() -= rows.colwise().mean().eval();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullV);
    direction = svd.matrixV().col(2);
    spread = svd.singularValues();
  }
};

TEST(SurfaceNormals, AreThoseOfASingularValueDecomposition)
{
  for (const NamedPoints& cloud : randomClouds()) {
    SCOPED_TRACE(cloud.name);
    const Points& points = cloud.points;
    const NearestNeighbors neighbors(points, onThreads(1), NearestNeighbors::most);
    const auto normals = normalsOf(points);
    std::size_t clear = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const LiteralNormal literal(points, neighbors, i);
      ASSERT_NEAR(normals[i].norm(), 1.0f, 1e-6f) << i;
      if (literal.spread[2] > 0.9 * literal.spread[1])
        continue; // any direction in between is as good
      ++clear;
      EXPECT_NEAR(std::abs(literal.direction.dot(normals[i].cast<double>())), 1.0, 1e-4)
          << i;
    }
    EXPECT_GT(clear, points.size() / 3);
  }
}

TEST(SurfaceNormals, OfAPlaneAreItsOwn)
{
  Points plane;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      plane.emplace_back(
          0.1f * static_cast<float>(i), 2.0f, 0.1f * static_cast<float>(j));
  for (const Eigen::Vector3f& normal : normalsOf(plane))
    EXPECT_NEAR(normal.y(), 1.0f, 1e-6f);
}

TEST(SurfaceNormals, AreNoneWherePointsSpanNoPlane)
{
  Points line;
  for (int i = 0; i < 30; ++i)
    line.emplace_back(0.3f * static_cast<float>(i), 0.1f * static_cast<float>(i), 1.0f);
  for (const Points& points : {line,
                               Points{Eigen::Vector3f(1.0f, 2.0f, 3.0f)},
                               Points(20, Eigen::Vector3f(1.0f, 2.0f, 3.0f))})
    for (const Eigen::Vector3f& normal : normalsOf(points))
      EXPECT_EQ(normal, Eigen::Vector3f::Zero());
}

TEST(SurfaceNormals, AreTheSameForDuplicatesAndAnyNumberOfThreads)
{
  Points points = twoBoxes(700, 5);
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(Eigen::Vector3f(points[i]));
  const auto normals = normalsOf(points);
  for (std::size_t i = 0; i < count; ++i)
    EXPECT_EQ(normals[i], normals[i + count]);
  for (const unsigned int threads : {2u, 3u, 8u})
    EXPECT_EQ(normalsOf(points, threads), normals);
}

} // namespace
} // namespace pcl_cid::test
